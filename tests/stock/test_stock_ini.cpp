// Every INI that the package mrpt-common ships for rbpf-slam, and single keys.
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "../io/temporary_folder.h"
#include "ariadne/core/error.h"
#include "ariadne/core/random.h"
#include "ariadne/stock/stock_ini.h"

namespace fs = std::filesystem;
using namespace ariadne;
using stock::readStockIni;
using stock::StockIni;

namespace {

const fs::path kShipped = "/usr/share/mrpt/config_files/rbpf-slam";

StockIni shipped(const std::string& name) {
  return readStockIni(io::readIniText(kShipped / name), kShipped / name);
}

StockIni stockOf(const std::string& keys) {
  return readStockIni("[MappingApplication]\n" + keys, "/tmp/a.ini");
}

std::string stockComplaint(const std::string& keys) {
  try {
    stockOf(keys);
  } catch (const core::UsageError& e) {
    return e.what();
  }
  return "";
}

std::string allOf(const std::vector<std::string>& lines) {
  std::string out;
  for (const std::string& line : lines) out += line + "\n";
  return out;
}

}  // namespace

TEST(StockIni, AllShippedForLasersLoadAndOthersSayWhy) {
  if (!fs::exists(kShipped)) GTEST_SKIP() << "the package mrpt-common is not installed";
  const std::set<std::string> others = {"RO-SLAM_simulatedData_MC.ini",
                                        "RO-SLAM_simulatedData_SOG.ini",
                                        "gas_mapping_2lasers_2enoses.ini"};
  int loaded = 0;
  for (const auto& file : fs::directory_iterator(kShipped)) {
    const std::string name = file.path().filename().string();
    if (file.path().extension() != ".ini") continue;
    SCOPED_TRACE(name);
    if (others.count(name) != 0) {
      EXPECT_THROW(shipped(name), core::UsageError);
      continue;
    }
    const StockIni ini = shipped(name);
    ++loaded;
    EXPECT_GT(ini.params.filter.particles, 5);
    EXPECT_FALSE(ini.rawlog_file.empty());
    EXPECT_EQ(allOf(ini.warnings).find("no key of rbpf-slam"), std::string::npos)
        << allOf(ini.warnings);
  }
  EXPECT_GE(loaded, 6);
}

TEST(StockIni, ValuesArriveWhereTheyBelong) {
  if (!fs::exists(kShipped)) GTEST_SKIP() << "the package mrpt-common is not installed";
  const StockIni ini = shipped("gridmapping_optimal_sampling.ini");
  const slam::SlamParams& p = ini.params;
  EXPECT_EQ(p.filter.particles, 25);
  EXPECT_EQ(p.filter.beta, 0.5);
  EXPECT_EQ(p.filter.weight_gain,
            filter::FilterParams().weight_gain);  // powFactor is another scale
  EXPECT_EQ(p.filter.proposal, filter::Proposal::improved);
  EXPECT_EQ(p.filter.resampling, filter::Resampling::multinomial);
  EXPECT_EQ(p.update.update_distance_m, 1);
  EXPECT_EQ(p.update.update_angle_deg, 40);
  EXPECT_EQ(p.grid.resolution_m, 0.07);
  EXPECT_EQ(p.grid.insert_range_m, 35);
  EXPECT_EQ(p.grid.free_probability, 0.6);
  EXPECT_NEAR(p.grid.occupied_probability, 0.7714, 1e-4);  // 0.6^3 / (0.6^3 + 0.4^3)
  EXPECT_EQ(ini.output_folder, "LOG_GRIDMAPPING");
  EXPECT_TRUE(fs::exists(ini.rawlog_file)) << ini.rawlog_file;
}

TEST(StockIni, KeysWithoutMeaningAreNamedOnce) {
  const StockIni ini = stockOf("LOG_FREQUENCY=1\nSAVE_3D_SCENE=1\nLF_zHit=1\nLOG_FREQUENCY=2\n");
  ASSERT_EQ(ini.warnings.size(), 1U) << allOf(ini.warnings);
  EXPECT_EQ(ini.warnings[0], "a.ini: without meaning here: LOG_FREQUENCY, SAVE_3D_SCENE, LF_zHit");
}

TEST(StockIni, TyposAreTold) {
  const StockIni ini = stockOf("sampelSize = 20\n");
  ASSERT_EQ(ini.warnings.size(), 1U);
  EXPECT_EQ(ini.warnings[0],
            "a.ini:2: [MappingApplication] sampelSize: no key of rbpf-slam; the nearest is "
            "\"sampleSize\"");
}

