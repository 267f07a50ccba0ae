// Real logs against committed bounds. They were found over seeds 1 to 10 (doc/lab/benchmarks): the
// worst ATE of the ten is 0.106 m on CSAIL and 0.107 m on Intel; the bounds for one seed leave
// twice and half of that again.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "ariadne/eval/errors.h"
#include "ariadne/eval/relations.h"
#include "ariadne/io/dataset.h"
#include "ariadne/io/relations.h"
#include "ariadne/io/tum.h"
#include "ariadne/slam/mapper.h"

namespace fs = std::filesystem;
using namespace ariadne;

namespace {

fs::path datasets() {
  if (const char* folder = std::getenv("ARIADNE_DATASETS")) return folder;
  const char* source = std::getenv("ARIADNE_SOURCE_DIR");
  return fs::path(source ? source : ".") / "../shared/datasets";
}

geometry::Trajectory pathOf(const fs::path& log) {
  slam::Mapper mapper({}, 0);
  const auto source = io::openDataset(log);
  while (const auto step = source->next()) mapper.process(*step);
  return mapper.path();
}

double ateOf(const geometry::Trajectory& path, const fs::path& truth) {
  const auto pairs = eval::associate(path, io::readTum(truth), 1);
  return eval::figuresOf(eval::absoluteErrors(pairs, eval::align(pairs))).rmse;
}

}  // namespace

TEST(Datasets, MitCsail) {
  const fs::path folder = datasets() / "mit-csail";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not here";
  EXPECT_LT(ateOf(pathOf(folder / "mit-csail.clf.gz"), folder / "truth.tum"), 0.2);
}

TEST(Datasets, IntelKeyframes) {
  const fs::path folder = datasets() / "intel";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not here";
  const auto path = pathOf(folder / "intel-raw910.clf.gz");
  EXPECT_LT(ateOf(path, folder / "truth.tum"), 0.15);
  const auto relations = io::readRelations(folder / "intel.relations.gz");
  const auto errors = eval::relationErrors(path, relations, 0.001);
  EXPECT_EQ(errors.translation_m.size(), 90U);
  EXPECT_LT(eval::figuresOf(errors.translation_m).mean, 0.10);
}

// Different seeds agree on the whole path, the loop closed: measured over seeds 2 to 10, at most
// 0.069 m from seed 1's; the bound is twice that.
TEST(Datasets, MrptSampleIsOnePathForTwoSeeds) {
  const fs::path log =
      "/usr/share/mrpt/datasets/2006-01ENE-21-SENA_Telecom Faculty_one_loop_only.rawlog";
  if (!fs::exists(log)) GTEST_SKIP() << "the package mrpt-common is not installed";
  slam::SlamParams params;
  const auto run = [&](std::uint64_t seed) {
    params.filter.seed = seed;
    slam::Mapper mapper(params, 0);
    const auto source = io::openDataset(log);
    while (const auto step = source->next()) mapper.process(*step);
    return mapper.path();
  };
  const auto one = run(1);
  const auto two = run(2);
  ASSERT_EQ(one.size(), 225U);
  for (std::size_t i = 0; i < one.size(); ++i)
    EXPECT_LT(std::hypot(one[i].pose.x - two[i].pose.x, one[i].pose.y - two[i].pose.y), 0.14);
}
