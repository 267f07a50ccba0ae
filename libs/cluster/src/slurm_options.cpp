#include "ariadne/cluster/slurm_options.h"

#include <fmt/format.h>

#include <regex>

#include "ariadne/core/error.h"
#include "ariadne/core/names.h"
#include "ariadne/core/numbers.h"

namespace ariadne::cluster {
namespace {

double number(const std::ssub_match& match) { return core::parseNumber(match.str()).value_or(0); }

void checkWord(const char* option, const std::string& word, const char* pattern,
               const char* takes) {
  // std::regex recurses by the character: a long word would take the stack.
  if (!word.empty() && (word.size() > 1000 || !std::regex_match(word, std::regex(pattern))))
    throw core::UsageError(fmt::format("{} {}: takes {}", option, core::printable(word), takes));
}

}  // namespace

double slurmTime_s(const std::string& text) {
  static const std::regex with_days(
      "([0-9]{1,5})-([0-9]{1,2})(?::([0-9]{1,2})(?::([0-9]{1,2}))?)?");
  static const std::regex minutes("([0-9]{1,7})(?::([0-9]{1,2}))?");
  static const std::regex hours("([0-9]{1,5}):([0-9]{1,2}):([0-9]{1,2})");
  std::smatch m;
  if (std::regex_match(text, m, with_days))
    return 86400 * number(m[1]) + 3600 * number(m[2]) + 60 * number(m[3]) + number(m[4]);
  if (std::regex_match(text, m, minutes)) return 60 * number(m[1]) + number(m[2]);
  if (std::regex_match(text, m, hours))
    return 3600 * number(m[1]) + 60 * number(m[2]) + number(m[3]);
  return -1;
}

void check(const SlurmOptions& options) {
  checkWord("--partition", options.partition, "[A-Za-z0-9_.,-]+",
            "the name of a partition (sinfo lists them)");
  if (!options.time.empty() && slurmTime_s(options.time) <= 0)
    throw core::UsageError(
        fmt::format("--time {}: takes a time of Slurm's: 90 (minutes), 1:30:00, 2-12 (days-hours), "
                    "2-12:30:00",
                    options.time));
  checkWord("--mem", options.memory, "[1-9][0-9]*[KMGT]?", "a number and K, M, G or T, as 4G");
  for (const std::string& word : options.more)
    if (word.compare(0, 2, "--") != 0 || word.find('\n') != std::string::npos)
      throw core::UsageError(
          fmt::format("--sbatch {}: takes an option of sbatch, as --sbatch=--account=lab", word));
}

}  // namespace ariadne::cluster
