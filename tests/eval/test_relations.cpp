#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "ariadne/core/error.h"
#include "ariadne/core/random.h"
#include "ariadne/eval/relations.h"
#include "ariadne/geometry/pose.h"
#include "ariadne/io/relations.h"
#include "ariadne/io/tum.h"

namespace fs = std::filesystem;
using namespace ariadne;
using geometry::Relation;

namespace {

class RelationsFile : public ::testing::Test {
 protected:
  void TearDown() override { fs::remove(file); }
  std::vector<Relation> read(const std::string& text) {
    std::ofstream(file, std::ios::binary) << text;
    return io::readRelations(file);
  }
  std::string complaint(const std::string& text) {
    try {
      read(text);
    } catch (const core::Error& e) {
      return e.what();
    }
    return "";
  }
  fs::path file = fs::temp_directory_path() / ("ariadne-relations-" + std::to_string(::getpid()));
};

fs::path datasets() {
  if (const char* folder = std::getenv("ARIADNE_DATASETS")) return folder;
  const char* source = std::getenv("ARIADNE_SOURCE_DIR");
  return fs::path(source ? source : ".") / "../shared/datasets";
}

}  // namespace

TEST(Relations, KnownErrorsAreFound) {
  const geometry::Trajectory path{{0, {5, 5, 1}}, {1, geometry::compose({5, 5, 1}, {2, 0.3, 0.1})}};
  const auto errors = eval::relationErrors(path, {{0, 1, {2, 0, 0}}, {0, 7, {1, 1, 1}}}, 0);
  ASSERT_EQ(errors.translation_m.size(), 1U);
  EXPECT_NEAR(errors.translation_m[0], 0.3, 1e-12);
  EXPECT_NEAR(errors.rotation_deg[0], 0.1 * 180 / M_PI, 1e-9);
  EXPECT_EQ(errors.unmatched, 1U);
}

TEST(Relations, ARigidMotionOfTheTrajectoryChangesNothing) {
  const std::vector<Relation> relations{{0, 2, {1, 0.2, 0.4}}, {2, 0, {-1, 0, 0}}};
  geometry::Trajectory path{{0, {0, 0, 0}}, {2, {1.1, 0.1, 0.5}}};
  const auto before = eval::relationErrors(path, relations, 0);
  for (auto& p : path) p.pose = geometry::compose({30, -2, 2}, p.pose);
  const auto after = eval::relationErrors(path, relations, 0);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_NEAR(before.translation_m[i], after.translation_m[i], 1e-9);
}

TEST_F(RelationsFile, ReadsLinesAndComments) {
  const auto relations = read("# head\n1 2 0.5 0.25 0 0 0 -1.5\r\n\n3 4 1 2 3 4 5 6");
  ASSERT_EQ(relations.size(), 2U);
  EXPECT_EQ(relations[0].motion.phi, -1.5);
  EXPECT_EQ(relations[1].time2_s, 4);
}

TEST_F(RelationsFile, NamesFileAndLineOfNonsense) {
  for (const char* text :
       {"1 2 3\n", "1 2 x 4 5 6 7 8\n", "1 2 nan 4 5 6 7 8\n", "1 2 inf 4 5 6 7 8"})
    EXPECT_NE(complaint(std::string("# c\n") + text).find(":2:"), std::string::npos) << text;
  EXPECT_NE(complaint("").find("no relation"), std::string::npos);
  EXPECT_THROW(io::readRelations("/nowhere"), core::Error);
}

TEST_F(RelationsFile, RandomBytesAreRefusedNotFatal) {
  core::RandomStream rng(3, 0, 0, core::Purpose::test);
  const std::string sound = "976052905.167 976052911.885 -0.05 -0.12 0 0 0 -1.68\n";
  for (int i = 0; i < 500; ++i) {
    std::string text = sound + sound + sound;
    for (int k = 0; k < 3; ++k) text[rng.bits() % text.size()] = static_cast<char>(rng.bits());
    if (i % 3 == 0) text.resize(rng.bits() % text.size());
    try {
      for (const auto& r : read(text)) EXPECT_TRUE(std::isfinite(r.motion.x));
    } catch (const core::Error&) {
    }
  }
}

// The 90 relations with stamps of the keyframes are small against the corrected log: the format and
// the convention are read right.
TEST(Relations, TheIntelTruthIsGood) {
  const fs::path folder = datasets() / "intel";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not here";
  const auto relations = io::readRelations(folder / "intel.relations.gz");
  EXPECT_EQ(relations.size(), 2984U);
  const auto errors = eval::relationErrors(io::readTum(folder / "truth.tum"), relations, 0.001);
  EXPECT_EQ(errors.translation_m.size(), 90U);
  EXPECT_LT(eval::figuresOf(errors.translation_m).mean, 0.10);
  EXPECT_LT(eval::figuresOf(errors.rotation_deg).mean, 3);
}
