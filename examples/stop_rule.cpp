// A stopping rule of one's own, tried beside the paper's on a log: example-stop-rule LOG
#include <algorithm>
#include <iostream>
#include <map>

#include "ariadne/io/dataset.h"
#include "ariadne/loops/closing/stop_rules.h"
#include "ariadne/slam/mapper.h"

using ariadne::loops::ClosingCourse;
using ariadne::loops::StopRule;

namespace {

/// Stop when the last `window_m` of the loop taught nothing new: no particle set since was less
/// even than the least even one before. A rule sees the closing so far, update by update.
StopRule nothingNewFor(double window_m) {
  return [=](const ClosingCourse& course) {
    if (course.driven_m() < window_m) return false;
    const double from_m = course.steps.back().travelled_m - window_m;
    double before = course.steps.front().particles, within = before;
    for (const auto& step : course.steps) {
      double& least = step.travelled_m < from_m ? before : within;
      least = std::min(least, step.neff);
    }
    return within >= before;
  };
}

/// Prints once where a rule would have ended each closing.
class Trial {
 public:
  Trial(std::string name, StopRule rule) : name_(std::move(name)), rule_(std::move(rule)) {}
  void ask(std::size_t closing, const ClosingCourse& course) {
    if (stopped_.count(closing) > 0 || course.steps.empty() || !rule_(course)) return;
    stopped_[closing] = course.driven_m();
    std::cout << "closing " << closing << ": " << name_ << " stops after " << course.driven_m()
              << " m\n";
  }

 private:
  std::string name_;
  StopRule rule_;
  std::map<std::size_t, double> stopped_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: example-stop-rule LOG\n";
    return 2;
  }
  try {
    const auto log = ariadne::io::openDataset(argv[1]);
    ariadne::slam::Mapper mapper({}, /*threads=*/0);
    Trial paper("the paper's rule", ariadne::loops::neffConstantFor(10, 0.1));
    Trial own("the rule of one's own", nothingNewFor(8));
    while (const auto step = log->next()) {
      if (!mapper.process(*step)) continue;
      for (const auto* closing : mapper.openClosings()) {
        paper.ask(closing->id, closing->course);
        own.ask(closing->id, closing->course);
      }
    }
    std::cout << mapper.closings().size() << " loops in " << mapper.updates() << " updates\n";
  } catch (const std::exception& e) {
    std::cerr << "example-stop-rule: " << e.what() << '\n';
    return 1;
  }
}
