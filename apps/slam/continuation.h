// Going on in the map of a finished run: what is known, and where in it the new log begins.
#pragma once
#include <mrpt/maps/CSimpleMap.h>
#include <mrpt/math/TPose2D.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "ariadne/core/fields.h"
#include "ariadne/io/dataset.h"

namespace ariadne::slam_app {

struct SlamConfig;

struct ContinueParams {
  std::string run;
  std::string start;
};

template <class V>
void visitFields(V& v, ContinueParams& p) {
  v.text("run", p.run,
         "folder of a finished run, or a .simplemap, whose map is gone on with; a relative path "
         "starts at the INI's folder, or at the current one on the command line; empty: a new map");
  v.text("start", p.start,
         "where the robot is in that map at the log's first scan, x,y,deg in m and degrees, to 1 m "
         "and 15 degrees; empty: it is searched for over all free space of the map");
}

/// Nothing known: a new map from the origin.
struct Continuation {
  std::string map_file;  ///< empty: a new map
  mrpt::maps::CSimpleMap known;
  std::size_t scans = 0;      ///< of the known map
  mrpt::math::TPose2D start;  ///< map_from_robot at the first scan
  bool searched = false;      ///< over the whole map
  double field = 0;           ///< mean of the likelihood field under the first metres, 0 to 1
  std::string note;           ///< what to tell of it; empty: nothing
};

/// The .simplemap that `run` means. Throws core::Error when there is none.
std::filesystem::path simplemapOf(const std::filesystem::path& run);

/// Of [continue]; reads the log's first metres, so `source` is of no other use after that.
/// Throws core::Error when the start is not found, core::UsageError when it is not written right.
Continuation continuationOf(const SlamConfig& config, io::StepSource& source);

}  // namespace ariadne::slam_app
