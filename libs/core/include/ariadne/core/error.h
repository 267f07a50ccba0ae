// What can go wrong for a user. Thrown anywhere, caught once in an app's main.
#pragma once
#include <stdexcept>
#include <string>

namespace ariadne::core {

/// The run failed: bad data, a full disk, an unreadable file. Exit code 1.
/// The message names the file (and line, or section and key) and says what would be right.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The program was called wrongly: unknown option or key, value out of bounds. Exit code 2.
struct UsageError : Error {
  using Error::Error;
};

}  // namespace ariadne::core
