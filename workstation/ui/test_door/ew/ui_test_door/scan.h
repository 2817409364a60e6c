#pragma once

// What tests reach: the session, the scan view, what a click points at, the status line.

#include "scan/pick_layer.h"
#include "scan/scan_view.h"
#include "scan/session.h"
#include "scan/status_line.h"
