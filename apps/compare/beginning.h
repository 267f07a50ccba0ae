// Both programs on the log's beginning, to tell how long all of it takes.
#pragma once
#include "forecast.h"
#include "log_updates.h"
#include "repeats.h"

namespace ariadne::compare_app {

/// Lets each program map the piece of the log with the first ten updates, and tells the forecast
/// what all updates take at that speed. Nothing is told of a program that fails there (its run in
/// the contest will say why), and nothing of a log with fewer than thirty updates.
void tryBeginnings(const Contest& contest, const LogUpdates& updates, Forecast& forecast);

}  // namespace ariadne::compare_app
