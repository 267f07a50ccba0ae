// How much of a log was read is told by what was given out, not by what zlib or we read ahead.
#include <zlib.h>

#include "temporary_folder.h"
#include "walled_log.h"

using namespace sample;  // NOLINT: a test of these samples

class ReadingProgress : public TemporaryFolder {
 protected:
  static std::string packed(const std::string& bytes, const std::filesystem::path& path) {
    gzFile file = gzopen(path.c_str(), "wb");
    gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
    gzclose(file);
    return io::readWhole(path);
  }
  /// After each scan as much as its place among them says, within a block of the file.
  void expectTrue(const std::string& bytes) {
    io::writeWhole(folder / "a", bytes);
    const std::size_t count = read(folder / "a").steps.size();
    const auto source = io::openDataset(folder / "a");
    double before = 0;
    for (std::size_t i = 1; source->next(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(count);
      // The third scan after it lets a scan pass.
      ASSERT_NEAR(source->fraction(), share, 4.0 / static_cast<double>(count) + 0.06) << i;
      ASSERT_GE(source->fraction(), before);
      before = source->fraction();
    }
    EXPECT_EQ(source->fraction(), 1);
  }
};

TEST_F(ReadingProgress, OfSmallAndLargeFilesPackedOrNot) {
  const auto poses = driveAlong({{-9, -4}, {9, -4}, {9, 4}, {-9, 4}});
  Laser noisy;
  noisy.noise_m = 0.01;
  const std::string rawlog = walledLog(room(30, 20), poses, noisy);
  for (const std::string& log : {rawlog, carmenLog(60), carmenLog(600)}) {
    expectTrue(log);
    // Lines alike pack to little: of a packed toy the first lines are most of the bytes.
    if (log.size() > 500'000) expectTrue(packed(log, folder / "b"));
  }
}
