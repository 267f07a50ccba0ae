// Drawn maps: every pixel is what the cells under it say, through tiles, thinning and PNG.
#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "ariadne/io/whole_file.h"
#include "map_film.h"
#include "map_halving.h"
#include "replay_fixture.h"
#include "thinning.h"
#include "tile_atlas.h"

using namespace ariadne;
using namespace ariadne::report;

namespace {

/// A pixel of a keyframe's map, by its place from the map's origin.
MapPixel pixelAt(const std::vector<PlacedTile>& map, const std::vector<ReplayTile>& tiles, int x,
                 int y) {
  for (const PlacedTile& t : map)
    if (t.x == x >> 5 && t.y == y >> 5)
      return static_cast<MapPixel>(unpack(tiles[t.tile])[(y & 31) * kReplayTile + (x & 31)]);
  return MapPixel::unknown;
}

/// The most occupied of the cells under a pixel, else free if one is.
MapPixel expectedAt(const grid::OccupancyGrid& map, int x, int y, int cells) {
  bool free = false;
  for (int j = 0; j < cells; ++j)
    for (int i = 0; i < cells; ++i) {
      const auto l = map.at({x * cells + i, y * cells + j});
      if (l < 0) return MapPixel::occupied;
      free = free || l > 0;
    }
  return free ? MapPixel::free : MapPixel::unknown;
}

void expectSame(const Replay& replay, const grid::OccupancyGrid& map, int cells) {
  const ReplayFrame& frame = replay.frames.back();
  std::size_t known = 0;
  for (int y = -420 / cells; y < 420 / cells; ++y)
    for (int x = -420 / cells; x < 420 / cells; ++x) {
      const MapPixel expected = expectedAt(map, x, y, cells);
      ASSERT_EQ(pixelAt(frame.map, replay.tiles, x, y), expected) << x << ", " << y;
      known += expected != MapPixel::unknown;
    }
  EXPECT_GT(known, 1000U);
}

/// A circle of 5 m, a map of 30 m at 0.05 m.
Replay filmed(test::MadeUpRun& run, const RecorderParams& params) {
  ReplayRecorder recorder(params);
  for (int i = 0; i < 100; ++i) run.update(recorder, 100);
  return recorder.finish(run.view());
}

}  // namespace

TEST(MapFilm, ShowsTheCells) {
  test::MadeUpRun run(2, 5);
  const Replay replay = filmed(run, {});
  EXPECT_DOUBLE_EQ(replay.pixel_m, 0.05);
  expectSame(replay, run.best().map, 1);
}

TEST(MapFilm, ALargeMapGetsLargerPixelsOnTheWay) {
  test::MadeUpRun run(2, 5);
  RecorderParams params;
  params.max_side_px = 200;
  const Replay replay = filmed(run, params);
  EXPECT_DOUBLE_EQ(replay.pixel_m, 0.2);
  EXPECT_LE(sideOf(replay.frames.back().map), 200);
  expectSame(replay, run.best().map, 4);
}

// Of kilometres: a pixel is wider than a tile of the map.
TEST(MapFilm, PixelsMayBeOfManyTiles) {
  constexpr int kLevel = 7;
  grid::OccupancyGrid map;
  for (int i = 0; i < 300; ++i)
    map.set({i * i * 17 % 9000 - 4500, i * 7919 % 9000 - 4500},
            static_cast<std::int8_t>(i % 4 == 0 ? -60 : 40));
  TileStore store;
  MapFilm film;
  film.restart(kLevel);
  const auto placed = film.take(map, store);
  for (int y = -40; y < 40; ++y)
    for (int x = -40; x < 40; ++x)
      ASSERT_EQ(pixelAt(placed, store.tiles(), x, y), expectedAt(map, x, y, 1 << kLevel))
          << x << ", " << y;
}

TEST(MapFilm, EarlyKeyframesAreHalvedAsIfDrawnSo) {
  test::MadeUpRun run(1, 5);
  ReplayRecorder fine;
  run.update(fine, 3000);
  Replay early = fine.finish(run.view());
  TileStore store;
  for (const ReplayTile& t : early.tiles) store.add(t);
  halve(early.frames, store);
  early.tiles = store.tiles();
  expectSame(early, run.best().map, 2);
}

TEST(MapFilm, ThinningLosesNoPixelOfWhatStays) {
  test::MadeUpRun run(2, 5);
  RecorderParams params;
  params.max_frames = 6;
  params.updates_a_frame = 1;
  const Replay replay = filmed(run, params);
  EXPECT_LE(replay.frames.size(), 7U);
  expectSame(replay, run.best().map, 1);
}

TEST(MapFilm, AnotherBestParticleShowsItsOwnMap) {
  test::MadeUpRun run(2, 5);
  ReplayRecorder recorder;
  for (int i = 0; i < 20; ++i) run.update(recorder, 500);
  grid::OccupancyGrid other;
  for (int i = 0; i < 2000; ++i) other.set({i % 80, i / 80}, -50);
  run.best().map = other;
  run.update(recorder, 0);
  expectSame(recorder.finish(run.view()), other, 1);
}

TEST(TileAtlas, PngsHoldTheTiles) {
  std::vector<ReplayTile> tiles(kTilesPerPicture + 2);
  tiles.back() = pack([] {
    TilePixels pixels{};
    pixels[0] = 1;
    pixels[33] = 2;
    return pixels;
  }());
  const auto pictures = tilePictures(tiles);
  ASSERT_EQ(pictures.size(), 2U);
  const std::string head = "data:image/png;base64,";
  ASSERT_EQ(pictures[1].rfind(head, 0), 0U);
  // Decoded by other hands: those of coreutils and of MRPT.
  const std::string file =
      (std::filesystem::temp_directory_path() / ("ariadne-atlas-" + std::to_string(::getpid())))
          .string();
  io::writeWhole(file + ".txt", pictures[1].substr(head.size()));
  ASSERT_EQ(std::system(("base64 -d " + file + ".txt > " + file + ".png").c_str()), 0);
  const auto image = mrpt::img::CImage::LoadFromFile(file + ".png");
  ASSERT_EQ(image.getWidth(), 1024U);
  ASSERT_EQ(image.getHeight(), 2U);
  EXPECT_EQ(*image(0, 1), 85);
  EXPECT_EQ(*image(33, 1), 170);
  EXPECT_EQ(*image(34, 1), 0);
  std::filesystem::remove(file + ".txt");
  std::filesystem::remove(file + ".png");
}

TEST(TileAtlas, Base64IsRfc4648) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64(std::string("\xff\xfe\x00", 3)), "//4A");
}
