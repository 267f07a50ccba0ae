// What a CARMEN log's PARAM lines say of its lasers: "PARAM name value", perhaps with more words.
// http://carmen.sourceforge.net/logger_playback.html; the names are those of CARMEN's modules laser
// and robot, in the spellings of all its releases.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ariadne::io {

struct CarmenParam {
  std::string text;  ///< "PARAM robot_frontlaser_offset 0.3", for messages
  double value = 0;
};

/// Of one laser, each as it is written: an angle may be in degrees or in radians.
struct CarmenLaserParams {
  bool rear = false;  ///< looks back unless `turn` says otherwise
  std::optional<CarmenParam> resolution;
  std::optional<CarmenParam> field;
  std::optional<CarmenParam> max_range_m;
  std::optional<CarmenParam> ahead_m;
  std::optional<CarmenParam> left_m;
  std::optional<CarmenParam> turn;
};

class CarmenParams {
 public:
  enum class Place {
    header,  ///< before the first scan: the last value of a name counts
    among,   ///< among the scans that are surveyed: counts when the name has no value yet
    later    ///< counts no more
  };
  /// Takes a PARAM line in. Returns a remark, once a name, when its value is not used.
  std::optional<std::string> take(const std::vector<std::string_view>& words, Place place);
  /// Of FLASER, RLASER, ROBOTLASER1, RAWLASER2, ...: 1 is the front laser, 2 the rear one, unless
  /// robot_frontlaser_id and robot_rearlaser_id say otherwise.
  CarmenLaserParams of(const std::string& label) const;

 private:
  struct Value {
    CarmenParam param;
    bool remarked = false;
  };
  std::optional<CarmenParam> find(const std::string& laser, const char* what) const;
  std::string deviceOf(const std::string& laser) const;
  std::string laserOf(const std::string& label) const;

  std::map<std::string, Value> values_;  ///< by "front resolution", "laser3 max", ...
};

}  // namespace ariadne::io
