// The names that owners of claims go by.
#pragma once
#include <string>

namespace ariadne::batch {

/// Of "machine-pid-start"; empty when the name is none.
struct OwnerParts {
  std::string host, pid, start;
};
OwnerParts partsOf(const std::string& owner);

}  // namespace ariadne::batch
