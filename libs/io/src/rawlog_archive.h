// MRPT's object stream, read without believing it: MRPT's own CArchive resizes to whatever count
// the file claims (4 GB are touched before the data turn out missing), takes a short read for a
// whole one, and cannot pass over a class it does not know. Here every count has a bound, a missing
// byte is an error, and an object of no interest is passed over by looking for the next header.
#pragma once
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>

#include "input_file.h"

namespace ariadne::io {

/// The bytes are not what the format says; the message is the reason.
struct ArchiveDamage : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An object of a version that is newer than this decoder; its end is not known.
struct NewerVersion : ArchiveDamage {
  using ArchiveDamage::ArchiveDamage;
};

struct ObjectHeader {
  std::string name;         ///< today's, without namespace
  bool old_format = false;  ///< before MRPT 0.5.5: no end flag
  int version = 0;
};

class ArchiveReader {
 public:
  explicit ArchiveReader(InputFile& file) : file_(file) {}

  /// A number as it lies in the file (little-endian, as is every machine MRPT 2 runs on).
  template <class T>
  T number() {
    T value;
    std::memcpy(&value, bytes(sizeof(T)), sizeof(T));
    return value;
  }
  bool flag() { return number<std::uint8_t>() != 0; }
  /// The next `count` bytes, which are then passed; valid until the next call.
  const char* bytes(std::size_t count);
  /// A string, at most 64 KiB.
  std::string text();

  ObjectHeader header();
  /// The header of an object that must be of class `name`, of a known version.
  ObjectHeader header(const char* name);
  /// The flag that ends an object.
  void end(const ObjectHeader& object);

  /// Name of the class whose header comes next; empty at the end of the file or when there is none.
  std::string nextClass();
  bool atEnd() { return file_.peek(1).empty(); }
  /// What is before the next header of an entry (see skipToNextEntry), at most 4 MB of it.
  std::string_view beforeNextEntry();
  /// Goes to the next header of an observation, action, frame or collection; to the end of the
  /// file when there is none. End flags before it are passed as well.
  void skipToNextEntry();

 private:
  InputFile& file_;
};

/// Throws NewerVersion unless the version is one of rawlog_versions.h.
void requireVersion(const ObjectHeader& object);

/// Whether a file that begins like this is an object stream.
bool looksLikeArchive(std::string_view beginning);

}  // namespace ariadne::io
