// The explorer step by step, on scans of a room.
#include <gtest/gtest.h>

#include "../room.h"
#include "ariadne/explore/explorer.h"

using namespace ariadne;

TEST(Explorer, ItsTimeBeginsWithTheFirstScanAndNotIn1970) {
  slam::SlamParams slam;
  slam.filter.particles = 1;
  slam::Mapper mapper(slam, 1);
  explore::ExploreParams params;
  params.max_time_s = 60;
  explore::Explorer explorer(params);
  const auto scan = test::scanIn(test::roomWorld(), {});
  const auto step = [&](double since_start_s) {
    const double time_s = 1.7e9 + since_start_s;  // UNIX time, as a robot's driver gives it
    mapper.process({time_s, {}, scan});
    explorer.step({time_s, mapper, *scan});
    return explorer.done();
  };
  EXPECT_FALSE(step(0)) << explorer.endReason();
  EXPECT_FALSE(step(59));
  EXPECT_TRUE(step(60));
  EXPECT_EQ(explorer.endReason(), "max_time_s is over");
}
