// A file that was compressed with zstd as a whole, for readers that jump about in it.
#pragma once
#include <filesystem>

namespace ariadne::io::ros {

class UnpackedFile {
 public:
  /// Unpacks into the folder for temporary files ($TMPDIR). Throws BagDamage when the data are
  /// damaged or grow to over 1000 times their size, core::Error when there is no room.
  explicit UnpackedFile(const std::filesystem::path& packed);
  /// Takes the file's name away; who has it open may go on.
  ~UnpackedFile();
  UnpackedFile(const UnpackedFile&) = delete;
  UnpackedFile& operator=(const UnpackedFile&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  void unpack(const std::filesystem::path& packed, int file);
  std::filesystem::path path_;
};

}  // namespace ariadne::io::ros
