#include "ariadne/stock/stock_ini.h"

#include <fmt/format.h>
#include <mrpt/config/config_parser.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include "ariadne/io/ini_fields.h"
#include "stock_ini_rules.h"
#include "stock_ini_values.h"

namespace ariadne::stock {

using namespace io;  // its INIs are read as ours are

namespace {

namespace fs = std::filesystem;
constexpr const char* kSection = "MappingApplication";
/// A beam without return clears this far when the INI says it is free. Stock clears half the range
/// of the beam before it, which indoors is a few metres.
constexpr double kNoReturnFree_m = 3;

bool endsWith(std::string_view text, std::string_view end) {
  return text.size() >= end.size() && equalIgnoringCase(text.substr(text.size() - end.size()), end);
}

bool contains(std::string text, const char* part) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text.find(part) != text.npos;
}

/// The options of the first grid: "MappingApplication_occupancyGrid_00" + "_insertOpts".
bool isSectionOf(const StockRule& rule, const std::string& section) {
  if (*rule.options == '\0') return equalIgnoringCase(section, kSection);
  return contains(section, "occupancygrid") &&
         endsWith(section, fmt::format("_00{}", rule.options));
}

/// `xxx_count = n`: maps of kind xxx. Returns false when the key is no count.
bool countMaps(StockState& state, const IniEntry& entry) {
  if (!equalIgnoringCase(entry.section, kSection) || !endsWith(entry.key, "_count")) return false;
  const int count = mrptInteger(entry);
  if (contains(entry.key, "occupancygrid")) {
    state.grids += count;
    state.counts_given = true;
  } else if (contains(entry.key, "pointsmap")) {
    state.point_maps += count;
    state.counts_given = true;
  } else if (count > 0) {
    throw entryError(entry,
                     "only 2D laser grid mapping is done here; use MRPT's rbpf-slam for this map");
  }
  return true;
}

slam::SlamParams validated(const slam::SlamParams& params) {
  slam::forEachSection(
      params, [](const char* section, const auto& p) { core::validateFields(p, section); });
  return params;
}

/// True when a rule took it.
bool applyRules(StockState& state, const IniEntry& entry) {
  for (const StockRule& rule : stockRules()) {
    if (!equalIgnoringCase(entry.key, rule.key) || !isSectionOf(rule, entry.section)) continue;
    rule.apply(state, entry);
    try {
      validated(state.params);
    } catch (const core::UsageError& e) {
      throw entryError(entry, fmt::format("here {}", e.what()));
    }
    return true;
  }
  return false;
}

bool stockKnows(const std::string& key) {
  const auto& keys = stockKeysWithoutMeaning();
  return std::any_of(keys.begin(), keys.end(),
                     [&](const std::string& k) { return equalIgnoringCase(k, key); });
}

std::vector<std::string> allStockKeys() {
  std::vector<std::string> keys = stockKeysWithoutMeaning();
  for (const StockRule& rule : stockRules()) keys.emplace_back(rule.key);
  return keys;
}

/// One line for the keys that are known to mean nothing, one for each that nobody knows.
void noteUnused(StockState& state, const IniDocument& document,
                const std::vector<IniEntry>& unused) {
  std::vector<std::string> names;
  std::set<std::string> seen;
  for (const IniEntry& e : unused) {
    if (!seen.insert(e.key).second) continue;
    if (stockKnows(e.key))
      names.push_back(e.key);
    else if (equalIgnoringCase(e.section, kSection))
      state.notes.push_back(fmt::format("{}: [{}] {}: no key of rbpf-slam; the nearest is \"{}\"",
                                        e.where, e.section, printable(e.key),
                                        nearestName(e.key, allStockKeys())));
    else
      names.push_back(printable(e.key));
  }
  if (!names.empty())
    state.notes.push_back(
        fmt::format("{}: without meaning here: {}", document.name, fmt::join(names, ", ")));
}

void checkMaps(StockState& state, const std::string& name) {
  if (!state.counts_given) return;
  if (state.grids + state.point_maps < 1)
    throw core::UsageError(fmt::format(
        "{}: [{}] asks for neither an occupancy grid nor a points map: only 2D laser grid mapping "
        "is done here",
        name, kSection));
  if (state.grids > 1)
    state.notes.push_back(
        fmt::format("{}: {} grids are asked for; one is built, with the options of the first", name,
                    state.grids));
  if (state.grids < 1)
    state.notes.push_back(fmt::format("{}: a points map is asked for; a grid of {} m is built",
                                      name, state.params.grid.resolution_m));
}

using Distance = std::optional<double>;

bool differs(const Distance& a, const Distance& b) { return a && b && *a != *b; }

/// The shorter one, with MRPT's defaults for those that are not given.
double shorter(const Distance& a, double default_a, const Distance& b, double default_b) {
  return std::min(a.value_or(default_a), b.value_or(default_b));
}

/// Parameters that more than one key makes.
void combine(StockState& s, const std::string& name) {
  // Stock localizes and inserts at distances of their own; here an update does both.
  const bool differ = differs(s.insertion_distance_m, s.localize_distance_m) ||
                      differs(s.insertion_angle_deg, s.localize_angle_deg);
  auto& update = s.params.update;
  update.update_distance_m = shorter(s.insertion_distance_m, 1, s.localize_distance_m, 0.4);
  update.update_angle_deg = shorter(s.insertion_angle_deg, 30, s.localize_angle_deg, 10);
  if (differ)
    s.notes.push_back(
        fmt::format("{}: every filter update inserts its scan, each {:g} m or {:g} degrees", name,
                    update.update_distance_m, update.update_angle_deg));
  if (s.grids < 1) {
    validated(s.params);
    return;
  }
  // COccupancyGridMap2D inserts an endpoint with three times the log odds of the certainty.
  const auto bounded = [](double p) { return std::clamp(p, 0.51, 0.99); };
  const double odds = std::pow(s.occupied / (1 - std::min(s.occupied, 0.999)), 3);
  s.params.grid.occupied_probability = bounded(odds / (1 + odds));
  s.params.grid.free_probability = bounded(s.free > 0 ? s.free : s.occupied);
  s.params.grid.no_return_free_m =
      s.no_return_is_free ? std::min(kNoReturnFree_m, s.params.grid.insert_range_m) : 0;
  validated(s.params);
}

/// Each ${name} becomes up to a line of text: a small file may ask for more than there is memory.
void expectBounded(std::string_view text, const std::string& name) {
  constexpr double kMost = 64 << 20;
  double uses = 0;
  for (auto at = text.find("${"); at != text.npos; at = text.find("${", at + 2)) ++uses;
  std::size_t longest = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    longest = std::max(longest, end - begin);
    begin = end + 1;
  }
  if (uses * static_cast<double>(longest) > kMost)
    throw core::UsageError(fmt::format(
        "{}: {} times ${{name}} and lines of up to {} bytes are too much", name, uses, longest));
}

