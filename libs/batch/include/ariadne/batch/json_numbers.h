// Whole numbers of a JSON file that somebody may have changed.
#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <limits>

#include "ariadne/core/error.h"

namespace ariadne::batch {

/// What nlohmann's own conversion makes of a fraction, a negative or a larger number is undefined
/// or another number. Throws core::Error that calls the value `name`.
template <class T, class Json>
T wholeOf(const Json& value, const char* name) {
  if (!value.is_number_unsigned() ||
      value.template get<std::uint64_t>() > std::uint64_t{std::numeric_limits<T>::max()})
    throw core::Error(fmt::format("{} is {}, no whole number from 0 to {}", name, value.dump(),
                                  std::numeric_limits<T>::max()));
  return value.template get<T>();
}

}  // namespace ariadne::batch
