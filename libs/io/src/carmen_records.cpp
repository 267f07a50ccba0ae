#include "carmen_records.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "text_fields.h"

namespace ariadne::io {

CarmenRecords::CarmenRecords(const std::filesystem::path& path, const DatasetOptions& options)
    : path_(path), lasers_(path, options.field_of_view_deg), file_(path) {}

/// Other messages are none of our business, but their kinds must not pile up.
void CarmenRecords::count(std::string_view kind) {
  kind = kind.substr(0, 32);
  const bool plain = std::isalpha(static_cast<unsigned char>(kind[0])) != 0 &&
                     std::all_of(kind.begin(), kind.end(), [](unsigned char c) {
                       return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
                     });
  const bool known = classes_.size() < 100 || classes_.count(std::string(kind)) > 0;
  ++classes_[plain && known ? std::string(kind) : "other lines"];
}

void CarmenRecords::countMalformed(const std::string& problem) {
  if (malformed_++ == 0)
    lasers_.remarks().push_back(
        fmt::format("{}:{}: {} (first malformed line)", path_.string(), line_number_, problem));
}

std::optional<LogRecord> CarmenRecords::takeScan() {
  std::string problem;
  auto scan = parseCarmenScan(words_, problem);
  if (!scan) {
    countMalformed(problem);
    return std::nullopt;
  }
  count(words_[0]);
  scans_began_ = true;
  if (!lasers_.isUsed(scan->record.scan->sensorLabel)) return std::nullopt;
  lasers_.complete(*scan);
  return std::move(scan->record);
}

std::optional<LogRecord> CarmenRecords::recordOf(CarmenLine kind) {
  if (kind == CarmenLine::scan || kind == CarmenLine::raw_scan) return takeScan();
  if (kind == CarmenLine::odometry && lasers_.needsOdometry()) {
    std::string problem;
    auto reading = parseCarmenOdometry(words_, problem);
    if (!reading) {
      countMalformed(problem);
      return std::nullopt;
    }
    count(words_[0]);
    return std::move(*reading);
  }
  count(words_[0]);
  if (kind == CarmenLine::param) lasers_.takeParam(words_, scans_began_);
  return std::nullopt;
}

std::optional<LogRecord> CarmenRecords::next() {
  std::string_view line;
  bool too_long = false;
  while (file_.line(line, too_long)) {
    ++line_number_;
    if (too_long) {
      countMalformed("over 1 MiB long");
      continue;
    }
    splitFields(line, words_);
    if (words_.empty() || words_[0][0] == '#') continue;
    if (auto record = recordOf(kindOf(words_))) return record;
  }
  return std::nullopt;
}

}  // namespace ariadne::io
