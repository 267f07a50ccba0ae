#include "requirement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"

namespace ariadne::compare_app {
namespace {

bool isAmong(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

bool Requirement::metBy(double value) const {
  if (relation == "<") return value < bound;
  if (relation == "<=") return value <= bound;
  if (relation == ">") return value > bound;
  return value >= bound;
}

Requirement parseRequirement(const std::string& text, const std::vector<std::string>& names,
                             const std::vector<std::string>& with_references) {
  static const std::regex form(R"(\s*(\w+)\s*(<=|>=|<|>)\s*(\S+)\s*)");
  std::smatch part;
  Requirement r{text, "", "", 0};
  char* end = nullptr;
  // std::regex recurses by the character: a long text would take the stack.
  const bool fits = text.size() < 1000 && std::regex_match(text, part, form);
  const std::string number = fits ? part[3].str() : "";
  if (fits) r.bound = std::strtod(number.c_str(), &end);
  if (!fits || *end != '\0' || !std::isfinite(r.bound))
    throw core::UsageError(fmt::format(
        "--require \"{}\": a requirement is NAME<NUMBER, with <, <=, > or >=, as cpu_ratio<0.1",
        core::printable(text)));
  r.name = part[1];
  r.relation = part[2];
  if (isAmong(names, r.name)) return r;
  if (isAmong(with_references, r.name))
    throw core::UsageError(
        fmt::format("--require \"{}\": {} needs {}", core::printable(text), r.name,
                    r.name.find("relations") == r.name.npos ? "--truth" : "--relations"));
  throw core::UsageError(fmt::format("--require \"{}\": no figure {}; the nearest is {}",
                                     core::printable(text), r.name,
                                     core::nearestName(r.name, names)));
}

}  // namespace ariadne::compare_app
