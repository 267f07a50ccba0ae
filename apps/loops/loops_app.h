// ariadne-loop-experiment: one paired run of the paper's nested-loop experiment (VI A).
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace ariadne {

/// The program without its process; `args` without the program's name. Returns the exit code:
/// 0 fine, 1 the run failed, 2 wrong use.
int runLoopsApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err);

}  // namespace ariadne
