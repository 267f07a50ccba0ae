// A file that was compressed with zstd as a whole, for readers that jump about in it.
#pragma once
#include "ariadne/io/scratch_folder.h"

namespace ariadne::io::ros {

class UnpackedFile {
 public:
  /// Unpacks into the folder for temporary files ($TMPDIR); gone with this, though who has it open
  /// may go on. Throws BagDamage when the data are damaged or grow to over 1000 times their size,
  /// core::Error when there is no room.
  explicit UnpackedFile(const std::filesystem::path& packed);
  std::filesystem::path path() const { return folder_.path() / "unpacked"; }

 private:
  static void unpack(const std::filesystem::path& packed, int file);
  ScratchFolder folder_;
};

}  // namespace ariadne::io::ros
