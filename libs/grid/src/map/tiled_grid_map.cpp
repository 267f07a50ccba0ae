#include "ariadne/grid/map/tiled_grid_map.h"

#include <mrpt/config/CConfigFileBase.h>
#include <mrpt/core/initializer.h>
#include <mrpt/io/CFileGZOutputStream.h>
#include <mrpt/obs/CObservation2DRangeScan.h>
#include <mrpt/opengl/CSetOfObjects.h>
#include <mrpt/serialization/CArchive.h>

#include <algorithm>

#include "ariadne/core/error.h"
#include "ariadne/grid/map/conversion.h"

using ariadne::grid::TiledGridMap;
using mrpt::config::CConfigFileBase;
using mrpt::maps::COccupancyGridMap2D;
using mrpt::obs::CObservation2DRangeScan;

IMPLEMENTS_SERIALIZABLE(TiledGridMap, CMetricMap, ariadne::grid)
MAP_DEFINITION_REGISTER("ariadne::grid::TiledGridMap,tiledGrid", ariadne::grid::TiledGridMap)

MRPT_INITIALIZER(registerTiledGridMapClass) {
  mrpt::rtti::registerClass(CLASS_ID(ariadne::grid::TiledGridMap));
}

namespace ariadne::grid {

void registerTiledGridMap() {
  // Referring to the id is what links this file in; the rest happened before main().
  ASSERT_(&TiledGridMap::m_private_map_register_id != nullptr);
}

void setUpdateCertainty(GridParams& params, double certainty) {
  const int free = std::max(1, int{COccupancyGridMap2D::p2l(static_cast<float>(certainty))});
  params.free_probability = freeProbability(static_cast<std::int8_t>(std::min(free, 127)));
  params.occupied_probability = freeProbability(static_cast<std::int8_t>(std::min(3 * free, 127)));
  params.free_probability = std::clamp(params.free_probability, 0.51, 0.99);
  params.occupied_probability = std::clamp(params.occupied_probability, 0.51, 0.99);
}

TiledGridMap::TMapDefinition::TMapDefinition() = default;

void TiledGridMap::TMapDefinition::loadFromConfigFile_map_specific(const CConfigFileBase& source,
                                                                   const std::string& prefix) {
  const auto read = [&](const char* section, const char* key, double old) {
    return source.read_double(prefix + section, key, old);
  };
  grid.resolution_m = read("_creationOpts", "resolution", grid.resolution_m);
  grid.insert_range_m = read("_insertOpts", "maxDistanceInsertion", grid.insert_range_m);
  if (source.keyExists(prefix + "_insertOpts", "maxOccupancyUpdateCertainty"))
    setUpdateCertainty(grid, read("_insertOpts", "maxOccupancyUpdateCertainty", 0.65));
  likelihood.hit_sigma_m = read("_likelihoodOpts", "LF_stdHit", likelihood.hit_sigma_m);
  likelihood.hit_weight = read("_likelihoodOpts", "LF_zHit", likelihood.hit_weight);
}

void TiledGridMap::TMapDefinition::dumpToTextStream_map_specific(std::ostream& out) const {
  out << fmt::format("resolution = {}\nmaxDistanceInsertion = {}\nLF_stdHit = {}\nLF_zHit = {}\n",
                     grid.resolution_m, grid.insert_range_m, likelihood.hit_sigma_m,
                     likelihood.hit_weight);
}

// MRPT takes a plain pointer up to 2.5, a shared one later: whichever it declared.
auto TiledGridMap::internal_CreateFromMapDefinition(
    const mrpt::maps::TMetricMapInitializer& definition)
    -> decltype(internal_CreateFromMapDefinition(definition)) {
  using Result = decltype(internal_CreateFromMapDefinition(definition));
  const auto& d = dynamic_cast<const TMapDefinition&>(definition);
  return Result(new TiledGridMap(d.grid, d.likelihood));
}

TiledGridMap::TiledGridMap(const GridParams& params, const LikelihoodParams& likelihood)
    : TiledGridMap(OccupancyGrid(params), params, likelihood) {}

TiledGridMap::TiledGridMap(OccupancyGrid grid, const GridParams& params,
                           const LikelihoodParams& likelihood)
    : params_(params),
      likelihood_params_(likelihood),
      grid_(std::move(grid)),
      likelihood_(likelihood, params.field_sigma_m) {
  core::validateFields(likelihood, "likelihood");
}

bool TiledGridMap::isEmpty() const { return grid_.knownBox().empty(); }

std::string TiledGridMap::asString() const {
  const CellBox box = grid_.knownBox();
  return fmt::format("Tiled occupancy grid, {} x {} known cells of {} m", box.x1 - box.x0,
                     box.y1 - box.y0, grid_.resolution());
}

void TiledGridMap::saveMetricMapRepresentationToFile(const std::string& prefix) const {
  const std::string path = prefix + "_tiled.gridmap.gz";
  mrpt::io::CFileGZOutputStream file;
  if (!file.open(path)) throw core::Error("cannot write " + path);
  auto archive = mrpt::serialization::archiveFrom(file);
  archive << toMrpt(grid_);
}

void TiledGridMap::getVisualizationInto(mrpt::opengl::CSetOfObjects& out) const {
  toMrpt(grid_).getVisualizationInto(out);
}

void TiledGridMap::internal_clear() { grid_.clear(); }

namespace {

/// The scan when the observation is one that looks along the floor (upside down is fine).
const CObservation2DRangeScan* planarScan(const mrpt::obs::CObservation& observation) {
  const auto* scan = dynamic_cast<const CObservation2DRangeScan*>(&observation);
  return scan && scan->isPlanarScan(0.1) ? scan : nullptr;
}

}  // namespace

bool TiledGridMap::internal_insertObservation(
    const mrpt::obs::CObservation& observation,
    const std::optional<const mrpt::poses::CPose3D>& robot_pose) {
  const auto* scan = planarScan(observation);
  if (!scan) return false;
  const mrpt::math::TPose2D pose(robot_pose ? robot_pose->asTPose() : mrpt::math::TPose3D());
  grid_.insert(makeScanShape(*scan, params_), pose);
  return true;
}

bool TiledGridMap::internal_canComputeObservationLikelihood(
    const mrpt::obs::CObservation& observation) const {
  return planarScan(observation) != nullptr;
}

double TiledGridMap::internal_computeObservationLikelihood(
    const mrpt::obs::CObservation& observation, const mrpt::poses::CPose3D& taken_from) const {
  const auto* scan = planarScan(observation);
  if (!scan) return 0;
  const auto points = scanPoints(*scan, params_.insert_range_m);
  return likelihood_(grid_, points, mrpt::math::TPose2D(taken_from.asTPose()));
}

uint8_t TiledGridMap::serializeGetVersion() const { return 0; }

void TiledGridMap::serializeTo(mrpt::serialization::CArchive& out) const {
  out << params_.resolution_m << params_.insert_range_m << params_.free_probability
      << params_.occupied_probability << params_.no_return_free_m << params_.field_sigma_m
      << likelihood_params_.hit_sigma_m << likelihood_params_.hit_weight
      << likelihood_params_.unknown_share << toMrpt(grid_);
}

void TiledGridMap::serializeFrom(mrpt::serialization::CArchive& in, uint8_t version) {
  if (version != 0) MRPT_THROW_UNKNOWN_SERIALIZATION_VERSION(version);
  GridParams params;
  LikelihoodParams likelihood;
  COccupancyGridMap2D cells;
  in >> params.resolution_m >> params.insert_range_m >> params.free_probability >>
      params.occupied_probability >> params.no_return_free_m >> params.field_sigma_m >>
      likelihood.hit_sigma_m >> likelihood.hit_weight >> likelihood.unknown_share >> cells;
  *this = TiledGridMap(fromMrpt(cells, params), params, likelihood);
}

}  // namespace ariadne::grid
