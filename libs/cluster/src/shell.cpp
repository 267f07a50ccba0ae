#include "ariadne/cluster/shell.h"

namespace ariadne::cluster {

std::string shellWord(const std::string& word) {
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

}  // namespace ariadne::cluster
