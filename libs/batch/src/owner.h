// The names that owners of claims go by.
#pragma once
#include <string>

namespace ariadne::batch {

/// When a process of this machine was started, in ticks since boot (proc(5), field 22); empty when
/// there is none. Tells it from a later one with the same number.
std::string startOf(const std::string& pid);

/// Of "machine-pid-start"; empty when the name is none.
struct OwnerParts {
  std::string host, pid, start;
};
OwnerParts partsOf(const std::string& owner);

}  // namespace ariadne::batch
