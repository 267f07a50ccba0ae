#include "parameters_page.h"

#include "ariadne/io/ini_writer.h"
#include "config.h"

namespace ariadne::slam_app {
namespace {

constexpr const char* kHead = R"(# Parameters of ariadne-slam

Made by `scripts/renew-parameters`; a test compares it with the program.

A value comes from the defaults below, then the INI, then `--set section.key=value` (in order), then
the dedicated options (`--particles`, `--seed`, `--threads`, `--out`, `--no-pictures`, DATASET). The
result is written beside the maps as config.ini.

An unknown section or key, one that comes twice, a value of the wrong kind or out of bounds is an
error that says where it stands and what would be right. Comments are lines that start with `;`, `#`
or `//`, or follow a value after a blank. A text that holds one of these after a blank stands in
double quotes.

`include = OTHER.ini` before the first section, once or more, puts the settings of other INIs before the INI's own;
what both set is the INI's own. Relative paths start at the folder of the INI that is named on the
command line.

[What the words mean](../explanation/concepts.md#glossary); "the paper" and
[[19]](../explanation/bibliography.md#19-stachniss-2004).
)";

constexpr const char* kStock = R"(
## INIs of MRPT's rbpf-slam

An INI with a section [MappingApplication] is read as MRPT reads it. These keys have a meaning here;
the others are named in a warning. Maps that are no 2D laser grid (beacons, landmarks, gas) are an
error; a points map becomes a grid.

| key of rbpf-slam | here |
|---|---|
| `rawlog_file` | [dataset] `file`; looked for from the current folder, beside the INI, in /usr/share/mrpt/datasets |
| `logOutput_dir` | [run] `out`; nothing in it is deleted |
| `sampleSize` | [filter] `particles` |
| `RANDOM_SEED` | [filter] `seed`; negative: the default |
| `PF_algorithm` | [filter] `proposal`: 0 and 1 odometry, 2 and 3 improved |
| `resamplingMethod`, `BETA` | [filter] `resampling`, `beta` |
| `insertionLinDistance`, `localizeLinDistance` | [update] `update_distance_m`: the shorter one; an update does both |
| `insertionAngDistance_deg`, `localizeAngDistance_deg` | [update] `update_angle_deg`: the smaller one |
| `resolution` | [grid] `resolution_m` |
| `maxDistanceInsertion` | [grid] `insert_range_m` |
| `maxOccupancyUpdateCertainty` = p | [grid] `occupied_probability` = p^3 / (p^3 + (1-p)^3), as MRPT inserts endpoints with three times the log odds; `free_probability` = p |
| `maxFreenessUpdateCertainty` | [grid] `free_probability`, if not 0 |
| `considerInvalidRangesAsFreeSpace` | [grid] `no_return_free_m`: 3, or 0 |

Matching and likelihood (`LF_*`, `ICP_*`, ...) are this program's own: [matcher] keeps its defaults.
)";

}  // namespace

std::string parametersPage() { return io::writeMarkdown(SlamConfig(), kHead) + kStock; }

}  // namespace ariadne::slam_app
