// INIs that include others.
#include <fmt/format.h>

#include <algorithm>

#include "ariadne/core/error.h"
#include "ariadne/io/ini_text.h"

namespace ariadne::io {
namespace {

namespace fs = std::filesystem;

constexpr int kDeepest = 8;  // a chain that is longer goes in a circle

/// `own` behind `base`, whose settings of the same keys go.
IniDocument over(IniDocument base, IniDocument own) {
  const auto replaced = [&](const IniEntry& e) {
    return std::any_of(own.entries.begin(), own.entries.end(),
                       [&](const IniEntry& o) { return o.section == e.section && o.key == e.key; });
  };
  auto& entries = base.entries;
  entries.erase(std::remove_if(entries.begin(), entries.end(), replaced), entries.end());
  entries.insert(entries.end(), own.entries.begin(), own.entries.end());
  base.sections.insert(base.sections.end(), own.sections.begin(), own.sections.end());
  base.name = own.name;
  return base;
}

IniDocument parsed(std::string_view text, const fs::path& file, int depth) {
  IniDocument own = parseIni(text, file.string(), IniDialect::strict);
  if (own.include.empty()) return own;
  if (depth == kDeepest)
    throw core::UsageError(
        fmt::format("{}: include = {}: more than {} INIs in a chain: does it go "
                    "in a circle?",
                    own.include_where, own.include, kDeepest));
  const fs::path other = (file.parent_path() / own.include).lexically_normal();
  std::string other_text;
  try {
    other_text = readIniText(other);
  } catch (const core::Error& e) {
    throw core::UsageError(
        fmt::format("{}: include = {}: {}", own.include_where, own.include, e.what()));
  }
  return over(parsed(other_text, other, depth + 1), std::move(own));
}

}  // namespace

IniDocument parseIniFile(std::string_view text, const fs::path& file) {
  return parsed(text, file, 0);
}

}  // namespace ariadne::io
