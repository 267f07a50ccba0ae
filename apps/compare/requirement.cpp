#include "requirement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"
#include "ariadne/core/numbers.h"

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
  // std::regex recurses by the character: a long text would take the stack.
  const bool fits = text.size() < 1000 && std::regex_match(text, part, form);
  const auto bound = fits ? core::parseNumber(part[3].str()) : std::nullopt;
  if (!bound || !std::isfinite(*bound))
    throw core::UsageError(fmt::format(
        "--require \"{}\": a requirement is NAME<NUMBER, with <, <=, > or >=, as cpu_ratio<0.1",
        core::printable(text)));
  r.bound = *bound;
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
