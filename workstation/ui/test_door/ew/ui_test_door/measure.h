#pragma once

// What tests reach: calipers on image and strip, and the words for them.

#include "measure/caliper_tool_row.h"
#include "measure/calipers/caliper_layer.h"
#include "measure/calipers/calipers.h"
#include "measure/combine_dialog.h"
#include "measure/words/caliper_words.h"
