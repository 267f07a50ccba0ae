#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <fstream>

#include "ariadne/core/error.h"
#include "ariadne/experiment/neff_fall.h"

using namespace ariadne;

namespace {

const char* kHeader = "step,time_s,neff,resampled,particles,matches_accepted\n";

/// 30 m forth and back, a metre a second.
std::vector<eval::PathPoint> forthAndBack() {
  return eval::pathPasses({{0, {0, 0, 0}}, {30, {30, 0, 0}}, {60, {0, 0, 0}}});
}

class NeffSteps : public ::testing::Test {
 protected:
  void TearDown() override { std::filesystem::remove(file_); }
  const std::filesystem::path& with(const std::string& text) {
    std::ofstream(file_) << text;
    return file_;
  }

 private:
  std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("ariadne-steps-" + std::to_string(::getpid()));
};

}  // namespace

TEST_F(NeffSteps, AreReadFromStepsCsv) {
  const auto steps = experiment::readNeffSteps(
      with(std::string(kHeader) + "0,100.5,30,0,30,29\n1,101.5,12.25,1,30,30\n"));
  ASSERT_EQ(steps.size(), 2U);
  EXPECT_EQ(steps[1].time_s, 101.5);
  EXPECT_EQ(steps[1].neff, 12.25);
  EXPECT_TRUE(steps[1].resampled);
  EXPECT_EQ(steps[1].particles, 30);
}

TEST_F(NeffSteps, WhatIsNoneIsNamed) {
  EXPECT_THROW(experiment::readNeffSteps(with("a,b\n")), core::Error);
  EXPECT_THROW(experiment::readNeffSteps(with(std::string(kHeader) + "0,1,0,0,30,1\n")),
               core::Error);
  try {
    experiment::readNeffSteps(with(std::string(kHeader) + "0,1,30,0,30,1\n1,2,x,0,30,1\n"));
    ADD_FAILURE() << "no core::Error";
  } catch (const core::Error& e) {
    EXPECT_NE(std::string(e.what()).find(":3: neff: \"x\""), std::string::npos) << e.what();
  }
}

TEST(NeffFall, StartsFromAllParticlesAfterResampling) {
  // New ground up to 30 s; back at 12 m at 48 s, at 9 m at 51 s.
  const auto changes = experiment::neffChanges({{0, 20, false, 20},
                                                {10, 10, true, 20},
                                                {20, 10, false, 20},
                                                {48, 5, false, 20},
                                                {51, 5, true, 20}},
                                               forthAndBack());
  ASSERT_EQ(changes.size(), 4U);
  EXPECT_NEAR(changes[0].ln_change, -std::log(2), 1e-12);
  EXPECT_NEAR(changes[1].ln_change, -std::log(2), 1e-12) << "from 20, not from 10";
  const auto fall = experiment::neffFall(changes);
  EXPECT_NEAR(fall[0].travelled_m, 20, 1e-6);
  EXPECT_NEAR(fall[0].ln_change, -2 * std::log(2), 1e-12);
  EXPECT_EQ(fall[0].resamplings, 1U);
  EXPECT_NEAR(fall[1].travelled_m, 31, 1e-6);
  EXPECT_NEAR(fall[1].ln_change, -std::log(2), 1e-12);
  EXPECT_EQ(fall[1].resamplings, 1U);
  EXPECT_EQ(fall[2].travelled_m, 0);
}
