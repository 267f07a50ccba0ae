// The section [run] of the programs that map: where the result goes, and on how many threads.
#pragma once
#include <filesystem>
#include <string>

#include "ariadne/core/fields.h"

namespace ariadne::app {

struct RunParams {
  int threads = 0;
  std::string out;
  bool pictures = true;
};

template <class V>
void visitFields(V& v, RunParams& p) {
  v.number("threads", p.threads, {0, 256},
           "0 is one per core; the result is the same on any number");
  v.text("out", p.out,
         "folder to write to, from the current one; empty: ariadne-<input>-<date>-<time>");
  v.flag("pictures", p.pictures,
         "write report.html and the PNG files: overview, map, topology, coalescence");
}

/// A folder that is not there yet: ariadne-<name of the input, shortened>-<date>-<time>.
std::string newFolderFor(const std::filesystem::path& input);

}  // namespace ariadne::app
