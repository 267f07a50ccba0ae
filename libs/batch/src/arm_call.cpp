#include "arm_call.h"

#include <fmt/format.h>

#include "ariadne/core/error.h"
#include "ariadne/io/tum.h"
#include "data_place.h"

namespace ariadne::batch {
namespace {

namespace fs = std::filesystem;

/// A value that names a file or a recording in a folder, from the experiment's folder, becomes its
/// path.
std::string fileOr(const std::string& value, const fs::path& folder) {
  const std::string path = (folder / value).lexically_normal().string();
  return !value.empty() && whyNoData(path).empty() ? path : value;
}

/// A value with a slash is meant as a file: without it every run would fail, not the plan.
std::string checkedFile(const Factor& factor, const std::string& key, const std::string& text,
                        const fs::path& folder) {
  std::error_code ignored;
  std::string value = fileOr(text, folder);
  if (value.find('/') != std::string::npos && !fs::exists(value, ignored))
    throw core::UsageError(fmt::format("{}: [factor.{}] {}: there is no file {} (from {})",
                                       factor.where, factor.name, key, value, folder.string()));
  return value;
}

/// The arm at the factor's value.
void addValue(ArmCall& call, const Factor& factor, const std::string& value,
              const fs::path& folder) {
  const auto named = factor.settings.find(value);
  if (factor.key.empty()) {
    if (named == factor.settings.end()) return;
    for (const Setting& s : named->second)
      call.settings.push_back(
          s.key + "=" +
          checkedFile(factor, fmt::format("set.{}.{}", value, s.key), s.value, folder));
    return;
  }
  const std::string given = checkedFile(factor, "values", value, folder);
  if (factor.key[0] == '-') {
    call.args.push_back(factor.key);
    call.args.push_back(given);
  } else {
    call.settings.push_back(factor.key + "=" + given);
  }
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
  for (std::size_t i = 0; i < values.size(); ++i) addValue(call, x.factors[i], values[i], folder);
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
  if (const std::string why = call.dataset.empty() ? "" : whyNoData(call.dataset); !why.empty())
    fail(fmt::format("dataset = {}: {}: {}", arm.dataset, call.dataset, why));
  const ProgramDescription& takes = program.description();
  const char* const name = takes.name;
  if (takes.dataset == TakesDataset::never && !call.dataset.empty())
    fail(fmt::format("{} takes no dataset: its INI names its data", name));
  if (takes.prints_config) return;
  if (call.dataset.empty()) fail(fmt::format("{} needs a dataset", name));
  if (!call.settings.empty())
    fail(
        fmt::format("{} takes no section.key, here {}: use args or a factor with key = --particles",
                    name, call.settings[0]));
}

}  // namespace ariadne::batch
