#include "active_slices.h"

#include "ariadne/batch/content_hash.h"

namespace ariadne::experiment_app {

std::string planHash(const batch::Store& store) {
  return batch::FileHashes().of(store.folder() / "plan.json");
}

cluster::Queue askAbout(const std::vector<cluster::Submission>& submissions) {
  std::vector<std::string> names;
  for (const auto& s : submissions)
    if (s.engine == "slurm") names.push_back(s.name);
  return names.empty() ? cluster::Queue() : cluster::askSqueue(names);
}

std::vector<cluster::Slice> activeSlices(const std::vector<cluster::Submission>& submissions,
                                         const cluster::Queue& queue, const batch::Store& store) {
  std::vector<cluster::Slice> active;
  const std::string plan = planHash(store);
  for (const cluster::Task& task : queue.tasks)
    for (const auto& s : submissions)
      // A task reads the plan when it starts; one that runs has the slice of the plan it read.
      if (s.name == task.name && (s.plan == plan || task.state == "PENDING"))
        active.push_back({task.slice, s.slices, task.state == "PENDING"});
  return active;
}

}  // namespace ariadne::experiment_app
