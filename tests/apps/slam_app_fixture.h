// Runs ariadne-slam without a process, in a folder with a small log and an INI.
#pragma once
#include <sstream>

#include "../io/temporary_folder.h"
#include "ariadne/io/whole_file.h"
#include "room_log.h"
#include "slam_app.h"

class SlamApp : public TemporaryFolder {
 protected:
  void SetUp() override {
    TemporaryFolder::SetUp();
    log = put("room.log", room_log::text(40));
    ini = put("room.ini", "[filter]\nparticles = 4\n[grid]\nresolution_m = 0.1\n");
  }

  std::string put(const std::string& name, const std::string& content) {
    ariadne::io::writeWhole(folder / name, content);
    return (folder / name).string();
  }

  int run(const std::vector<std::string>& args) {
    std::ostringstream out_stream;
    std::ostringstream err_stream;
    const int code = ariadne::runSlamApp(args, out_stream, err_stream);
    out = out_stream.str();
    err = err_stream.str();
    return code;
  }

  int map(const std::string& name, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {ini, log, "--out", (folder / name).string()});
    return run(more);
  }

  /// All that --print-config prints for these arguments behind the INI.
  std::string resolved(std::vector<std::string> args) {
    args.insert(args.begin(), ini);
    args.emplace_back("--print-config");
    EXPECT_EQ(run(args), 0) << err;
    return out;
  }

  std::string log;
  std::string ini;
  std::string out;
  std::string err;
};
