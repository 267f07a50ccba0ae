// Mutated logs end in steps that keep the contract, or in core::Error; nothing else may happen.
// ARIADNE_FUZZ_ROUNDS makes it longer.
#include <zlib.h>

#include "ariadne/core/random.h"
#include "sample_logs.h"
#include "temporary_folder.h"

using namespace sample;  // NOLINT: a test of these samples

class DatasetFuzz : public TemporaryFolder {
 protected:
  using Random = ariadne::core::RandomStream;

  static std::uint32_t rounds() {
    const char* given = std::getenv("ARIADNE_FUZZ_ROUNDS");
    return given != nullptr ? static_cast<std::uint32_t>(std::atoi(given)) : 300;
  }

  static std::string mutate(std::string bytes, Random& random) {
    const std::uint32_t edits = 1 + random.bits() % 4;
    for (std::uint32_t k = 0; k < edits && !bytes.empty(); ++k) {
      const std::size_t at = random.bits() % bytes.size();
      const std::size_t length = std::min<std::size_t>(random.bits() % 200, bytes.size() - at);
      switch (random.bits() % 6) {
        case 0:
          bytes[at] = static_cast<char>(random.bits());
          break;
        case 1:
          bytes[at] = static_cast<char>(bytes[at] ^ (1 << random.bits() % 8));
          break;
        case 2:
          bytes.resize(at);
          break;
        case 3:
          bytes.insert(at, bytes.substr(at, length));
          break;
        case 4:
          bytes.erase(at, length);
          break;
        default:
          bytes.replace(at, std::min<std::size_t>(4, length), "\xff\xff\xff\xff");
      }
    }
    return bytes;
  }

  static void expectContract(const Result& r) {
    double before = -1e300;
    std::size_t set_backs = 0;
    for (const auto& step : r.steps) {
      ASSERT_TRUE(std::isfinite(step.time_s));
      set_backs += step.time_s < before;
      before = step.time_s;
      const auto& p = step.odom_from_robot;
      ASSERT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.phi));
      const auto& s = *step.scan;
      ASSERT_TRUE(s.maxRange > 0 && s.aperture > 0 && s.getScanSize() >= 2);
      for (std::size_t i = 0; i < s.getScanSize(); ++i) {
        const float range = s.getScanRange(i);
        const bool within = range > 0 && range < s.maxRange;
        ASSERT_EQ(s.getScanRangeValidity(i), within);
        ASSERT_TRUE(within || range == 0 || range >= s.maxRange);
      }
    }
    ASSERT_LE(set_backs, r.counts.scan_clock.count + (r.error.empty() ? 0 : r.steps.size()));
    ASSERT_TRUE(!r.error.empty() || !r.steps.empty());
  }

  void fuzz(const std::string& whole, std::uint32_t seed) {
    expectContract(readBytes(folder / "a", whole));
    for (std::uint32_t round = 0; round < rounds(); ++round) {
      Random random(seed, round, 0, ariadne::core::Purpose::test);
      SCOPED_TRACE(round);
      expectContract(readBytes(folder / "a", mutate(whole, random)));
      if (HasFatalFailure()) return;
    }
  }
};

TEST_F(DatasetFuzz, Pairs) { fuzz(pairsLog(8), 1); }
TEST_F(DatasetFuzz, Observations) { fuzz(observationsLog(8), 2); }
TEST_F(DatasetFuzz, Carmen) { fuzz(carmenLog(8), 3); }

TEST_F(DatasetFuzz, Robotlaser) {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += fmt::format(
        "ROBOTLASER1 0 -1.57 3.14 0.785 20 0.01 0 5 1 2 3 20 25 2 7 7 {0} 0 0 {0} 0 0 0 0 0 0 0 "
        "{1:.3f} h 1\n",
        0.1 * i, kBegin_s + i);
  fuzz(text, 4);
}

TEST_F(DatasetFuzz, WithOtherObservations) {
  Rawlog log;
  const auto other = std::make_shared<mrpt::obs::CObservationIMU>(imu());
  for (int i = 0; i < 5; ++i)
    log.add(action({0.1, 0, 0})).add(imu()).frame({other, scan(kBegin_s + i), other});
  fuzz(log.bytes(), 5);
}

TEST_F(DatasetFuzz, Compressed) {
  const std::string bytes = pairsLog(40);
  gzFile file = gzopen((folder / "b").c_str(), "wb");
  gzwrite(file, bytes.data(), static_cast<unsigned>(bytes.size()));
  gzclose(file);
  fuzz(io::readWhole(folder / "b"), 6);
}

TEST_F(DatasetFuzz, OldVersionsOfTheClasses) {
  if (!std::filesystem::exists(kMrptSample)) GTEST_SKIP() << "package mrpt-common is missing";
  std::string bytes;
  gzFile file = gzopen(kMrptSample, "rb");
  bytes.resize(30'000);
  bytes.resize(static_cast<std::size_t>(gzread(file, bytes.data(), 30'000)));
  gzclose(file);
  fuzz(bytes, 7);
}
