#include "ariadne/batch/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "ariadne/io/ini_fields.h"

namespace ariadne::batch {
namespace {

using io::IniEntry;
using io::KnownSection;

const std::vector<KnownSection>& knownSections() {
  static const std::vector<KnownSection> known = {
      {"experiment", {"title"}},
      {"arm.NAME", {"program", "config", "dataset", "truth", "args", "prefix", "set.SECTION.KEY"}},
      {"factor.NAME", {"key", "values", "set.VALUE.SECTION.KEY"}},
      {"seeds", {"first", "last"}},
      {"figures", {"names", "success", "relative"}},
      {"plots", {"figures", "over"}},
      {"limits", {"time_s", "threads", "keep_files"}}};
  return known;
}

bool startsWith(const std::string& text, const std::string& head) {
  return text.compare(0, head.size(), head) == 0;
}

core::UsageError noSuchKey(const IniEntry& entry, const std::string& section) {
  const auto& all = knownSections();
  const auto known =
      std::find_if(all.begin(), all.end(), [&](const auto& k) { return k.name == section; });
  return io::unknownKey(entry, {{entry.section, known->keys}});
}

/// The arm or factor of a section [arm.NAME]; its name goes into tables and options.
template <class T>
T named(const io::IniSection& section, const std::string& head) {
  T item;
  item.name = section.name.substr(head.size());
  item.where = section.where;
  if (item.name.empty() || item.name.find_first_of(",|&\\") != std::string::npos)
    throw core::UsageError(fmt::format("{}: [{}]: give it a name behind the dot, without , | & \\",
                                       section.where, io::printable(section.name)));
  return item;
}

/// Words between blanks; within "quotes" a blank is part of a word.
std::vector<std::string> wordsOf(const IniEntry& e) {
  std::vector<std::string> words;
  bool in_word = false, in_quotes = false;
  for (const char c : e.value) {
    if (!in_quotes && (c == ' ' || c == '\t')) {
      in_word = false;
      continue;
    }
    if (!in_word) words.emplace_back();
    in_word = true;
    if (c == '"')
      in_quotes = !in_quotes;
    else
      words.back() += c;
  }
  if (in_quotes) throw io::entryError(e, "has no closing quote, as in --world \"my house.yaml\"");
  return words;
}

void setArm(Arm& arm, const IniEntry& e) {
  if (e.key == "program")
    arm.program = e.value;
  else if (e.key == "config")
    arm.config = e.value;
  else if (e.key == "dataset")
    arm.dataset = e.value;
  else if (e.key == "truth")
    arm.truth = e.value;
  else if (e.key == "args")
    arm.args = wordsOf(e);
  else if (e.key == "prefix")
    arm.prefix = e.value;
  else if (startsWith(e.key, "set.") && e.key.find('.', 4) != std::string::npos)
    arm.settings.push_back({e.key.substr(4), e.value});
  else
    throw noSuchKey(e, "arm.NAME");
}

/// set.VALUE.SECTION.KEY: the value may hold dots, as 0.5.
void addToValue(Factor& factor, const IniEntry& e) {
  const std::size_t key = e.key.rfind('.');
  const std::size_t section = e.key.rfind('.', key - 1);
  if (section == std::string::npos || section <= 4)
    throw io::entryError(e, "is no set.VALUE.SECTION.KEY, as set.2.noise.turn_per_root_turn");
  factor.settings[e.key.substr(4, section - 4)].push_back({e.key.substr(section + 1), e.value});
}

void setFactor(Factor& factor, const IniEntry& e) {
  if (e.key == "key") {
    if (!startsWith(e.value, "--") && e.value.find('.') == std::string::npos)
      throw io::entryError(e, "takes section.key, as filter.particles, or an option, as --laps");
    factor.key = e.value;
  } else if (e.key == "values") {
    factor.values = splitList(e.value, ",");
    std::set<std::string> once(factor.values.begin(), factor.values.end());
    if (factor.values.empty() || once.size() != factor.values.size())
      throw io::entryError(e, "takes values with commas between them, each once");
  } else if (startsWith(e.key, "set.")) {
    addToValue(factor, e);
  } else {
    throw noSuchKey(e, "factor.NAME");
  }
}

void setOther(Experiment& x, const IniEntry& e) {
  constexpr double kLastSeed = 9007199254740992.0;
  if (e.section == "experiment" && e.key == "title")
    x.title = e.value;
  else if (e.section == "seeds" && e.key == "first")
    x.first_seed = static_cast<std::uint64_t>(io::wholeOf(e, {0, kLastSeed}));
  else if (e.section == "seeds" && e.key == "last")
    x.last_seed = static_cast<std::uint64_t>(io::wholeOf(e, {0, kLastSeed}));
  else if (e.section == "figures" && e.key == "names")
    x.figures = splitList(e.value, ",");
  else if (e.section == "figures" && e.key == "relative")
    x.relative = splitList(e.value, ",");
  else if (e.section == "figures" && e.key == "success")
    x.success = parseSuccess(e);
  else if (e.section == "plots" && e.key == "figures")
    x.plots.figures = splitList(e.value, ",");
  else if (e.section == "plots" && e.key == "over")
    x.plots.over = e.value;
  else if (e.section == "limits" && e.key == "time_s")
    x.limits.time_s = io::realOf(e, {0.001, 1e7});
  else if (e.section == "limits" && e.key == "threads")
    x.limits.threads = static_cast<int>(io::wholeOf(e, {1, 256}));
  else if (e.section == "limits" && e.key == "keep_files")
    x.limits.keep_files = io::flagOf(e);
  else
    throw noSuchKey(e, e.section);
}

void addSection(Experiment& x, const io::IniSection& section) {
  if (startsWith(section.name, "arm."))
    x.arms.push_back(named<Arm>(section, "arm."));
  else if (startsWith(section.name, "factor."))
    x.factors.push_back(named<Factor>(section, "factor."));
  else if (section.name != "experiment" && section.name != "seeds" && section.name != "figures" &&
           section.name != "plots" && section.name != "limits")
    throw io::unknownSection(section.name, section.where, knownSections());
}

template <class T>
T& itemOf(std::vector<T>& items, const std::string& name) {
  return *std::find_if(items.begin(), items.end(), [&](const T& i) { return i.name == name; });
}

void require(bool given, const std::string& where, const std::string& what) {
  if (!given) throw core::UsageError(fmt::format("{}: {}", where, what));
}

void checkFactor(const Factor& factor) {
  const auto check = [&](bool fine, const std::string& what) {
    require(fine, factor.where, fmt::format("[factor.{}] {}", factor.name, what));
  };
  check(!factor.values.empty(), "has no values");
  check(!factor.key.empty() || !factor.settings.empty(),
        "has no key, as filter.particles or --laps, and no set.VALUE.SECTION.KEY");
  check(factor.key.empty() || factor.settings.empty(),
        "has a key and set.VALUE.SECTION.KEY: values are given to the key or name settings");
  for (const auto& [value, settings] : factor.settings)
    check(std::find(factor.values.begin(), factor.values.end(), value) != factor.values.end(),
          fmt::format("set.{}.{}: {} is none of its values; the nearest is {}", value,
                      settings[0].key, value, io::nearestName(value, factor.values)));
}

void checkRelative(const Experiment& x) {
  for (const std::string& name : x.relative)
    require(std::find(x.figures.begin(), x.figures.end(), name) != x.figures.end(), x.file.string(),
            fmt::format("[figures] relative = {}: takes figures that names has, here {}", name,
                        fmt::join(x.figures, ", ")));
}

void checkComplete(const Experiment& x) {
  const std::string file = x.file.string();
  require(!x.title.empty(), file,
          "[experiment] title is missing: results folders are told apart by it");
  require(!x.arms.empty(), file, "no [arm.NAME]: an experiment compares one or more of them");
  for (const Arm& arm : x.arms) {
    require(!arm.program.empty(), arm.where,
            fmt::format("[arm.{}] has no program, as ariadne-explore", arm.name));
    require(!arm.config.empty(), arm.where,
            fmt::format("[arm.{}] has no config, the program's INI", arm.name));
  }
  for (const Factor& factor : x.factors) checkFactor(factor);
  checkRelative(x);
  require(x.first_seed <= x.last_seed, file,
          fmt::format("[seeds] last = {} is before first = {}", x.last_seed, x.first_seed));
  require(!x.figures.empty() || !x.success.figure.empty(), file,
          "[figures] is missing: names = figures for the tables, success = what counts as one");
  std::vector<std::string> factors;
  for (const Factor& factor : x.factors) factors.push_back(factor.name);
  checkPlots(x.plots, x.figures, factors, file);
}

}  // namespace

Experiment parseExperiment(std::string_view text, const std::filesystem::path& file) {
  Experiment x;
  x.file = std::filesystem::absolute(file).lexically_normal();
  x.text = text;
  const auto document = io::parseIniFile(text, file);
  for (const io::IniSection& section : document.sections) addSection(x, section);
  for (const IniEntry& entry : document.entries) {
    if (startsWith(entry.section, "arm."))
      setArm(itemOf(x.arms, entry.section.substr(4)), entry);
    else if (startsWith(entry.section, "factor."))
      setFactor(itemOf(x.factors, entry.section.substr(7)), entry);
    else
      setOther(x, entry);
  }
  checkComplete(x);
  return x;
}

Experiment readExperiment(const std::filesystem::path& file) {
  return parseExperiment(io::readIniText(file), file);
}

}  // namespace ariadne::batch
