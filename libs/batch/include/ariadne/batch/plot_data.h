// What the plots of an experiment show, as numbers.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "ariadne/batch/plan.h"
#include "ariadne/batch/tables.h"

namespace ariadne::batch {

/// A value with its 95 % interval: Wilson's of a rate, the bootstrap's of a median.
struct PlotPoint {
  std::size_t place = 0;  ///< in Plot::places
  double value = 0;
  double low = 0;
  double high = 0;
  std::size_t runs = 0;  ///< that have it
};

/// An arm. A cell of which nothing is known has no point.
struct PlotSeries {
  std::string name;
  std::vector<PlotPoint> points;  ///< by place
};

/// One figure over one factor's values, or over the arms where there is no factor.
struct Plot {
  std::string name;                 ///< of its files, without ending: letters, digits, _
  std::string figure;               ///< with its unit: "distance (m)"
  std::string about;                ///< "median, bootstrap 95 % interval"
  std::string panel;                ///< values of the other factors: "world nested"
  std::string factor;               ///< along the axis; empty: arms
  std::vector<std::string> places;  ///< its values, or the arms
  std::vector<double> numbers;      ///< the same as numbers, ascending; empty: not all are any
  std::vector<PlotSeries> series;   ///< all arms
  bool is_rate = false;             ///< per cent, 0 to 100
};

/// The plots that the plan asks for and of which a run is known. The axis is that of
/// PlotChoice::over; every combination of other factors' values has plots of its own. The same
/// cells give the same bits.
std::vector<Plot> plotsOf(const Plan& plan, const std::vector<Cell>& cells);

/// A figure's name with the unit its end tells: ate_rmse_m is "ate_rmse (m)".
std::string withUnit(const std::string& figure);

}  // namespace ariadne::batch
