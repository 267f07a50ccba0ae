// Everything that experiment tables take their intervals, tests and plans from.
#pragma once
#include "ariadne/statistics/exact_tests.h"
#include "ariadne/statistics/interval.h"
#include "ariadne/statistics/plan.h"
