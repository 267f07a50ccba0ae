#include "arm_call.h"

#include <fmt/format.h>

#include "ariadne/core/error.h"
#include "ariadne/io/tum.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;

/// A value that names a file, from the experiment's folder, becomes its path.
std::string fileOr(const std::string& value, const fs::path& folder) {
  std::error_code ignored;
  const fs::path path = (folder / value).lexically_normal();
  return !value.empty() && fs::is_regular_file(path, ignored) ? path.string() : value;
}

/// A value with a slash is meant as a file: without it every run would fail, not the plan.
void checkValue(const Factor& factor, const std::string& value, const fs::path& folder) {
  std::error_code ignored;
  if (value.find('/') == std::string::npos || fs::exists(value, ignored)) return;
  throw core::UsageError(fmt::format("{}: [factor.{}] values: there is no file {} (from {})",
                                     factor.where, factor.name, value, folder.string()));
}

}  // namespace

ArmCall callOf(const Experiment& x, const Arm& arm, const Combination& values) {
  const fs::path folder = x.file.parent_path();
  ArmCall call;
  call.config = (folder / arm.config).lexically_normal();
  if (!arm.dataset.empty()) call.dataset = (folder / arm.dataset).lexically_normal().string();
  for (const std::string& a : arm.args) call.args.push_back(fileOr(a, folder));
  for (const Setting& s : arm.settings)
    call.settings.push_back(s.key + "=" + fileOr(s.value, folder));
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::string value = fileOr(values[i], folder);
    checkValue(x.factors[i], value, folder);
    const std::string& key = x.factors[i].key;
    if (key[0] == '-') {
      call.args.push_back(key);
      call.args.push_back(value);
    } else {
      call.settings.push_back(key + "=" + value);
    }
  }
  return call;
}

std::string truthOf(const Experiment& x, const Arm& arm) {
  if (arm.truth.empty()) return {};
  const fs::path path = (x.file.parent_path() / arm.truth).lexically_normal();
  try {
    io::readTum(path);
  } catch (const core::Error& e) {
    throw core::UsageError(
        fmt::format("{}: [arm.{}] truth = {}: {}", arm.where, arm.name, arm.truth, e.what()));
  }
  return path.string();
}

void checkCall(const Arm& arm, const Program& program, const ArmCall& call) {
  std::error_code ignored;
  const auto fail = [&](const std::string& what) {
    throw core::UsageError(fmt::format("{}: [arm.{}]: {}", arm.where, arm.name, what));
  };
  if (!fs::is_regular_file(call.config, ignored))
    fail(fmt::format("config = {}: there is no file {}", arm.config, call.config.string()));
  if (!call.dataset.empty() && !fs::is_regular_file(call.dataset, ignored))
    fail(
        fmt::format("dataset = {}: there is no file {}. MRPT's sample log comes with the package "
                    "mrpt-common; README.md, \"Logs\", says where to get the others",
                    arm.dataset, call.dataset));
  if (program.kind == ProgramKind::stock && call.dataset.empty())
    fail("ariadne-stock-rbpf needs a dataset, a rawlog of actions and frames");
  if (program.kind == ProgramKind::stock && !call.settings.empty())
    fail(
        fmt::format("ariadne-stock-rbpf takes no section.key, here {}: use args or a factor with "
                    "key = --particles",
                    call.settings[0]));
  if (program.kind == ProgramKind::loops && !call.dataset.empty())
    fail("ariadne-loop-experiment takes no dataset: its INI names world and path");
}

}  // namespace ariadne::batch
