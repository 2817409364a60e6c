#pragma once

// What tests reach: the page of trackers, the guided set-up, tracking as the scan shows it.

#include "scan/tracking_look.h"
#include "scan/tracking_overlay.h"
#include "trackers/control/scan_server.h"
#include "trackers/control/tracker_control.h"
#include "trackers/tracker_page.h"
#include "trackers/wizard/tracker_align_step.h"
#include "trackers/wizard/tracker_body_drawing.h"
#include "trackers/wizard/tracker_camera_steps.h"
#include "trackers/wizard/tracker_camera_view.h"
#include "trackers/wizard/tracker_check_step.h"
#include "trackers/wizard/tracker_wizard.h"
