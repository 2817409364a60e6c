#pragma once

// What tests reach: the 3D view with its canvas, and the hand that slides the probe in it.

#include "body/hand_input.h"
#include "body/view3d.h"
#include "ew/body/body_canvas.h"
