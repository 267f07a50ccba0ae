// The lasers of a CARMEN log: which lines to use, their angles, where they sit, how far they see.
#pragma once
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "carmen_fans.h"
#include "carmen_place.h"

namespace ariadne::io {

class CarmenLasers {
 public:
  /// Reads the log's first scans and the PARAM lines before and among them; where these leave the
  /// angles open, on to the PARAM that tells, or to the end. `field_of_view_deg` over 0 is the
  /// user's word.
  CarmenLasers(const std::filesystem::path& path, double field_of_view_deg);
  CarmenLasers(const CarmenLasers&) = delete;
  CarmenLasers& operator=(const CarmenLasers&) = delete;

  /// FLASER repeats ROBOTLASER1 for older programs, RLASER ROBOTLASER2, and RAWLASER is what the
  /// others were made of.
  bool isUsed(const std::string& label) const;
  /// Whether the robot's poses come from ODOM lines, since those of the lasers have none.
  bool needsOdometry() const { return !raw_.empty() && posed_.empty(); }
  /// Sets angles, place and maximum range; `record.problem` where nothing tells the angles.
  void complete(CarmenScan& scan);
  /// A PARAM line while the records are read.
  void takeParam(const std::vector<std::string_view>& words, bool scans_began);

  const std::vector<std::string>& notes() const { return notes_; }
  std::vector<std::string>& remarks() { return remarks_; }
  const std::vector<std::string>& remarks() const { return remarks_; }

 private:
  struct Laser {
    std::vector<mrpt::math::TPose2D> offsets;
    std::set<float> longest;  ///< some readings, each once, below kCarmenMaxRange_m
    bool bare = false;        ///< its lines have no maximum range
    CarmenLaserParams params;
    LaserPlace place;
    float max_range_m = 0;  ///< 0: as its lines have it
  };
  void survey(const std::filesystem::path& path);
  void remarkOnRawLasers();
  void look(const CarmenScan& scan);
  void settle(const std::string& label, Laser& laser);
  void settleRange(const std::string& label, Laser& laser);

  CarmenParams params_;
  CarmenFans fans_;
  std::map<std::string, Laser> lasers_;
  std::set<std::string> posed_, raw_;  ///< labels met
  bool surveyed_ = false;
  std::vector<std::string> notes_, remarks_;
};

}  // namespace ariadne::io
