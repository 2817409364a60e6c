#pragma once

// What tests reach: what spectral Doppler puts on an image, its sample volume under the mouse, and its sound.

#include "scan/doppler/doppler_speaker.h"
#include "scan/doppler/gate_drag.h"
#include "scan/spectrum_on_image.h"
#include "scan/spectrum_trace.h"
