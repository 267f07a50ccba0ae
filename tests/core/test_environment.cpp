#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace fs = std::filesystem;

// cmake/AriadneLibrary.cmake gives them to every test; only the first one arrived for a long time.
TEST(TestEnvironment, EveryVariableArrives) {
  for (const char* name : {"ARIADNE_SOURCE_DIR", "ARIADNE_BIN_DIR", "LSAN_OPTIONS", "TSAN_OPTIONS"})
    ASSERT_TRUE(std::getenv(name)) << name;
  EXPECT_TRUE(fs::exists(fs::path(std::getenv("ARIADNE_SOURCE_DIR")) / "CMakePresets.json"));
  EXPECT_TRUE(fs::equivalent(std::getenv("ARIADNE_BIN_DIR"),
                             fs::read_symlink("/proc/self/exe").parent_path()));
  for (const char* name : {"LSAN_OPTIONS", "TSAN_OPTIONS"}) {
    const std::string options = std::getenv(name);
    const std::string prefix = "suppressions=";
    ASSERT_EQ(options.substr(0, prefix.size()), prefix) << name;
    EXPECT_TRUE(fs::is_regular_file(options.substr(prefix.size()))) << options;
  }
}
