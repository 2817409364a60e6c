#pragma once

// What tests reach: who holds work that could be lost: values alone.

#include "window/frame/unsaved_work.h"
