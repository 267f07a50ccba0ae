#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "ariadne/core/error.h"
#include "ariadne/geometry/weighted_poses.h"

using namespace ariadne;

namespace {

std::string refusalOf(const geometry::WeightedPoses& set) {
  try {
    geometry::checkWeightedPoses(set);
  } catch (const core::Error& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(WeightedPoses, SaysWhatIsWrongWithASet) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusalOf({{{0, 0, 0}, {1, 0, 0}}, {0.25, 0.75}}), "");
  EXPECT_EQ(refusalOf({{{0, 0, 0}}, {0.25, 0.75}}), "2 weights for 1 poses: it takes one each");
  EXPECT_EQ(refusalOf({{}, {}}), "a weighted set without weights has no measures");
  EXPECT_EQ(refusalOf({{{0, 0, 0}}, {-1}}), "weight 0 is -1: weights are finite and 0 or more");
  EXPECT_EQ(refusalOf({{{0, 0, 0}}, {0.5}}), "the weights sum to 0.5: normalise them to 1");
  EXPECT_EQ(refusalOf({{{0, nan, 0}}, {1}}), "pose 0 of the weighted set is not finite");
}
