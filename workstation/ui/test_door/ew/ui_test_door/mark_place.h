#pragma once

// What tests reach: where the body mark lies beside the fan: values alone.

#include "annotate/mark_place.h"
#include "scan/fan_rects.h"
