// An option that takes one of some names.
#pragma once
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace ariadne::experiment_app {

/// Puts the name's number in its place; CLI11's own transformers take numbers too, and list them.
template <class T>
CLI::Validator oneOf(const std::map<std::string, T>& choices) {
  return {[choices](std::string& word) -> std::string {
            const auto found = choices.find(word);
            if (found != choices.end()) {
              word = std::to_string(static_cast<int>(found->second));
              return {};
            }
            std::vector<std::string> names;
            for (const auto& [name, value] : choices) names.push_back(name);
            return fmt::format("{}: takes one of {}", word, fmt::join(names, ", "));
          },
          ""};
}

}  // namespace ariadne::experiment_app
