// How long the runs of a comparison take: by each program's beginning, then by runs that ended.
#pragma once
#include <array>
#include <optional>
#include <string>

namespace ariadne::compare_app {

enum class Side { ours, stock };

/// "ariadne-slam" or "stock MRPT".
const char* nameOf(Side side);

/// A run that is under way.
struct UnderWay {
  Side side = Side::ours;
  double elapsed_s = 0;
  double share = 0;  ///< of its updates that it has made; 0: not known
};

/// Runs go in turns: ours, stock, ours, stock, ...
class Forecast {
 public:
  explicit Forecast(int repeats) : repeats_(repeats) {}
  /// What one run takes, as its beginning shows. Later told by runs that ended.
  void expect(Side side, double run_s);
  void ended(Side side, double wall_s);
  /// Of one run, s; nothing while no more is known than its name.
  std::optional<double> run_s(Side side) const;
  /// Of all runs that are left and what is left of this one, s.
  std::optional<double> left_s(const UnderWay& now) const;
  /// Runs of each, how long one takes and all take, as a sentence.
  std::string text() const;
  /// "run 2 of 3, stock MRPT: 40 % of all, 1:05 left".
  std::string progressText(const UnderWay& now) const;

 private:
  struct Runs {
    int ended = 0;
    double sum_s = 0;
    std::optional<double> expected_s;
  };
  const Runs& of(Side side) const { return runs_[static_cast<std::size_t>(side)]; }
  Runs& of(Side side) { return runs_[static_cast<std::size_t>(side)]; }
  int repeats_;
  std::array<Runs, 2> runs_;
};

}  // namespace ariadne::compare_app
