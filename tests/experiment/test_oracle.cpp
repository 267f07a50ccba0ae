#include <gtest/gtest.h>

#include "ariadne/experiment/mapper_arms.h"
#include "ariadne/experiment/oracle.h"
#include "small_experiment.h"

using namespace ariadne;
using test::Small;

// The oracle's filters must not share their noise: as one, N of them are no more than one.
TEST(Oracle, AFilterOfItsOwnDrawsItsOwnNoise) {
  const Small small;
  const auto seen = sim::observe(small.drive, small.noise, 1);
  const std::size_t half = seen.steps.size() / 2;
  slam::Mapper suspended(small.params, 1);
  for (std::size_t k = 0; k < half; ++k) suspended.process(seen.steps[k]);
  const auto wentOn = [&](std::uint64_t seed) {
    const auto own = experiment::MapperArms::forkWithoutRecovery(suspended);
    experiment::MapperArms::collapseTo(*own, 0, seed);
    for (std::size_t k = half; k < seen.steps.size(); ++k) own->process(seen.steps[k]);
    return own->particles()[0].map_from_robot;
  };
  EXPECT_EQ(wentOn(7), wentOn(7)) << "to the bit";
  EXPECT_NE(wentOn(7), wentOn(8));
}

TEST(Oracle, TheRecoveredSetIsNearerToItThanWhatTheLapsLeft) {
  const Small small;
  double recovered = 0;
  double standard = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const auto r =
        experiment::runOracle(sim::observe(small.drive, small.noise, seed), small.params, {}, seed);
    ASSERT_TRUE(r) << seed;
    recovered += r->kl_recovered_nats;
    standard += r->kl_standard_nats;
    EXPECT_LT(r->oracle.ate_m, 0.5);
    const auto pair = small.run(seed);
    EXPECT_EQ(r->recovered.ate_m, pair.recovered.ate_m) << "the same run, to the bit";
    EXPECT_EQ(r->standard.ate_m, pair.standard.ate_m);
  }
  EXPECT_LT(recovered, standard);
}
