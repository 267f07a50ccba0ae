// One table of fields a parameter struct: it loads, saves, explains and validates.
//
// A struct P names its fields once:
//   template <class Visitor> void visitFields(Visitor& v, P& p) {
//     v.number("beta", p.beta, {0, 1}, "resample when Neff < beta N");
//     v.choice("proposal", p.proposal, {{"odometry", Proposal::odometry}, ...}, "...");
//   }
// and every reader and writer is a visitor with the members number (double, int, std::uint64_t),
// flag (bool), text (std::string) and choice (enum).
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "ariadne/core/error.h"

namespace ariadne::core {

/// Closed interval of the values a number may take.
struct Bounds {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

/// Names of an enumeration's values, in the order that help shows them.
template <class Enum>
using Choices = std::vector<std::pair<std::string, Enum>>;

/// "0 to 1", "0 or more", "any number".
std::string describe(const Bounds& bounds);

/// Throws UsageError naming section, key, value and bounds when a field is out of them.
class ValidatingVisitor {
 public:
  /// @param section named in errors
  explicit ValidatingVisitor(std::string section) : section_(std::move(section)) {}

  /// A number: throws UsageError naming section, key and bounds when it lies outside or is nan.
  template <class T>
  void number(const char* key, T& value, const Bounds& bounds, const char*) {
    const double v = static_cast<double>(value);
    if (!(v >= bounds.min && v <= bounds.max))
      throw UsageError(fmt::format("[{}] {} = {} is out of bounds: it takes {}", section_, key,
                                   value, describe(bounds)));
  }
  /// Nothing to check.
  void flag(const char*, bool&, const char*) {}
  /// Nothing to check.
  void text(const char*, std::string&, const char*) {}
  /// Nothing to check.
  template <class Enum>
  void choice(const char*, Enum&, const Choices<Enum>&, const char*) {}

 private:
  std::string section_;
};

/// Validates a parameter struct; `section` is what an error calls it.
template <class Params>
void validateFields(Params params, const std::string& section) {
  ValidatingVisitor visitor(section);
  visitFields(visitor, params);
}

}  // namespace ariadne::core
