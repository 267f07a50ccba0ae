// Which of all that a log and its user say decides about a laser's angles.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "carmen_fan.h"
#include "carmen_params.h"

namespace ariadne::io {

/// What ROBOTLASER and RAWLASER lines say of their beams; a zero says nothing.
struct CarmenLineFan {
  double start = 0;
  double field = 0;
  double step = 0;
};

struct FanChoice {
  std::optional<CarmenFan> fan;      ///< nullopt: nothing tells
  std::string source;                ///< "by PARAM laser_front_laser_resolution 0.25"
  std::vector<std::string> remarks;  ///< what contradicts it
  std::string problem;               ///< for the user, where there is no fan
};

/// For `count` beams, at least 2. First the user's setting (0: none), then what the line says, then
/// PARAMs, then the number of beams where that is enough: not for a laser that `looks_round`.
/// `label` is for the problem's text.
FanChoice chooseFan(const std::string& label, std::size_t count,
                    const std::optional<CarmenLineFan>& line, const CarmenLaserParams& params,
                    double setting_deg, bool looks_round = false);

}  // namespace ariadne::io
