// What all programs' command lines have in common.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "../io/temporary_folder.h"
#include "ariadne/core/error.h"
#include "ariadne/io/whole_file.h"
#include "command_line.h"
#include "ini_program.h"

using namespace ariadne;
namespace fs = std::filesystem;

namespace {

std::string problemOf(CLI::App& app, const std::vector<std::string>& args) {
  std::ostringstream out;
  try {
    return app::parseCommandLine(app, args, out) ? "fine" : out.str();
  } catch (const core::UsageError& e) {
    return e.what();
  }
}

/// A program with an option of its own and two subcommands.
struct Program {
  CLI::App app{"About.", "program"};
  bool json = false;
  int seed = 0;
  std::string in;
  Program() {
    app.require_subcommand(1);
    CLI::App* info = app.add_subcommand("info", "");
    info->add_flag("--json", json, "");
    info->add_option("IN", in, "")->required();
    app.add_subcommand("import", "")->add_option("--seed", seed, "");
  }
  std::string operator()(const std::vector<std::string>& args) { return problemOf(app, args); }
};

std::filesystem::path folderOfPrograms() { return ::getenv("ARIADNE_BIN_DIR"); }

std::string run(const std::string& words, int& code) {
  std::string said;
  FILE* pipe = ::popen((words + " 2>&1").c_str(), "r");
  std::array<char, 4096> block{};
  while (std::fgets(block.data(), block.size(), pipe)) said += block.data();
  const int status = ::pclose(pipe);
  code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return said;
}

}  // namespace

TEST(CommandLine, NamesTheNearest) {
  EXPECT_EQ(Program()({"inof"}),
            "there is no subcommand \"inof\"; the nearest is info (see program --help)");
  EXPECT_EQ(Program()({}), "which subcommand? There are info, import (see program --help)");
  EXPECT_EQ(Program()({"info", "a.log", "--jsno"}),
            "there is no option --jsno; the nearest is --json (see program --help)");
  EXPECT_EQ(Program()({"import", "--sed=7"}),
            "there is no option --sed; the nearest is --seed (see program --help)");
  EXPECT_EQ(Program()({"--verison"}),
            "there is no option --verison; the nearest is --version (see program --help)");
  EXPECT_EQ(Program()({"--json", "info", "a.log"}),
            "--json belongs behind info (see program --help)");
  EXPECT_EQ(Program()({"info", "a.log", "--seed", "7"}),
            "--seed is an option of import, not of info (see program --help)");
  EXPECT_EQ(Program()({"info", "a.log", "--json"}), "fine");
  // What CLI11 says well itself.
  EXPECT_NE(Program()({"info"}).find("IN is required"), std::string::npos) << Program()({"info"});
  EXPECT_NE(Program()({"import", "--seed", "x"}).find("--seed"), std::string::npos);
}

TEST(CommandLine, HelpAndVersionEndTheProgramWell) {
  EXPECT_NE(Program()({"--help"}).find("About."), std::string::npos);
  EXPECT_EQ(Program()({"--version"}).substr(0, 2), "0.");
}

TEST(CommandLine, OfEachProgram) {
  const fs::path bin = folderOfPrograms();
  for (const char* name : {"slam", "explore", "dataset", "eval", "compare", "experiment",
                           "loop-experiment", "stock-rbpf"}) {
    int code = -1;
    const std::string program = "'" + (bin / (std::string("ariadne-") + name)).string() + "'";
    EXPECT_EQ(run(program + " --version", code).substr(0, 2), "0.") << name;
    EXPECT_EQ(code, 0) << name;
    EXPECT_NE(run(program + " --help", code).find("--version"), std::string::npos) << name;
    EXPECT_EQ(code, 0) << name;
    const std::string said = run(program + " --versoin", code);
    EXPECT_EQ(code, 2) << name;
    EXPECT_EQ(said.find("ariadne-" + std::string(name) +
                        ": there is no option --versoin; the "
                        "nearest is --version (see ariadne-" +
                        name + " --help)"),
              0U)
        << said;
  }
}

TEST(IniOfAProgram, ThatOfAnotherIsRecognised) {
  const fs::path ini = fs::path(::getenv("ARIADNE_SOURCE_DIR")) / "ini";
  const std::vector<std::pair<std::string, std::string>> programs = {
      {"ariadne-slam", "slam/sena.ini"},
      {"ariadne-explore", "explore/nested.ini"},
      {"ariadne-experiment", "paper/small.ini"},
      {"ariadne-loop-experiment", "paper/drives/small.ini"}};
  for (const auto& [program, file] : programs)
    for (const auto& [other, its_file] : programs) {
      const fs::path path = ini / its_file;
      std::string said;
      try {
        app::expectIniOf(program, path, io::readWhole(path));
      } catch (const core::UsageError& e) {
        said = e.what();
      }
      if (program == other)
        EXPECT_EQ(said, "");
      else
        EXPECT_EQ(said.find(path.string() + " is an INI of " + other + ": " + other), 0U) << said;
    }
  EXPECT_NO_THROW(app::expectIniOf("ariadne-slam", "a.ini", "[filter]\nparticles = 7\n"));
  EXPECT_NO_THROW(app::expectIniOf("ariadne-slam", "a.ini", "no INI"));
}

TEST(IniOfAProgram, IsSaidByThePrograms) {
  const std::string bin = folderOfPrograms().string();
  const std::string ini = std::string(::getenv("ARIADNE_SOURCE_DIR")) + "/ini/";
  for (const auto& [call, right] : std::vector<std::pair<std::string, std::string>>{
           {"slam " + ini + "explore/nested.ini", "ariadne-explore "},
           {"explore " + ini + "slam/carmen.ini", "ariadne-slam "},
           {"experiment run " + ini + "explore/nested.ini --dry-run", "ariadne-explore "},
           {"loop-experiment " + ini + "paper/small.ini", "ariadne-experiment run "}}) {
    int code = -1;
    const std::string said = run(bin + "/ariadne-" + call, code);
    EXPECT_EQ(code, 2) << said;
    EXPECT_NE(said.find(" is an INI of " + right.substr(0, right.find(' ')) + ": " + right),
              std::string::npos)
        << said;
  }
}
