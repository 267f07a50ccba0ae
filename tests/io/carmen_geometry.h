// CARMEN lines with angles of every kind, and what a reader makes of a log of them.
#pragma once
#include "ariadne/io/dataset_records.h"
#include "sample_logs.h"
#include "temporary_folder.h"

namespace sample {

class CarmenGeometry : public TemporaryFolder {
 protected:
  struct Read : Result {
    std::vector<std::string> notes;
    bool notesThat(const std::string& part) const {
      for (const std::string& n : notes)
        if (n.find(part) != n.npos) return true;
      return false;
    }
  };
  Read readLog(const std::string& text, double field_of_view_deg = 0,
               const std::string& label = "") {
    io::writeWhole(folder / "a.log", text);
    Read r;
    io::DatasetOptions options;
    options.field_of_view_deg = field_of_view_deg;
    options.laser_label = label;
    try {
      const auto source = io::openDataset(folder / "a.log", options);
      while (auto step = source->next()) r.steps.push_back(std::move(*step));
      r.counts = source->counts();
      r.warnings = source->warnings();
      r.label = source->laserLabel();
      const auto records = io::openRecords(folder / "a.log", options);
      while (records->next()) continue;
      r.notes = records->notes();
    } catch (const ariadne::core::Error& e) {
      r.error = e.what();
    }
    return r;
  }

  /// Directions of the first and the last beam from the robot's axis, degrees. The tolerance is
  /// what a resolution in radians of seven digits loses over 1081 beams.
  static void expectFan(const Read& r, double first_deg, double last_deg) {
    ASSERT_FALSE(r.steps.empty()) << r.error;
    const auto& s = *r.steps[0].scan;
    const double side = s.rightToLeft ? 1 : -1;
    const double middle = s.sensorPose.yaw() * 180 / M_PI;
    const double half = s.aperture / 2 * 180 / M_PI;
    EXPECT_NEAR(std::remainder(middle - side * half - first_deg, 360), 0, 2e-3);
    EXPECT_NEAR(std::remainder(middle + side * half - last_deg, 360), 0, 2e-3);
    EXPECT_NEAR(2 * half, std::abs(last_deg - first_deg), 2e-3);
  }

  static std::string flasers(std::size_t beams, int lines = 3, const char* kind = "FLASER") {
    std::string text;
    for (int i = 0; i < lines; ++i)
      text += kind + flaser(beams, "2.5", "1 2 0", "1 2 0", kBegin_s + i).substr(6);
    return text;
  }

  /// A ROBOTLASER1 line with these angles, as they stand in the line.
  static std::string robotlaser(const std::string& angles, std::size_t beams, double time_s,
                                const char* kind = "ROBOTLASER1") {
    std::string line = fmt::format("{} 0 {} 30 0.01 0 {}", kind, angles, beams);
    for (std::size_t i = 0; i < beams; ++i) line += fmt::format(" {:.3f}", 1 + 0.01 * double(i));
    line += " 0 ";
    if (std::string(kind).rfind("RAW", 0) != 0) line += "1 2 0.5 1 2 0.5 0 0 0 0 0 ";
    return line + fmt::format("{:.6f} host {:.6f}\n", time_s, time_s - kBegin_s);
  }
};

}  // namespace sample
