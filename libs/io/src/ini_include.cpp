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

std::string textOf(const fs::path& file, const IniInclude& by) {
  try {
    return readIniText(file);
  } catch (const core::Error& e) {
    throw core::UsageError(fmt::format("{}: include = {}: {}", by.where, by.file, e.what()));
  }
}

IniDocument parsed(std::string_view text, const fs::path& file, int depth) {
  IniDocument own = parseIni(text, file.string(), IniDialect::strict);
  IniDocument base;
  for (const IniInclude& include : own.includes) {
    if (depth == kDeepest)
      throw core::UsageError(
          fmt::format("{}: include = {}: more than {} INIs in a chain: does it go "
                      "in a circle?",
                      include.where, include.file, kDeepest));
    const fs::path other = (file.parent_path() / include.file).lexically_normal();
    base = over(std::move(base), parsed(textOf(other, include), other, depth + 1));
  }
  return over(std::move(base), std::move(own));
}

}  // namespace

IniDocument parseIniFile(std::string_view text, const fs::path& file) {
  return parsed(text, file, 0);
}

}  // namespace ariadne::io
