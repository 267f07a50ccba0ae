// Everything that experiment tables take their intervals, tests and plans from.
#pragma once
#include "ariadne/eval/exact_tests.h"
#include "ariadne/eval/interval.h"
#include "ariadne/eval/plan.h"
