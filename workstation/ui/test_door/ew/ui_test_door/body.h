#pragma once

// What tests reach: the 3D view, and the hand that slides the probe in it.

#include "body/hand_input.h"
#include "body/view3d.h"
