#include "ariadne/core/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace ariadne::core {

bool equalIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

std::string printable(std::string_view text) {
  constexpr std::size_t kLength = 80;
  std::string out;
  for (unsigned char c : text) {
    if (out.size() >= kLength) return out + "...";
    if (c < 0x20 || c == 0x7f)
      out += fmt::format("\\x{:02x}", c);
    else
      out += static_cast<char>(c);
  }
  return out;
}

std::string nearestName(std::string_view name, const std::vector<std::string>& known) {
  name = name.substr(0, 200);
  std::string best;
  double least = 1e9;
  for (const std::string& candidate : known) {
    std::vector<double> row(candidate.size() + 1);
    for (std::size_t j = 0; j < row.size(); ++j) row[j] = static_cast<double>(j);
    for (std::size_t i = 0; i < name.size(); ++i) {
      double diagonal = row[0];
      row[0] = static_cast<double>(i + 1);
      for (std::size_t j = 0; j < candidate.size(); ++j) {
        const bool same_letter = equalIgnoringCase(name.substr(i, 1), candidate.substr(j, 1));
        const double swap = name[i] == candidate[j] ? 0 : same_letter ? 0.1 : 1;
        const double next = std::min({row[j] + 1, row[j + 1] + 1, diagonal + swap});
        diagonal = row[j + 1];
        row[j + 1] = next;
      }
    }
    if (row.back() < least) {
      least = row.back();
      best = candidate;
    }
  }
  return best;
}

}  // namespace ariadne::core
