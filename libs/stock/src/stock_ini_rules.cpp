#include "stock_ini_rules.h"

#include "ariadne/io/ini_fields.h"
#include "stock_ini_values.h"

namespace ariadne::stock {

using namespace io;  // its INIs are read as ours are

namespace {

void setProposal(StockState& s, const IniEntry& e) {
  const std::vector<std::string> names = {"pfStandardProposal", "pfAuxiliaryPFStandard",
                                          "pfOptimalProposal", "pfAuxiliaryPFOptimal"};
  const std::size_t algorithm = mrptEnum(e, names);
  s.params.filter.proposal =
      algorithm < 2 ? filter::Proposal::odometry : filter::Proposal::improved;
  if (algorithm == 1 || algorithm == 3)
    s.notes.push_back(
        fmt::format("{}: PF_algorithm {}: there is no auxiliary filter here; its "
                    "proposal is \"{}\"",
                    e.where, names[algorithm], algorithm == 1 ? "odometry" : "improved"));
}

void setResampling(StockState& s, const IniEntry& e) {
  using R = filter::Resampling;
  constexpr R kInMrptsOrder[] = {R::multinomial, R::residual, R::stratified, R::systematic};
  s.params.filter.resampling =
      kInMrptsOrder[mrptEnum(e, {"prMultinomial", "prResidual", "prStratified", "prSystematic"})];
}

void setSeed(StockState& s, const IniEntry& e) {
  const int seed = mrptInteger(e);  // negative: by the clock; here runs can be repeated
  if (seed >= 0) s.params.filter.seed = static_cast<std::uint64_t>(seed);
}

void checkFixedSize(StockState& s, const IniEntry& e) {
  if (mrptBool(e))
    s.notes.push_back(fmt::format(
        "{}: adaptiveSampleSize: the number of particles is fixed here, to sampleSize", e.where));
}

void checkOffset(StockState& s, const IniEntry& e) {
  if (mrptNumber(e) != 0)
    s.notes.push_back(fmt::format(
        "{}: rawlog_offset: nothing is skipped here, the log is read from its start", e.where));
}

/// Probability that an observation of a cell is right.
double certainty(const IniEntry& e) {
  const double p = mrptNumber(e);
  if (p < 0.5 || p > 1) throw entryError(e, "it takes a probability, 0.5 to 1");
  return p;
}

/// A field that takes the number as it is.
template <class T>
StockRule::Apply number(T StockState::*field) {
  return [field](StockState& s, const IniEntry& e) { s.*field = mrptNumber(e); };
}

std::vector<StockRule> makeRules() {
  using S = StockState;
  using E = IniEntry;
  return {
      {"", "rawlog_file", [](S& s, const E& e) { s.rawlog_file = e.value; }},
      {"", "logOutput_dir", [](S& s, const E& e) { s.output_folder = e.value; }},
      {"", "rawlog_offset", checkOffset},
      {"", "sampleSize", [](S& s, const E& e) { s.params.filter.particles = mrptInteger(e); }},
      {"", "adaptiveSampleSize", checkFixedSize},
      {"", "RANDOM_SEED", setSeed},
      {"", "PF_algorithm", setProposal},
      {"", "resamplingMethod", setResampling},
      {"", "BETA", [](S& s, const E& e) { s.params.filter.beta = mrptNumber(e); }},
      {"", "insertionLinDistance", number(&S::insertion_distance_m)},
      {"", "insertionAngDistance_deg", number(&S::insertion_angle_deg)},
      {"", "localizeLinDistance", number(&S::localize_distance_m)},
      {"", "localizeAngDistance_deg", number(&S::localize_angle_deg)},
      {"_creationOpts", "resolution",
       [](S& s, const E& e) { s.params.grid.resolution_m = mrptNumber(e); }},
      {"_insertOpts", "maxDistanceInsertion",
       [](S& s, const E& e) { s.params.grid.insert_range_m = mrptNumber(e); }},
      {"_insertOpts", "maxOccupancyUpdateCertainty",
       [](S& s, const E& e) { s.occupied = certainty(e); }},
      {"_insertOpts", "maxFreenessUpdateCertainty",
       [](S& s, const E& e) { s.free = mrptNumber(e) == 0 ? 0 : certainty(e); }},
      {"_insertOpts", "considerInvalidRangesAsFreeSpace",
       [](S& s, const E& e) { s.no_return_is_free = mrptBool(e); }},
  };
}

}  // namespace

const std::vector<StockRule>& stockRules() {
  static const std::vector<StockRule> rules = makeRules();
  return rules;
}

const std::vector<std::string>& stockKeysWithoutMeaning() {
  static const std::vector<std::string> keys = {
      // output and windows
      "LOG_FREQUENCY", "GENERATE_LOG_JOINT_H", "GENERATE_LOG_INFO", "SAVE_MAP_IMAGES",
      "SAVE_3D_SCENE", "SAVE_POSE_LOG", "SAVE_ENOSE_READINGS", "CAMERA_3DSCENE_FOLLOWS_ROBOT",
      "SHOW_PROGRESS_IN_WINDOW", "SHOW_PROGRESS_IN_WINDOW_DELAY_MS", "PROGRESS_WINDOW_WIDTH",
      "PROGRESS_WINDOW_HEIGHT", "verbosity_level", "verbosity", "disableSaveAs3DObject",
      // maps other than the grid, and which of them counts
      "likelihoodMapSelection", "enableInsertion_pointsMap", "enableInsertion_landmarksMap",
      "enableInsertion_gridMaps", "enableInsertion_gasGridMaps", "enableInsertion_beaconMap",
      "minDistBetweenLaserPoints", "fuseWithExisting", "isPlanarMap", "max_corr_distance",
      "sigma_dist",
      // the stock filter's own
      "powFactor",  // tempers another likelihood: ours has weight_gain, with its own default
      "pfAuxFilterOptimal_MaximumSearchSamples", "pfAuxFilterStandard_FirstStageWeightsMonteCarlo",
      "pfAuxFilterOptimal_MLE", "pfOptimalProposal_mapSelection", "max_loglikelihood_dyn_range",
      "KLD_maxSampleSize", "KLD_minSampleSize", "KLD_minSamplesPerBin", "KLD_binSize_XY",
      "KLD_binSize_PHI", "KLD_binSize_PHI_deg", "KLD_delta", "KLD_epsilon",
      "ICPGlobalAlign_MinQuality", "ICP_algorithm", "maxIterations", "thresholdDist",
      "thresholdAng_DEG", "ALFA", "smallestThresholdDist", "onlyClosestCorrespondences",
      // the stock grid's own
      "min_x", "max_x", "min_y", "max_y", "mapAltitude", "useMapAltitude",
      "maxFreenessInvalidRanges", "minLaserScanNoiseStd", "decimation", "horizontalTolerance",
      "wideningBeamsWithDistance", "CFD_features_gaussian_size", "CFD_features_median_size",
      "likelihoodMethod", "LF_decimation", "LF_stdHit", "LF_maxCorrsDistance", "LF_zHit",
      "LF_zRandom", "LF_maxRange", "LF_alternateAverageMethod", "LF_useSquareDist",
      "enableLikelihoodCache", "MI_exponent", "MI_skip_rays", "MI_ratio_max_distance",
      "rayTracing_useDistanceFilter", "rayTracing_decimation", "rayTracing_stdHit",
      "consensus_takeEachRange", "consensus_pow",
      // continuing an older map
      "METRIC_MAP_CONTINUATION_GRIDMAP_FILE", "SIMPLEMAP_CONTINUATION",
      "METRIC_MAP_CONTINUATION_START_POSE_X", "METRIC_MAP_CONTINUATION_START_POSE_Y",
      "METRIC_MAP_CONTINUATION_START_POSE_PHI_DEG"};
  return keys;
}

}  // namespace ariadne::stock
