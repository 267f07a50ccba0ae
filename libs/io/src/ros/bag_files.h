// A recording as the files that it consists of: one file, or a folder with metadata.yaml and
// several splits, one after the other.
#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "bag_reader.h"

namespace ariadne::io::ros {

/// Whether this is a recording of ROS: a folder, or a file that begins like one.
bool looksLikeBag(const std::filesystem::path& path);

class BagFiles {
 public:
  /// Throws core::Error when a file is missing or is no recording.
  explicit BagFiles(const std::filesystem::path& path);

  /// The next message, whose topic lives until the next call; nullopt at the end of the last file.
  /// Where a file is broken the next file goes on, and damage() says so.
  std::optional<BagMessage> next();
  /// Of the message that next() gave; nullopt where the file breaks within it.
  std::optional<std::string_view> payload();
  double fraction() const;
  const std::string& damage() const { return damage_; }
  const std::vector<std::string>& remarks() const { return remarks_; }
  /// "ROS 1 bag", "ROS 2 bag (SQLite)", "MCAP recording".
  const char* format() const { return format_; }

 private:
  struct File {
    std::filesystem::path path;
    std::uintmax_t bytes = 0;
  };
  std::string placeOf(const std::string& where) const;
  void breakOff(const BagDamage& why);

  std::vector<File> files_;
  std::size_t at_ = 0;  ///< index of the file that is read
  std::unique_ptr<BagReader> reader_;
  bool broken_ = false;  ///< the file that is read
  const char* format_ = "";
  std::uintmax_t bytes_total_ = 0;
  std::uintmax_t bytes_before_ = 0;
  std::string damage_;
  std::vector<std::string> remarks_;
};

}  // namespace ariadne::io::ros
