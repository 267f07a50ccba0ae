// The occupancy grid as MRPT's other maps are: a CMetricMap that an INI can name
// ("tiledGrid_count", with _creationOpts, _insertOpts and _likelihoodOpts in the words of
// COccupancyGridMap2D), that serialises, and that any program for metric maps can insert scans
// into.
#pragma once
#include <mrpt/maps/CMetricMap.h>
#include <mrpt/maps/TMetricMapInitializer.h>
#include <mrpt/maps/TMetricMapTypesRegistry.h>

#include "ariadne/grid/field/endpoint_likelihood.h"
#include "ariadne/grid/map/occupancy_grid.h"

namespace ariadne::grid {

/// An OccupancyGrid as a map of MRPT, for its builders, likelihoods and files.
class TiledGridMap : public mrpt::maps::CMetricMap {
  DEFINE_SERIALIZABLE(TiledGridMap, ariadne::grid)

 public:
  /// Throws core::UsageError when a parameter is out of bounds.
  explicit TiledGridMap(const GridParams& params = {}, const LikelihoodParams& likelihood = {});
  /// With what the grid holds.
  explicit TiledGridMap(OccupancyGrid grid, const GridParams& params,
                        const LikelihoodParams& likelihood = {});

  /// The map itself; a copy of it is a cheap checkpoint.
  const OccupancyGrid& grid() const { return grid_; }
  /// How scans are inserted.
  const GridParams& params() const { return params_; }

  /// Whether no cell was ever seen.
  bool isEmpty() const override;
  /// For people: how many cells are known, and their size.
  std::string asString() const override;
  /// Writes <prefix>_tiled.gridmap.gz, a COccupancyGridMap2D. Throws when that cannot be written.
  void saveMetricMapRepresentationToFile(const std::string& prefix) const override;
  /// As COccupancyGridMap2D draws itself.
  void getVisualizationInto(mrpt::opengl::CSetOfObjects& out) const override;

 private:
  void internal_clear() override;
  /// Takes CObservation2DRangeScan; returns false for anything else, and for a laser that does not
  /// look along the floor.
  bool internal_insertObservation(
      const mrpt::obs::CObservation& observation,
      const std::optional<const mrpt::poses::CPose3D>& robot_pose) override;
  bool internal_canComputeObservationLikelihood(
      const mrpt::obs::CObservation& observation) const override;
  double internal_computeObservationLikelihood(
      const mrpt::obs::CObservation& observation,
      const mrpt::poses::CPose3D& taken_from) const override;

  GridParams params_;
  LikelihoodParams likelihood_params_;
  OccupancyGrid grid_;
  EndpointLikelihood likelihood_;

  MAP_DEFINITION_START(TiledGridMap)
  GridParams grid;
  LikelihoodParams likelihood;
  MAP_DEFINITION_END(TiledGridMap)
};

/// Makes the map known to MRPT by name: call it once in a program that only names the map in an INI
/// or reads it from a file (a static library's registration is dropped where nothing refers to it).
void registerTiledGridMap();

/// MRPT's certainty of one observation (maxOccupancyUpdateCertainty) as our two probabilities: its
/// grid takes three times as much from the cell a beam ends in as it adds to those it passed.
void setUpdateCertainty(GridParams& params, double certainty);

}  // namespace ariadne::grid
