#include "ariadne/experiment/oracle.h"

#include <memory>

#include "ariadne/core/random.h"
#include "ariadne/eval/kl_divergence.h"
#include "ariadne/experiment/mapper_arms.h"
#include "arm_result.h"

namespace ariadne::experiment {
namespace {

using Steps = std::vector<models::SensorStep>;

/// Both arms at the end of the first closing that is recovered, and where in the drive that is.
struct FirstLoop {
  std::unique_ptr<slam::Mapper> recovered;
  std::unique_ptr<slam::Mapper> standard;
  std::size_t te = 0;    // filter update
  std::size_t next = 0;  // step to go on with
};

std::optional<FirstLoop> driveToTheEnd(const Steps& steps, const slam::SlamParams& params) {
  FirstLoop loop;
  loop.recovered = std::make_unique<slam::Mapper>(params, 1);
  MapperArms::beforeRecovery(*loop.recovered, [&] {
    if (!loop.standard) loop.standard = MapperArms::forkWithoutRecovery(*loop.recovered);
  });
  while (loop.next < steps.size() && !loop.standard) loop.recovered->process(steps[loop.next++]);
  if (!loop.standard) return std::nullopt;
  for (const loops::ClosingRecord& r : loop.recovered->closings())
    if (r.recovery) loop.te = r.closing.opportunity.te;
  return loop;
}

/// Of the filter of a particle. With the suspended filter's own seed all of them would draw the
/// same noise, and the oracle's set would be of fewer samples than it has.
std::uint64_t seedOf(std::uint64_t seed, std::size_t te, std::size_t particle) {
  core::RandomStream random(seed, static_cast<std::uint32_t>(te),
                            static_cast<std::uint32_t>(particle), core::Purpose::fork);
  const std::uint64_t high = random.bits();
  return high << 32 | random.bits();
}

/// The suspended filter at te, each particle carried through the loop by a filter of its own.
std::unique_ptr<slam::Mapper> oracleThrough(const Steps& steps, const slam::SlamParams& params,
                                            const FirstLoop& loop) {
  auto suspended = std::make_unique<slam::Mapper>(params, 1);
  std::size_t i = 0;
  while (suspended->updates() <= loop.te) suspended->process(steps[i++]);
  const std::vector<double> weights = suspended->particles().weights();
  std::vector<std::unique_ptr<slam::Mapper>> own;
  for (std::size_t p = 0; p < weights.size(); ++p) {
    own.push_back(MapperArms::forkWithoutRecovery(*suspended));
    MapperArms::collapseTo(*own.back(), p, seedOf(params.filter.seed, loop.te, p));
    for (std::size_t k = i; k < loop.next; ++k) own.back()->process(steps[k]);
  }
  auto gathered = MapperArms::forkWithoutRecovery(*own.front());
  MapperArms::gatherBest(*gathered, own, weights);
  return gathered;
}

}  // namespace

std::optional<OracleResult> runOracle(const sim::SimulatedDrive& seen,
                                      const slam::SlamParams& params,
                                      const eval::CorrectBounds& bounds, std::uint64_t seed) {
  slam::SlamParams seeded = params;
  seeded.filter.seed = seed;
  const auto loop = driveToTheEnd(seen.steps, seeded);
  if (!loop) return std::nullopt;
  const auto oracle = oracleThrough(seen.steps, seeded, *loop);

  OracleResult result;
  result.kl_recovered_nats =
      eval::divergence(oracle->particles().poses(), loop->recovered->particles().poses()).kl_nats;
  result.kl_standard_nats =
      eval::divergence(oracle->particles().poses(), loop->standard->particles().poses()).kl_nats;
  for (slam::Mapper* mapper : {oracle.get(), loop->recovered.get(), loop->standard.get()})
    for (std::size_t k = loop->next; k < seen.steps.size(); ++k) mapper->process(seen.steps[k]);
  result.oracle = armResultOf(*oracle, seen.truth, bounds);
  result.recovered = armResultOf(*loop->recovered, seen.truth, bounds);
  result.standard = armResultOf(*loop->standard, seen.truth, bounds);
  return result;
}

}  // namespace ariadne::experiment
