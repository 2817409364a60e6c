#pragma once

// What tests reach: what colour Doppler puts on an image, and its box under the mouse.

#include "scan/colour_on_image.h"
#include "scan/doppler/colour_box_drag.h"
