// ariadne-eval: how far a trajectory is from the truth.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace ariadne {

/// The program without its process. @return exit code: 0 fine, 1 the run failed, 2 wrong use
int runEvalApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err);

}  // namespace ariadne
