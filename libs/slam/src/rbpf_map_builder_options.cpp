// Stock construction options in Ariadne's terms.
#include <mrpt/maps/COccupancyGridMap2D.h>

#include <algorithm>

#include "ariadne/grid/map/tiled_grid_map.h"
#include "ariadne/slam/rbpf_map_builder.h"

namespace ariadne::slam {
namespace {

using mrpt::bayes::CParticleFilter;

void takeFilter(const CParticleFilter::TParticleFilterOptions& options, filter::FilterParams& p) {
  p.particles = static_cast<int>(options.sampleSize);
  p.beta = options.BETA;
  p.proposal = options.PF_algorithm == CParticleFilter::pfStandardProposal ||
                       options.PF_algorithm == CParticleFilter::pfAuxiliaryPFStandard
                   ? filter::Proposal::odometry
                   : filter::Proposal::improved;
  switch (options.resamplingMethod) {
    case CParticleFilter::prMultinomial:
      p.resampling = filter::Resampling::multinomial;
      break;
    case CParticleFilter::prResidual:
      p.resampling = filter::Resampling::residual;
      break;
    case CParticleFilter::prStratified:
      p.resampling = filter::Resampling::stratified;
      break;
    case CParticleFilter::prSystematic:
      p.resampling = filter::Resampling::systematic;
      break;
  }
}

/// The first grid of the list, MRPT's or ours.
void takeGrid(const mrpt::maps::TSetOfMetricMapInitializers& maps, SlamParams& p) {
  using Stock = mrpt::maps::COccupancyGridMap2D::TMapDefinition;
  using Tiled = grid::TiledGridMap::TMapDefinition;
  for (const auto& map : maps) {
    if (const auto* tiled = dynamic_cast<const Tiled*>(map.get())) {
      p.grid = tiled->grid;
      p.likelihood = tiled->likelihood;
      return;
    }
    if (const auto* stock = dynamic_cast<const Stock*>(map.get())) {
      // Floats of the INI: 0.05, not 0.0500000007.
      p.grid.resolution_m = std::round(stock->resolution * 1e6) / 1e6;
      p.grid.insert_range_m = std::round(stock->insertionOpts.maxDistanceInsertion * 1e4) / 1e4;
      grid::setUpdateCertainty(p.grid, stock->insertionOpts.maxOccupancyUpdateCertainty);
      return;
    }
  }
}

}  // namespace

void RbpfMapBuilder::TConstructionOptions::loadFromConfigFile(
    const mrpt::config::CConfigFileBase& source, const std::string& section) {
  grid::registerTiledGridMap();
  mrpt::slam::CMetricMapBuilderRBPF::TConstructionOptions::loadFromConfigFile(source, section);
}

SlamParams RbpfMapBuilder::TConstructionOptions::resolved() const {
  SlamParams p = params;
  takeFilter(PF_options, p.filter);
  takeGrid(mapsInitializers, p);
  // Localising and inserting are one update here, as often as the more frequent of the two.
  p.update.update_distance_m = std::min(insertionLinDistance, localizeLinDistance);
  p.update.update_angle_deg = mrpt::RAD2DEG(std::min(insertionAngDistance, localizeAngDistance));
  return p;
}

}  // namespace ariadne::slam
