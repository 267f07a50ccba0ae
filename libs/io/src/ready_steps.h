// Steps that were read and not yet given out: what lies ahead tells which readings mean nothing.
#pragma once
#include <deque>
#include <optional>

#include "ariadne/io/dataset.h"
#include "no_return_survey.h"
#include "raw_step.h"
#include "scan_check.h"

namespace ariadne::io {

class ReadySteps {
 public:
  ReadySteps(const DatasetOptions& options, DatasetCounts& counts);

  /// Whether more should be read before the next is given out.
  bool wantsMore() const;
  bool empty() const { return steps_.empty(); }
  std::size_t size() const { return steps_.size(); }
  /// `fraction` of the file was read for it.
  void push(RawStep step, double fraction);
  /// The next, its beams as StepSource promises, and counted.
  std::optional<models::SensorStep> pop();
  /// Of the step given out last.
  double fraction() const { return fraction_; }

 private:
  struct Ready {
    RawStep step;
    double fraction;
  };
  void judge();

  DatasetCounts& counts_;
  bool survey_wanted_;
  NoReturnSurvey survey_;
  BeamLimits limits_;
  std::deque<Ready> steps_;
  std::size_t beams_ = 0;
  double fraction_ = 0;
};

}  // namespace ariadne::io
