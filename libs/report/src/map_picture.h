// A picture of a map with room below for a scale bar and a line of text: what all pictures of maps
// are drawn on.
#pragma once
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <filesystem>
#include <string>

#include "canvas.h"

namespace ariadne::report {

class MapPicture {
 public:
  /// Paints the known part of the map. Throws core::Error naming the file when it has no cells.
  MapPicture(std::filesystem::path file, const mrpt::maps::COccupancyGridMap2D& map);

  cairo_t* context() { return context_.get(); }
  const View& view() const { return view_; }
  /// "map 12.3 x 4.5 m".
  std::string sizeText() const;
  void drawScaleBar();
  /// Writes on the footer's line from x on; returns where the text ends.
  double drawText(double x, const std::string& text);
  double textLine() const { return bottom_ + 42; }
  /// Throws core::Error naming the file when it cannot be drawn or written.
  void write();

 private:
  void check() const;

  std::filesystem::path file_;
  double width_m_ = 0;
  double height_m_ = 0;
  double bottom_ = 0;  // of the map, pixels
  View view_;
  Surface surface_;
  Context context_;
};

}  // namespace ariadne::report
