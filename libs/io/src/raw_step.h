// A step on its way from the file to the one who maps.
#pragma once
#include "ariadne/io/dataset_records.h"
#include "ariadne/models/sensor_step.h"

namespace ariadne::io {

/// A step whose scan does not have its beams yet: what those ahead mean is not known before.
struct RawStep : models::SensorStep {
  RawBeams beams;
};

}  // namespace ariadne::io
