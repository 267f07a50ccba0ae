// A chart of curves over one axis, with marked moments and stretches: coalescence, Neff.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ariadne::charts {

/// A line through points; x and y are as many.
struct Curve {
  std::string name;
  std::vector<double> x;
  std::vector<double> y;
  std::optional<std::size_t> colour = std::nullopt;  ///< see colourOf(); none: by its place
  bool dashed = false;
};

/// A vertical line with a name.
struct Moment {
  std::string name;
  double x = 0;
};

/// A grey band from x0 to x1, under everything else.
struct Band {
  double x0 = 0;
  double x1 = 0;
  double grey = 0.9;  ///< 0 black, 1 white
};

/// What one picture shows.
struct CurveChart {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Curve> curves;
  std::vector<Moment> moments;
  std::vector<Band> bands = {};
};

/// PNG, 1000 pixels wide, 560 high with up to three curves and 20 more for each further three. The
/// first curve lies on top; names are below. Throws core::Error naming the file.
void writeCurves(const std::filesystem::path& file, const CurveChart& chart);

}  // namespace ariadne::charts
