#pragma once

// What tests reach: zoom by a box, the overview, the wide image.

#include "scan/zoom/box_zoom.h"
#include "scan/zoom/wide_layer.h"
#include "scan/zoom/wide_scan.h"
#include "scan/zoom/zoom_overview.h"
