#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "../pixels_of.h"
#include "ariadne/core/error.h"
#include "ariadne/report/topology.h"

namespace fs = std::filesystem;
using namespace ariadne;
using test::pixelsOf;

namespace {

const fs::path kFile =
    fs::temp_directory_path() / ("ariadne-loops-" + std::to_string(::getpid()) + ".png");

mrpt::maps::COccupancyGridMap2D room() {
  mrpt::maps::COccupancyGridMap2D map(0, 10, 0, 8, 0.1f);
  map.fill(0.9f);
  return map;
}

}  // namespace

TEST(TopologyPicture, ShowsWaysShortcutsAndEntries) {
  report::DrawnGraph g;
  g.places = {{1, 1}, {8, 1}, {8, 6}, {1, 6}};
  g.edges = {{0, 1}, {1, 2}, {2, 3}};
  report::writeTopology(kFile, room(), g);
  const auto red = pixelsOf(kFile, 0.75, 0.1, 0.1);
  report::writeTopology(kFile, room(), g);
  const auto legend = pixelsOf(kFile, 0.1, 0.3, 0.85);
  g.shortcuts = {{3, 0}};
  g.entries = {{{1, 1}, 0}};
  report::writeTopology(kFile, room(), g);
  EXPECT_GT(red, 1000U);
  EXPECT_GT(pixelsOf(kFile, 0.1, 0.3, 0.85), legend + 500) << "5 m of blue line";
}

TEST(TopologyPicture, EntriesAtOneSpotStandSideBySide) {
  report::DrawnGraph g;
  g.places = {{5, 4}};
  g.entries = {{{5, 4}, 0}};
  report::writeTopology(kFile, room(), g);
  const auto one = pixelsOf(kFile, 0.1, 0.3, 0.85);
  g.entries = {{{5, 4}, 0}, {{5, 4}, 3}, {{5.02, 4}, 12}};
  report::writeTopology(kFile, room(), g);
  EXPECT_GT(pixelsOf(kFile, 0.1, 0.3, 0.85), one + 250) << "two more discs of over 150 pixels";
}

TEST(TopologyPicture, ErrorsNameTheFileAndLeaveNothing) {
  EXPECT_THROW(report::writeTopology("/nowhere/at/all.png", room(), {}), core::Error);
  mrpt::maps::COccupancyGridMap2D nothing;
  nothing.setSize(0, 0.02f, 0, 0.02f, 0.1f);
  try {
    report::writeTopology(kFile, nothing, {});
    ADD_FAILURE() << "no core::Error";
  } catch (const core::Error& e) {
    EXPECT_NE(std::string(e.what()).find(kFile.string()), std::string::npos) << e.what();
  }
  EXPECT_FALSE(fs::exists(kFile));
}
