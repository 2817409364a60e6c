#pragma once

// What tests reach: worksheets: list, dialog, files, words.

#include "measure/words/worksheet_words.h"
#include "measure/worksheets/worksheet_dialog.h"
#include "measure/worksheets/worksheet_file.h"
#include "measure/worksheets/worksheets.h"
