// Start angle, field of view and resolution as ROBOTLASER and RAWLASER lines have them: radians, or
// degrees with some writers; one of them may be missing or contradict the others.
#pragma once
#include <string>

#include "carmen_fan_choice.h"

namespace ariadne::io {

struct LineFanReading {
  std::optional<CarmenFan> fan;  ///< nullopt: the line says nothing that is possible
  std::string remark;            ///< what was odd about it
};

LineFanReading readLineFan(const CarmenLineFan& line, std::size_t count);

bool isClockwise(const CarmenLineFan& line);

}  // namespace ariadne::io