IniDocument parsed(std::string_view text, const std::string& name) {
  expectBounded(text, name);
  std::string expanded;
  try {
    expanded = mrpt::config::config_parser(std::string(text));
  } catch (const std::exception& e) {
    throw core::UsageError(fmt::format("{}: {}", name, printable(e.what())));
  }
  return parseIni(expanded, name, IniDialect::mrpt);
}

}  // namespace

bool isStockIni(const IniDocument& document) { return document.hasSection(kSection); }

std::string findStockRawlog(const std::string& rawlog, const fs::path& ini) {
  std::error_code ignored;
  for (const fs::path& candidate :
       {fs::path(rawlog), ini.parent_path() / rawlog,
        fs::path("/usr/share/mrpt/datasets") / fs::path(rawlog).filename()})
    if (fs::is_regular_file(candidate, ignored)) return candidate.lexically_normal().string();
  return rawlog;
}

StockIni readStockIni(std::string_view text, const fs::path& file) {
  const IniDocument document = parsed(text, file.filename().string());
  StockState state;
  std::vector<IniEntry> unused;
  for (const IniEntry& entry : document.entries)
    if (!countMaps(state, entry) && !applyRules(state, entry)) unused.push_back(entry);
  checkMaps(state, document.name);
  combine(state, document.name);
  noteUnused(state, document, unused);
  const std::string rawlog =
      state.rawlog_file.empty() ? "" : findStockRawlog(state.rawlog_file, file);
  return {state.params, rawlog, state.output_folder, state.notes};
}

}  // namespace ariadne::stock
