// A program of the test's for an experiment's arms: quick, and as bad as the test needs it.
#pragma once
#include <filesystem>
#include <string>

#include "../io/temporary_folder.h"
#include "ariadne/io/whole_file.h"

class StandIn : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    ariadne::io::writeWhole(folder / "arm.ini", std::string_view("[a]\nb = 1\n"));
    writeProgram("");
    writeExperiment("");
  }

  /// @param body shell code before the result is written; it knows seed, out, arm (1 or 2), and
  /// here, the test's folder
  void writeProgram(const std::string& body) {
    const std::string text = "#!/bin/sh\nhere='" + folder.string() + "'\n" + R"(config=$1; shift
while [ $# -gt 0 ]; do case $1 in
  --set) sets="$sets $2"; shift 2;;
  --print-config) print=1; shift;;
  --seed) seed=$2; shift 2;;
  --out) out=$2; shift 2;;
  *) echo "there is no option $1" >&2; exit 2;;
esac; done
case "$sets" in *typo*) echo "--set: [a] typo: there is no such key" >&2; exit 2;; esac
if [ -n "$print" ]; then cat "$config"; echo "[set]"; echo "all = $sets"; exit 0; fi
arm=1; grep -q second=yes "$config" && arm=2
)" + body + R"(
echo "{\"ok\": $([ $((seed % (arm + 2))) = 0 ] && echo false || echo true)," \
  "\"value\": $((seed * seed + arm)), \"parameters\": {\"a\": 1}}" > "$out/summary.json"
)";
    ariadne::io::writeWhole(program(), text);
    std::filesystem::permissions(program(), std::filesystem::perms::owner_all);
  }

  /// Two arms of the program on four seeds; `more` is added.
  void writeExperiment(const std::string& more, const std::string& title = "Test") {
    ariadne::io::writeWhole(ini(), "[experiment]\ntitle = " + title + R"(
[arm.first]
program = ./program.sh
config = arm.ini
[arm.second]
program = ./program.sh
config = arm.ini
set.a.second = yes
[figures]
names = value
success = ok
)" + more);
  }

  std::filesystem::path program() const { return folder / "program.sh"; }
  std::filesystem::path ini() const { return folder / "experiment.ini"; }
  std::filesystem::path results() const { return folder / "results"; }
};
