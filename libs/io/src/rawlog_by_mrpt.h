// Observations of versions that are newer than our decoder, by the installed MRPT's own class.
#pragma once
#include <mrpt/serialization/CSerializable.h>

#include <string_view>

#include "rawlog_archive.h"

namespace ariadne::io {

/// The version that the installed class of an object writes, the newest that it reads.
int writtenVersion(const mrpt::serialization::CSerializable& object);

/// Reads `out` from `body`, which begins after the object's header and may be longer than the
/// object. Returns the object's bytes, end flag included; 0 when the installed class does not know
/// the version, or these bytes are no such object.
///
/// MRPT's classes resize to whatever count they read, before they find the data missing: no stream
/// can bound that. So the bytes are read twice for trial, once with 0 and once with 1 in place of
/// each number that is larger than the body. A count among them would make these two differ in
/// length; where they do not, all counts are small, and the bytes are read as they are.
std::size_t readByMrpt(mrpt::serialization::CSerializable& out, const ObjectHeader& header,
                       std::string_view body);

}  // namespace ariadne::io
