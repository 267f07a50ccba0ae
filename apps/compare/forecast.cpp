#include "forecast.h"

#include <fmt/format.h>

#include <algorithm>

#include "progress.h"

namespace ariadne::compare_app {
namespace {

/// Before this share of the log a run's own speed says less than the runs before it.
constexpr double kTelling = 0.2;

std::string runsText(int repeats, Side side, double run_s) {
  return fmt::format("{} run{} of {}, {}{}", repeats, repeats == 1 ? "" : "s", nameOf(side),
                     app::timeText(run_s), repeats == 1 ? "" : " each");
}

}  // namespace

const char* nameOf(Side side) { return side == Side::ours ? "ariadne-slam" : "stock MRPT"; }

void Forecast::expect(Side side, double run_s) { of(side).expected_s = run_s; }

void Forecast::ended(Side side, double wall_s) {
  ++of(side).ended;
  of(side).sum_s += wall_s;
}

std::optional<double> Forecast::run_s(Side side) const {
  const Runs& runs = of(side);
  if (runs.ended == 0) return runs.expected_s;
  return runs.sum_s / runs.ended;
}

std::optional<double> Forecast::left_s(const UnderWay& now) const {
  double left = 0;
  for (const Side side : {Side::ours, Side::stock}) {
    const bool runs_now = side == now.side;
    auto whole = run_s(side);
    const int later = repeats_ - of(side).ended - (runs_now ? 1 : 0);
    if (later > 0 && !whole) return std::nullopt;
    if (later > 0) left += later * *whole;
    if (!runs_now) continue;
    if (now.share > kTelling) whole = now.elapsed_s / std::min(now.share, 1.0);
    if (!whole) return std::nullopt;
    left += std::max(0.0, *whole - now.elapsed_s);
  }
  return left;
}

std::string Forecast::text() const {
  const auto ours = run_s(Side::ours);
  const auto stock = run_s(Side::stock);
  if (!ours || !stock) return "";
  return fmt::format("{}; {}; {} in all, as their beginnings show",
                     runsText(repeats_, Side::ours, *ours), runsText(repeats_, Side::stock, *stock),
                     app::timeText(repeats_ * (*ours + *stock)));
}

std::string Forecast::progressText(const UnderWay& now) const {
  std::string text =
      fmt::format("run {} of {}, {}", of(now.side).ended + 1, repeats_, nameOf(now.side));
  const auto left = left_s(now);
  if (!left) return text;
  const double done = of(Side::ours).sum_s + of(Side::stock).sum_s + now.elapsed_s;
  return text + fmt::format(": {:.0f} % of all, {} left", 100 * done / std::max(done + *left, 1e-9),
                            app::timeText(*left));
}

}  // namespace ariadne::compare_app
