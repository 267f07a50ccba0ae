// What only paired runs do to a Mapper; experiment::MapperArms is their door.
#include "mapper_impl.h"

namespace ariadne::slam {

std::unique_ptr<Mapper> Mapper::forkWithoutRecovery() const {
  std::unique_ptr<Mapper> other(new Mapper(std::make_unique<Impl>(*impl_)));
  other->impl_->after_weighing = nullptr;
  other->impl_->before_recovery = nullptr;
  other->impl_->loops.disableRecovery();
  return other;
}

void Mapper::collapseTo(std::size_t particle, std::uint64_t seed) {
  impl_->params.filter.seed = seed;
  impl_->particles.reseed(seed);
  impl_->loops.reseed(seed);
  const std::size_t n = impl_->particles.size();
  const filter::Particle one = impl_->particles[particle];
  impl_->particles.replace(std::vector<filter::Particle>(n, one),
                           std::vector<double>(n, 1.0 / static_cast<double>(n)));
  if (!graphs().empty())
    impl_->loops.setGraphs(std::vector<loops::PlaceGraph>(n, graphs()[particle]));
}

void Mapper::gatherBest(const std::vector<std::unique_ptr<Mapper>>& others,
                        const std::vector<double>& weights) {
  std::vector<filter::Particle> particles;
  std::vector<loops::PlaceGraph> of_each;
  for (const auto& other : others) {
    const std::size_t best = other->particles().best();
    particles.push_back(other->particles()[best]);
    if (!graphs().empty()) of_each.push_back(other->graphs()[best]);
  }
  impl_->particles.replace(std::move(particles), weights);
  impl_->loops.setGraphs(std::move(of_each));
}

void Mapper::afterWeighing(std::function<void()> call) {
  impl_->after_weighing = std::move(call);
}

void Mapper::beforeRecovery(std::function<void()> call) {
  impl_->before_recovery = std::move(call);
}

}  // namespace ariadne::slam
