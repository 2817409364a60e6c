#pragma once

// What tests reach: columns and their tabs, the tour, language, what is guarded, asked about and resumed.

#include "window/features/resuming.h"
#include "window/features/unsaved_volumes.h"
#include "window/frame/column_tabs.h"
#include "window/frame/columns.h"
#include "window/frame/safe_application.h"
#include "window/frame/tour.h"
#include "window/frame/view_columns.h"
#include "window/language.h"
