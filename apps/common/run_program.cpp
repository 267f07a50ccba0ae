#include "run_program.h"

#include <fmt/format.h>
#include <fmt/ostream.h>

#include <exception>
#include <new>
#include <ostream>

#include "ariadne/core/error.h"

namespace ariadne::app {

int runProgram(const std::string& name, std::ostream& err, const std::function<int()>& run) {
  try {
    return run();
  } catch (const core::UsageError& e) {
    fmt::print(err, "{}: {}\n", name, e.what());
    return 2;
  } catch (const std::bad_alloc&) {
    fmt::print(err, "{}: out of memory: take fewer particles or a coarser grid\n", name);
    return 1;
  } catch (const std::exception& e) {
    fmt::print(err, "{}: {}\n", name, e.what());
    return 1;
  }
}

void warn(std::ostream& err, const std::string& program, const std::vector<std::string>& warnings) {
  for (const std::string& w : warnings) fmt::print(err, "{}: warning: {}\n", program, w);
}

}  // namespace ariadne::app
