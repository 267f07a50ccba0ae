// What --require asks of a comparison.
#pragma once
#include <string>
#include <vector>

namespace ariadne::compare_app {

/// A figure, <, <=, > or >=, and its bound.
struct Requirement {
  std::string text;  ///< as given
  std::string name;
  std::string relation;
  double bound = 0;

  /// False for nan.
  bool metBy(double value) const;
};

/// Blanks may stand about the relation. Throws core::UsageError for anything that is no
/// requirement and for a name that is not among `names`; it then gives the nearest, or says that
/// the name is one of `with_references` and wants --truth or --relations.
Requirement parseRequirement(const std::string& text, const std::vector<std::string>& names,
                             const std::vector<std::string>& with_references);

}  // namespace ariadne::compare_app
