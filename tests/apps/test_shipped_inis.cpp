// What is shipped for ariadne-slam is what its parameters' tables say.
#include <cstdlib>

#include "slam_app_fixture.h"

namespace fs = std::filesystem;
using ariadne::io::readWhole;

class Shipped : public SlamApp {
 protected:
  fs::path source = std::getenv("ARIADNE_SOURCE_DIR") ? std::getenv("ARIADNE_SOURCE_DIR") : ".";
};

TEST_F(Shipped, InisLoadAndNameEveryKey) {
  std::size_t found = 0;
  for (const auto& file : fs::directory_iterator(source / "ini/slam")) {
    ASSERT_EQ(run({file.path().string(), "--print-config"}), 0) << err;
    const std::string text = readWhole(file.path());
    std::istringstream config(out);
    for (std::string line; std::getline(config, line);) {
      if (line.empty() || line[0] == '#') continue;
      const std::string name = "\n" + line.substr(0, line.find('=')) + (line[0] == '[' ? "" : "=");
      EXPECT_NE(text.find(name), std::string::npos) << file.path() << " lacks " << line;
    }
    ++found;
  }
  EXPECT_GE(found, 2U);
}

TEST_F(Shipped, ParametersPageIsUpToDate) {
  ASSERT_EQ(run({"--print-parameters"}), 0);
  EXPECT_EQ(readWhole(source / "doc/parameters.md"), out)
      << "renew it: ariadne-slam --print-parameters > doc/parameters.md";
}
