// Maps the log of tests/packages/try-programs by the installed library.
#include <iostream>

#include "ariadne/io/dataset.h"
#include "ariadne/slam/mapper.h"

int main() {
  const auto log = ariadne::io::openDataset("explored/drive.rawlog", {});
  ariadne::slam::Mapper mapper({}, 1);
  while (auto step = log->next()) mapper.process(*step);
  std::cout << "  " << mapper.updates() << " updates\n";
  return mapper.updates() > 0 ? 0 : 1;
}
