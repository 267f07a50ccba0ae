// report.html: a replay as one page that needs no other file and no network.
#pragma once
#include <filesystem>
#include <string>

#include "ariadne/report/replay.h"

namespace ariadne::report {

/// Size that a page keeps under where keyframes are what makes it large, bytes.
constexpr std::size_t kLargestReport = 9'500'000;

/// The page. Any text is shown literally, whatever is in it; bytes that are no UTF-8 are replaced.
/// Panels for which there is no data are absent. Every other keyframe is left out until the page is
/// under `largest` bytes or only one keyframe is left.
std::string reportHtml(const Replay& replay, std::size_t largest = kLargestReport);

/// Writes it whole or not at all. Throws core::Error naming the file.
void writeReport(const std::filesystem::path& file, const Replay& replay);

}  // namespace ariadne::report
