#include "ariadne/report/replay_recorder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "ariadne/eval/pose_entropy.h"
#include "ariadne/geometry/pose.h"
#include "drawn_parts.h"
#include "map_film.h"
#include "map_halving.h"
#include "running_entropy.h"
#include "thinning.h"

namespace ariadne::report {
namespace {

/// Distance that s* moved in its last update; not that to the pose of the s* before, which may be
/// another.
double lastDistance(const filter::Ancestor& leaf) {
  if (!leaf.parent()) return 0;
  const auto& from = leaf.parent()->pose();
  return geometry::distance(leaf.pose(), from);
}

double poseEntropy(const FilterView& view) {
  geometry::WeightedPoses now;
  now.weights = view.weights;
  for (const filter::Particle* p : view.particles) now.poses.push_back(p->map_from_robot);
  return eval::gaussianEntropy(now);
}

}  // namespace

struct ReplayRecorder::Impl {
  explicit Impl(const RecorderParams& p) : params(p), stride(p.updates_a_frame) {}
  void add(const slam::StepReport& report, const FilterView& view, std::string state);
  void addCloud(const FilterView& view);
  void addFrame(const FilterView& view, bool pinned);
  void addPending();
  void shrink();
  bool stateChanged() const;

  RecorderParams params;
  Replay replay;
  ReplayScene scene;
  std::vector<ReplayMoment> pending;
  TileStore store;
  MapFilm film;
  RunningEntropy map_entropy;
  std::size_t cloud_stride = 1;  // updates from cloud to cloud
  std::size_t stride;            // from keyframe to keyframe
};

void ReplayRecorder::Impl::add(const slam::StepReport& report, const FilterView& view,
                               std::string state) {
  const filter::Particle& best = *view.particles.at(view.best);
  ReplayStep step;
  step.time_s = report.time_s;
  step.distance_m =
      (replay.steps.empty() ? 0 : replay.steps.back().distance_m) + lastDistance(*best.ancestor);
  step.neff = report.neff;
  step.resampled = report.resampled;
  if (view.graph) step.unique_ancestors = report.loops.unique_ancestors;
  step.pose_entropy = poseEntropy(view);
  step.map_from_robot = report.map_from_robot;
  step.loop_state = report.loops.state;
  step.state = std::move(state);
  replay.particles = view.particles.size();
  replay.steps.push_back(std::move(step));
}

bool ReplayRecorder::Impl::stateChanged() const {
  const std::size_t n = replay.steps.size();
  return n > 1 && replay.steps[n - 1].loop_state != replay.steps[n - 2].loop_state;
}

void ReplayRecorder::Impl::addCloud(const FilterView& view) {
  const std::size_t now = replay.steps.size() - 1;
  if (now % cloud_stride != 0) return;
  replay.clouds.push_back({now, drawnParticles(view, params.max_particles)});
  if (replay.clouds.size() * replay.clouds.back().particles.size() <= params.max_clouded) return;
  cloud_stride *= 2;
  const auto goes = [&](const ReplayCloud& c) { return c.step % cloud_stride != 0; };
  replay.clouds.erase(std::remove_if(replay.clouds.begin(), replay.clouds.end(), goes),
                      replay.clouds.end());
}

void ReplayRecorder::Impl::addFrame(const FilterView& view, bool pinned) {
  const filter::Particle& best = *view.particles.at(view.best);
  ReplayFrame frame;
  frame.step = replay.steps.size() - 1;
  frame.pinned = pinned;
  frame.map = film.take(best.map, store);
  replay.steps.back().map_entropy = map_entropy.of(best.map);
  frame.path = drawnPath(best.ancestor, params.path_spacing_m);
  if (view.graph) frame.graph = drawnGraph(*view.graph);
  frame.scene = scene;
  const int side = sideOf(frame.map);
  if (replay.frames.empty()) replay.map_origin = best.map.origin();
  replay.frames.push_back(std::move(frame));
  for (int s = side; s > params.max_side_px; s /= 2) {
    halve(replay.frames, store);
    film.restart(film.level() + 1);
  }
  replay.pixel_m = best.map.resolution() * (1 << film.level());
  if (replay.frames.size() > params.max_frames || store.tiles().size() > params.max_tiles) shrink();
}

void ReplayRecorder::Impl::addPending() {
  for (ReplayMoment& m : pending) {
    m.step = replay.steps.size() - 1;
    replay.moments.push_back(std::move(m));
  }
  pending.clear();
}

void ReplayRecorder::Impl::shrink() {
  stride *= 2;
  do {
    if (!thin(replay.frames)) return;
    const auto used = usedTiles(replay.frames, store.tiles());
    store = TileStore();
    for (const ReplayTile& tile : used) store.add(tile);
    film.restart(film.level());
  } while (store.tiles().size() > params.max_tiles);
}

ReplayRecorder::ReplayRecorder(const RecorderParams& params)
    : impl_(std::make_unique<Impl>(params)) {}
ReplayRecorder::~ReplayRecorder() = default;

void ReplayRecorder::show(ReplayScene scene) { impl_->scene = std::move(scene); }

void ReplayRecorder::mark(ReplayMoment moment) { impl_->pending.push_back(std::move(moment)); }

void ReplayRecorder::step(const slam::StepReport& report, const FilterView& view,
                          std::string state) {
  impl_->add(report, view, std::move(state));
  impl_->addCloud(view);
  const std::size_t now = impl_->replay.steps.size() - 1;
  const bool stays = impl_->stateChanged() || !impl_->pending.empty();
  impl_->addPending();
  if (stays || now % impl_->stride == 0) impl_->addFrame(view, stays);
}

Replay ReplayRecorder::finish(const FilterView& last) {
  Impl& i = *impl_;
  const std::size_t steps = i.replay.steps.size();
  if (steps > 0) i.addPending();
  if (steps > 0 && i.replay.frames.back().step + 1 != steps) i.addFrame(last, true);
  Replay done = std::move(i.replay);
  done.tiles = usedTiles(done.frames, i.store.tiles());
  impl_ = std::make_unique<Impl>(RecorderParams(i.params));
  return done;
}

FilterView viewOf(const slam::Mapper& mapper) {
  FilterView view;
  const filter::ParticleSet& set = mapper.particles();
  for (std::size_t i = 0; i < set.size(); ++i) view.particles.push_back(&set[i]);
  view.weights = set.weights();
  view.best = set.best();
  if (!mapper.graphs().empty()) view.graph = &mapper.graphs()[view.best];
  return view;
}

}  // namespace ariadne::report
