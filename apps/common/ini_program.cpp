#include "ini_program.h"

#include <fmt/format.h>

#include <algorithm>

#include "ariadne/core/error.h"
#include "ariadne/io/ini_text.h"
#include "ariadne/stock/stock_ini.h"

namespace ariadne::app {
namespace {

bool hasSectionOf(const io::IniDocument& ini, const std::string& family) {
  return std::any_of(ini.sections.begin(), ini.sections.end(),
                     [&](const auto& s) { return s.name.rfind(family + ".", 0) == 0; });
}

bool hasKey(const io::IniDocument& ini, const char* section, const char* key) {
  return std::any_of(ini.entries.begin(), ini.entries.end(),
                     [&](const auto& e) { return e.section == section && e.key == key; });
}

/// The program whose INI this is, with its subcommand; empty when the sections do not tell.
std::string programOf(const io::IniDocument& ini) {
  if (hasSectionOf(ini, "arm")) return "ariadne-experiment run";
  for (const char* key : {"world", "path", "log"})
    if (hasKey(ini, "experiment", key)) return "ariadne-loop-experiment";
  if (ini.hasSection("world") || ini.hasSection("explore")) return "ariadne-explore";
  if (ini.hasSection("dataset") || stock::isStockIni(ini)) return "ariadne-slam";
  return "";
}

}  // namespace

void expectIniOf(const std::string& program, const std::filesystem::path& file,
                 const std::string& text) {
  const std::string right = programOf(io::parseIni(text, file.string(), io::IniDialect::mrpt));
  if (right.empty() || right.substr(0, right.find(' ')) == program) return;
  throw core::UsageError(fmt::format("{} is an INI of {}: {} {}", file.string(),
                                     right.substr(0, right.find(' ')), right, file.string()));
}

}  // namespace ariadne::app
