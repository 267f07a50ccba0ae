#include "ariadne/batch/plots.h"

#include <fmt/format.h>

#include "ariadne/charts/gnuplot.h"
#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"
#include "plot_script.h"

namespace ariadne::batch {
namespace fs = std::filesystem;

std::vector<Picture> drawPlots(const std::vector<Plot>& plots) {
  if (plots.empty()) return {};
  std::vector<std::string> names;
  for (const Plot& plot : plots)
    names.insert(names.end(), {plot.name + ".svg", plot.name + ".png"});
  const auto files = charts::drawnFiles(
      names, [&](const fs::path& folder) { return gnuplotScript(plots, folder); });
  std::vector<Picture> pictures;
  for (std::size_t i = 0; i < plots.size(); ++i)
    pictures.push_back({plots[i].name, files[2 * i], files[2 * i + 1]});
  return pictures;
}

void writePictures(const std::vector<Picture>& pictures, const fs::path& folder) {
  if (pictures.empty()) return;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw core::Error(
        fmt::format("cannot make the folder {}: {}", folder.string(), error.message()));
  for (const Picture& picture : pictures) {
    io::writeWhole(folder / (picture.name + ".svg"), picture.svg);
    io::writeWhole(folder / (picture.name + ".png"), picture.png);
  }
}

}  // namespace ariadne::batch
