#include "ariadne/explore/strategy.h"

namespace ariadne::explore {

void applyStrategy(Strategy strategy, slam::SlamParams& params) {
  params.recovery.enabled = strategy == Strategy::active_neff_recovery;
  switch (strategy) {
    case Strategy::frontier:
      params.loop_closing.stop = loops::Stop::leaving;
      break;
    case Strategy::active_uncertainty:
      params.loop_closing.stop = loops::Stop::uncertainty;
      break;
    case Strategy::active_neff:
    case Strategy::active_neff_recovery:
      params.loop_closing.stop = loops::Stop::neff;
      break;
  }
}

bool isActive(Strategy strategy) { return strategy != Strategy::frontier; }

}  // namespace ariadne::explore
