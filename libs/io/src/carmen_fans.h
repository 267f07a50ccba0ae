// The angles of a CARMEN log's scans, decided once for each kind of line.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "carmen_line.h"
#include "carmen_seam.h"

namespace ariadne::io {

class CarmenFans {
 public:
  /// `params` may still grow until the first `of`; `field_of_view_deg` over 0 is the user's word.
  CarmenFans(const CarmenParams& params, double field_of_view_deg)
      : params_(params), field_of_view_deg_(field_of_view_deg) {}

  /// Such lines are in the log.
  void meet(const CarmenScan& scan);
  /// Whether the angles of all that were met, and are used, are known by now.
  bool allKnown(const std::function<bool(const std::string& label)>& is_used) const;
  /// The angles of a scan. Adds to `notes` and `remarks` at the first of its kind.
  const FanChoice& of(const CarmenScan& scan, std::vector<std::string>& notes,
                      std::vector<std::string>& remarks);

 private:
  /// Label, number of beams, start angle, field of view, resolution.
  using Kind = std::tuple<std::string, std::size_t, double, double, double>;

  static Kind kindOf(const CarmenScan& scan);
  FanChoice choose(const Kind& kind) const;

  const CarmenParams& params_;
  double field_of_view_deg_;
  std::map<Kind, CarmenSeam> met_;
  std::map<Kind, FanChoice> choices_;
  FanChoice other_;  ///< of a kind too many to be remembered
};

}  // namespace ariadne::io
