#include "bag_files.h"

#include <fmt/format.h>

#include <algorithm>

#include "ariadne/core/error.h"
#include "bag_folder.h"
#include "bytes.h"
#include "open_bag.h"

namespace ariadne::io::ros {

namespace fs = std::filesystem;

bool looksLikeBag(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored) || path.filename() == kMetadataName ||
         formatOf(path) != BagFormat::none;
}

BagFiles::BagFiles(const fs::path& path) {
  for (const fs::path& file : filesOfBag(path, remarks_)) {
    files_.push_back({file, sizeOf(file)});
    bytes_total_ += files_.back().bytes;
  }
  try {
    OpenedBag opened = openBag(files_[0].path);
    reader_ = std::move(opened.reader);
    format_ = opened.format;
  } catch (const BagDamage& why) {
    throw core::Error(fmt::format("{}: {}", files_[0].path.string(), why.what()));
  }
}

std::optional<BagMessage> BagFiles::next() {
  while (at_ < files_.size()) {
    try {
      if (!broken_) {
        if (!reader_) reader_ = openBag(files_[at_].path).reader;
        if (const auto message = reader_->next()) return message;
        if (!reader_->remark().empty()) remarks_.push_back(placeOf("") + reader_->remark());
      }
      broken_ = false;
      reader_.reset();
      bytes_before_ += files_[at_++].bytes;
    } catch (const BagDamage& why) {
      breakOff(why);
    }
  }
  return std::nullopt;
}

std::optional<std::string_view> BagFiles::payload() {
  try {
    return reader_->payload();
  } catch (const BagDamage& why) {
    breakOff(why);
    return std::nullopt;
  }
}

/// With the file's name where there are several.
std::string BagFiles::placeOf(const std::string& where) const {
  if (files_.size() == 1) return where;
  const std::string name = files_[at_].path.filename().string();
  return where.empty() ? name + ": " : fmt::format("{} of {}", where, name);
}

void BagFiles::breakOff(const BagDamage& why) {
  broken_ = true;
  const std::string where = placeOf(reader_ ? reader_->place() : "the beginning");
  const std::string text = fmt::format("damaged at {}: {}", where, why.what());
  if (at_ + 1 < files_.size())
    remarks_.push_back(text + "; the rest of this file is lost, the next one goes on");
  else
    damage_ = text;
}

double BagFiles::fraction() const {
  if (at_ >= files_.size() || bytes_total_ == 0) return 1;
  const double here = reader_ ? reader_->fraction() * static_cast<double>(files_[at_].bytes) : 0;
  return std::min(1.0,
                  (static_cast<double>(bytes_before_) + here) / static_cast<double>(bytes_total_));
}

}  // namespace ariadne::io::ros
