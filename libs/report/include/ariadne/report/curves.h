// A chart of curves over one axis, with marked moments: coalescence, Neff.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ariadne::report {

struct Curve {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
};

/// A vertical line with a name.
struct Moment {
  std::string name;
  double x = 0;
};

struct CurveChart {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Curve> curves;
  std::vector<Moment> moments;
};

/// PNG, 1000 x 560 pixels. Curves are told apart by colour, named below. Throws core::Error naming
/// the file.
void writeCurves(const std::filesystem::path& file, const CurveChart& chart);

}  // namespace ariadne::report
