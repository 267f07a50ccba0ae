// Ariadne behind MRPT's interface: a program written for mrpt::slam::CMetricMapBuilderRBPF takes it
// with a changed type and include (examples/mrpt_map_builder.cpp is one).
#pragma once
#include <mrpt/maps/CMultiMetricMap.h>
#include <mrpt/slam/CMetricMapBuilder.h>
#include <mrpt/slam/CMetricMapBuilderRBPF.h>

#include <deque>
#include <memory>
#include <string>
#include <utility>

#include "ariadne/slam/mapper.h"

namespace ariadne::slam {

/// Stands in for MRPT's CMetricMapBuilderRBPF: the same interface, our filter behind it.
class RbpfMapBuilder : public mrpt::slam::CMetricMapBuilder {
 public:
  /// What CMetricMapBuilderRBPF is built from, and Ariadne's own parameters. loadFromConfigFile()
  /// reads the stock section and derives from it what has a meaning here.
  struct TConstructionOptions : mrpt::slam::CMetricMapBuilderRBPF::TConstructionOptions {
    /// @param section of rbpf-slam's INI, MappingApplication in MRPT's own
    void loadFromConfigFile(const mrpt::config::CConfigFileBase& source,
                            const std::string& section) override;
    /// Particles, resampling and beta of PF_options, the distances, and the resolution, range and
    /// certainty of the first grid, over `params`.
    SlamParams resolved() const;

    SlamParams params;
    int threads = 1;
  };

  /// Throws core::UsageError when a parameter is out of bounds.
  explicit RbpfMapBuilder(const TConstructionOptions& options);
  ~RbpfMapBuilder() override;

  /// Starts anew: at x0, else at the last pose of the map, else at the origin.
  void initialize(const mrpt::maps::CSimpleMap& initial_map = mrpt::maps::CSimpleMap(),
                  const mrpt::poses::CPosePDF* x0 = nullptr) override;
  /// Particles with their weights, moved along by the odometry since the last update.
  mrpt::poses::CPose3DPDF::Ptr getCurrentPoseEstimation() const override;
  /// Takes the odometry of the action (2D or 3D) and the first planar scan of the observations.
  void processActionObservation(mrpt::obs::CActionCollection& action,
                                mrpt::obs::CSensoryFrame& observations) override;
  /// Scans with their poses on the path of s*.
  void getCurrentlyBuiltMap(mrpt::maps::CSimpleMap& out_map) const override;
  /// Scans in the map.
  unsigned int getCurrentlyBuiltMapSize() override;
  /// The map of s* as a COccupancyGridMap2D; valid until the next step. A pointer up to MRPT 2.5, a
  /// reference later.
  using BuiltMap =
      decltype(std::declval<const mrpt::slam::CMetricMapBuilder&>().getCurrentlyBuiltMetricMap());
  /// See BuiltMap.
  BuiltMap getCurrentlyBuiltMetricMap() const override;
  /// Writes a PNG of the map of s*. Throws core::Error when it cannot be written.
  void saveCurrentEstimationToImage(const std::string& file, bool formatEMF_BMP = true) override;

  /// Poses of s* at the filter updates.
  void getCurrentMostLikelyPath(std::deque<mrpt::math::TPose3D>& out_path) const;
  /// One line a particle: x y heading of each filter update.
  void saveCurrentPathEstimationToTextFile(const std::string& file);

  /// The hypotheses; the part of CMultiMetricMapPDF that programs ask.
  const filter::ParticleSet& particles() const { return mapper_->particles(); }

  /// As in CMetricMapBuilderRBPF: whether the last step entered the maps.
  mrpt::slam::CMetricMapBuilderRBPF::TStats m_statsLastIteration;

 private:
  std::deque<mrpt::math::TPose3D> updatesOf(std::size_t particle) const;

  SlamParams params_;
  int threads_;
  std::size_t initial_size_ = 0;  ///< scans of the map it began with
  std::unique_ptr<Mapper> mapper_;
  mrpt::math::TPose2D odom_from_robot_;  // all actions since initialize()
  mrpt::math::TPose2D odom_at_update_;
  double steps_ = 0;  // stands in for time where an observation has none
  mutable std::unique_ptr<mrpt::maps::CMultiMetricMap> metric_map_;  // made when asked for
};

}  // namespace ariadne::slam
