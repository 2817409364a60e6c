#pragma once

// What tests reach: what a crash has left of a window, read without a screen.

#include "window/frame/work_autosave.h"
