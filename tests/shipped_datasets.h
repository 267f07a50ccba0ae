// The folder datasets/ of the project: ctest says where the project is, else the current folder.
#pragma once
#include <cstdlib>
#include <filesystem>

namespace ariadne::test {

inline std::filesystem::path shippedDatasets() {
  const char* source = std::getenv("ARIADNE_SOURCE_DIR");
  return std::filesystem::path(source ? source : ".") / "datasets";
}

}  // namespace ariadne::test
