// Errors that say what is wrong, where, and what would be right.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ariadne::test {

/// Expects `call` to throw an `Error` whose message has all `parts` in it.
template <class Error, class Call>
void expectError(Call call, const std::vector<std::string>& parts) {
  try {
    call();
    ADD_FAILURE() << "no error; expected one with \"" << parts.front() << '"';
  } catch (const Error& e) {
    for (const std::string& part : parts)
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos)
          << "\"" << part << "\" is not in: " << e.what();
  }
}

}  // namespace ariadne::test
