// `ariadne-eval neff` and `neff-log`: how Neff goes over a drive.
#pragma once
#include <iosfwd>
#include <string>
#include <vector>

namespace ariadne::eval_app {

/// `args` behind the command's name. Returns the exit code; throws core::UsageError, core::Error.
int runNeff(const std::vector<std::string>& args, std::ostream& out);
int runNeffLog(const std::vector<std::string>& args, std::ostream& out);

}  // namespace ariadne::eval_app
