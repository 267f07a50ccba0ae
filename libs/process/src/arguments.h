// Arguments as execv takes them.
#pragma once
#include <string>
#include <vector>

namespace ariadne::process {

/// They point into `argv`.
inline std::vector<char*> pointersTo(const std::vector<std::string>& argv) {
  std::vector<char*> pointers;
  pointers.reserve(argv.size() + 1);
  for (const std::string& a : argv) pointers.push_back(const_cast<char*>(a.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace ariadne::process
