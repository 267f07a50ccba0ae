// What is shipped for ariadne-slam is what its parameters' tables say.
#include <cstdlib>

#include "slam_app_fixture.h"

namespace fs = std::filesystem;
using ariadne::io::readWhole;

class Shipped : public SlamApp {
 protected:
  fs::path source = std::getenv("ARIADNE_SOURCE_DIR") ? std::getenv("ARIADNE_SOURCE_DIR") : ".";
};

/// The lines of an INI that are no comment; [dataset] file differs from log to log.
std::string settings(const std::string& ini) {
  std::istringstream in(ini);
  std::string out;
  for (std::string line; std::getline(in, line);) {
    line.erase(line.find_last_not_of(' ') + 1);
    if (!line.empty() && line[0] != '#' && line.rfind("file =", 0) != 0) out += line + "\n";
  }
  return out;
}

TEST_F(Shipped, InisNameEveryKeyWithItsDefault) {
  ASSERT_EQ(run({"/dev/null", "--print-config"}), 0) << err;
  const std::string defaults = settings(out);
  std::size_t found = 0;
  for (const auto& file : fs::directory_iterator(source / "ini/slam")) {
    EXPECT_EQ(run({file.path().string(), "--print-config"}), 0) << err;
    EXPECT_EQ(settings(readWhole(file.path())), defaults)
        << file.path() << ": renew it with scripts/renew-parameters";
    ++found;
  }
  EXPECT_GE(found, 2U);
}

TEST_F(Shipped, ParametersPageIsUpToDate) {
  ASSERT_EQ(run({"--print-parameters"}), 0);
  EXPECT_EQ(readWhole(source / "doc/reference/parameters.md"), out)
      << "renew it with scripts/renew-parameters";
}
