#pragma once

// What tests reach: the console's pages and what an image costs.

#include "scan/console/console_panel.h"
#include "scan/cost/cost_chart.h"
#include "scan/cost/cost_panel.h"
