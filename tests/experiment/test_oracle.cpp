#include <gtest/gtest.h>

#include "ariadne/experiment/oracle.h"
#include "small_experiment.h"

using namespace ariadne;
using test::Small;

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
