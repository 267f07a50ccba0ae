#include "ariadne/charts/gnuplot_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ariadne::charts {
namespace {

/// UTF-8's later bytes.
bool isInside(char c) { return (c & 0xC0) == 0x80; }

}  // namespace

std::size_t lettersOf(const std::string& text) {
  return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), isInside));
}

std::string shortened(const std::string& text) {
  constexpr std::size_t kMost = 36;
  if (lettersOf(text) <= kMost) return text;
  std::size_t letters = 0;
  std::size_t end = 0;
  while (letters < kMost || isInside(text[end]))
    if (!isInside(text[end++])) ++letters;
  return text.substr(0, end) + "…";
}

std::string inQuotes(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += '\'';
    out += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return out + "'";
}

std::string tick(const std::string& label, double at) {
  std::string text;  // in a label % begins a format
  for (const char c : shortened(label)) text += c == '%' ? "%%" : std::string(1, c);
  return fmt::format("{} {:.10g}", inQuotes(text), at);
}

const char* colourOf(std::size_t i) {
  constexpr std::array<const char*, 7> colours{"#0072B2", "#D55E00", "#009E73", "#CC79A7",
                                               "#E69F00", "#56B4E9", "#808080"};
  return colours[i % colours.size()];
}

}  // namespace ariadne::charts
