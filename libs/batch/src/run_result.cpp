#include "ariadne/batch/run_result.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "ariadne/core/error.h"

namespace ariadne::batch {

using Json = nlohmann::ordered_json;

std::string resultText(const RunResult& r) {
  const Json json = {{"key", r.key},         {"about", r.about},
                     {"failure", r.failure}, {"last_words", r.last_words},
                     {"wall_s", r.wall_s},   {"cpu_s", r.cpu_s},
                     {"host", r.host},       {"figures", r.figures}};
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

RunResult parseResult(const std::string& text, const std::string& name) {
  try {
    const auto json = nlohmann::json::parse(text);
    RunResult r;
    r.key = json.at("key");
    r.about = json.at("about");
    r.failure = json.at("failure");
    r.last_words = json.at("last_words");
    r.wall_s = json.at("wall_s");
    r.cpu_s = json.at("cpu_s");
    r.host = json.at("host");
    for (const auto& [figure, value] : json.at("figures").items())
      r.figures[figure] =
          value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
    return r;
  } catch (const std::exception& e) {
    throw core::Error(
        fmt::format("{} is no result of a run: {}; remove it to do the run again", name, e.what()));
  }
}

}  // namespace ariadne::batch
