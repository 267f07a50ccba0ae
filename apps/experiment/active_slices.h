// What of an experiment is in Slurm's hands now.
#pragma once
#include <string>
#include <vector>

#include "ariadne/batch/store.h"
#include "ariadne/cluster/slices.h"
#include "ariadne/cluster/slurm_queue.h"
#include "ariadne/cluster/submission.h"

namespace ariadne::experiment_app {

/// squeue's answer about all that was handed to Slurm; nothing is asked when nothing was.
cluster::Queue askAbout(const std::vector<cluster::Submission>& submissions);

/// The slices that those tasks do of the plan that is in the folder now.
std::vector<cluster::Slice> activeSlices(const std::vector<cluster::Submission>& submissions,
                                         const cluster::Queue& queue, const batch::Store& store);

/// Hash of the folder's plan.json.
std::string planHash(const batch::Store& store);

}  // namespace ariadne::experiment_app
