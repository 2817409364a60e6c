#pragma once

// What tests reach: recording, the loop of a frozen scan, replay.

#include "scan/cine/cine_bar.h"
#include "scan/cine/recorder.h"
#include "scan/cine/replay_bar.h"
