// Records of ROS 1 recordings: a header of named fields, then data.
#pragma once
#include <functional>

#include "ros1_bag.h"

namespace ariadne::io::ros {

/// Reads the header and the size of what follows it; `in` is then at the data.
Ros1Record readRos1Record(Bytes& in);

/// Calls `take(name, value)` for each field of a header, or of the data of a connection's record.
/// Throws BagDamage.
using TakeField = std::function<void(std::string_view name, std::string_view value)>;
void forEachRos1Field(std::string_view header, const TakeField& take);

}  // namespace ariadne::io::ros
