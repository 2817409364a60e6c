#pragma once

// What tests reach: what is shown where, at every size of the window: values alone.

#include "window/layout/window_layout.h"
