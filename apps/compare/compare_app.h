// ariadne-compare: ours and stock MRPT RBPF-SLAM on one log.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace ariadne {

/// The program without its process (it runs others); `args` without the program's name. Returns
/// the exit code: 0 fine, 1 a run failed or a requirement is not met, 2 wrong use.
int runCompareApp(const std::vector<std::string>& args, std::ostream& out, std::ostream& err);

}  // namespace ariadne
