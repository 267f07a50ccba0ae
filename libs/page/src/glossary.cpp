#include "ariadne/page/glossary.h"

#include <fmt/format.h>

#include <cctype>
#include <iterator>

#include "ariadne/page/html.h"

namespace ariadne::page {
namespace {

struct Row {
  std::string_view word;
  std::string_view text;
};

constexpr Row kRows[] = {
#include "glossary_rows.h"
};

/// Words of figures' names and of headings, and the terms that they name.
constexpr Row kWords[] = {
    {"arm", "arm"},
    {"ate", "ATE"},
    {"rpe", "RPE"},
    {"neff", "Neff"},
    {"relations", "relations error"},
    {"updates", "update"},
    {"particles", "particle"},
    {"closings", "closing"},
    {"recoveries", "recovery"},
    {"recovered", "recovery"},
    {"survivors", "survivors"},
    {"coalescence", "coalescence"},
};

std::string_view textOf(const Row* begin, const Row* end, std::string_view word) {
  for (const Row* row = begin; row != end; ++row)
    if (row->word == word) return row->text;
  return {};
}

}  // namespace

std::string_view meaningOf(std::string_view term) {
  return textOf(std::begin(kRows), std::end(kRows), term);
}

std::string explained(const std::string& text) {
  std::string word;
  for (const char c : text + " ") {
    if (std::isalpha(static_cast<unsigned char>(c)) != 0) {
      word += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      continue;
    }
    const auto term = textOf(std::begin(kWords), std::end(kWords), word);
    if (const auto meaning = meaningOf(term); !meaning.empty())
      return fmt::format("<span class=\"term\" title=\"{}\">{}</span>", escapedHtml(meaning),
                         escapedHtml(text));
    word.clear();
  }
  return escapedHtml(text);
}

}  // namespace ariadne::page