TEST(StockIni, ReadsValuesAsMrptDoes) {
  const slam::SlamParams p =
      stockOf(
          "sampleSize = 12abc // twelve\nBETA=0.25// no blank\npf_algorithm = pfOptimalProposal\n"
          "resamplingMethod=2\t\t// stratified\nRANDOM_SEED = 7\n")
          .params;
  EXPECT_EQ(p.filter.particles, 12);
  EXPECT_EQ(p.filter.beta, 0.25);
  EXPECT_EQ(p.filter.proposal, filter::Proposal::improved);
  EXPECT_EQ(p.filter.resampling, filter::Resampling::stratified);
  EXPECT_EQ(p.filter.seed, 7U);
  EXPECT_EQ(stockOf("PF_algorithm=0\n").params.filter.proposal, filter::Proposal::odometry);
  EXPECT_EQ(stockOf("@define N 9\nsampleSize = $eval{N*2}\n").params.filter.particles, 18);
  EXPECT_EQ(stockOf("RANDOM_SEED=-1\n").params.filter.seed, filter::FilterParams().seed);
}

TEST(StockIni, ASmallFileDoesNotBecomeGigabytes) {
  std::string text = "@define a " + std::string(60000, 'x') + "\n";
  for (int i = 0; i < 40000; ++i) text += "${a}\n";  // 2.4 GB of 0.3 MB
  try {
    stockOf(text);
    FAIL();
  } catch (const core::UsageError& e) {
    EXPECT_NE(std::string(e.what()).find("a.ini: 40000 times ${name}"), std::string::npos)
        << e.what();
  }
}

TEST(StockIni, RubbishIsAnErrorWithItsPlace) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"sampleSize = many\n", "a.ini:2: [MappingApplication] sampleSize = many: it takes a number"},
      {"sampleSize = 0\n", "a.ini:2: [MappingApplication] sampleSize = 0: here [filter] particles"},
      {"BETA = nan\n", "a.ini:2: [MappingApplication] BETA = nan: it takes a number"},
      {"PF_algorithm = 7\n", "a.ini:2: [MappingApplication] PF_algorithm = 7: it takes one of pfS"},
      {"PF_algorithm = pfOptimal\n", "a.ini:2: [MappingApplication] PF_algorithm = pfOptimal: it"},
      {"beaconMap_count = 1\n", "a.ini:2: [MappingApplication] beaconMap_count = 1: only 2D laser"},
      {"occupancyGrid_count = 0\npointsMap_count=0\n", "a.ini: [MappingApplication] asks for nei"},
      {"[M_occupancyGrid_00_insertOpts]\nmaxOccupancyUpdateCertainty = 60\n",
       "a.ini:3: [M_occupancyGrid_00_insertOpts] maxOccupancyUpdateCertainty = 60: it takes a pr"},
      {"localizeLinDistance = -3\n", "[update] update_distance_m = -3 is out of bounds"}};
  for (const auto& [keys, expected] : cases)
    EXPECT_EQ(stockComplaint(keys).substr(0, expected.size()), expected);
}

TEST(StockIni, UpdatesAtTheShorterOfTheTwoDistances) {
  const slam::SlamParams p = stockOf(
                                 "insertionLinDistance=2\nlocalizeLinDistance=0.2\n"
                                 "insertionAngDistance_deg=5\nlocalizeAngDistance_deg=9\n")
                                 .params;
  EXPECT_EQ(p.update.update_distance_m, 0.2);
  EXPECT_EQ(p.update.update_angle_deg, 5);
}

TEST(StockIni, IsToldByItsSection) {
  const auto is = [](const char* text) {
    return stock::isStockIni(io::parseIni(text, "", io::IniDialect::mrpt));
  };
  EXPECT_TRUE(is("[mappingapplication]\n"));
  EXPECT_FALSE(is("[filter]\n"));
}

class StockRawlog : public TemporaryFolder {};

TEST_F(StockRawlog, IsLookedForBesideTheIni) {
  fs::create_directories(folder / "ini");
  std::ofstream(folder / "log.rawlog") << "x";
  EXPECT_EQ(stock::findStockRawlog("../log.rawlog", folder / "ini" / "a.ini"),
            (folder / "log.rawlog").string());
  EXPECT_EQ(stock::findStockRawlog("/none/such.rawlog", folder / "a.ini"), "/none/such.rawlog");
}

TEST(StockIni, MutatedFilesGiveAResultOrAnError) {
  const std::string base =
      "[MappingApplication]\nrawlog_file=a\nsampleSize=25 // x\nBETA=0.5\nPF_algorithm=3\n"
      "occupancyGrid_count=1\n[MappingApplication_occupancyGrid_00_insertOpts]\n"
      "maxOccupancyUpdateCertainty=0.6\nmaxDistanceInsertion=35\n@define A 3\nX=$eval{A}\n";
  for (std::uint32_t round = 0; round < 2000; ++round) {
    core::RandomStream random(5, round, 0, core::Purpose::test);
    std::string mutant = base;
    for (int k = 0; k < 4; ++k) mutant[random.bits() % mutant.size()] = char(random.bits());
    try {
      readStockIni(mutant, "a.ini");
    } catch (const core::UsageError&) {
    }
  }
}
