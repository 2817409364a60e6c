#pragma once

// What tests reach: which voxel, frame and pixel a point of the scan comes from.

#include "scan/source/source_dialog.h"
#include "scan/source/source_picker.h"
