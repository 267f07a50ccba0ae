// ariadne-slam: a dataset in, a map and a trajectory out.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace ariadne {

/// The program without its process; `args` without the program's name. Returns the exit code:
/// 0 fine, 1 the run failed, 2 wrong use, 130 stopped by Ctrl-C (143 by SIGTERM) with what was
/// mapped until then written.
int runSlamApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err);

}  // namespace ariadne
