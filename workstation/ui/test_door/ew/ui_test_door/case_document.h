#pragma once

// What tests reach: the open case with its undo and what of it is not saved; of Qt's widgets the undo stack alone.

#include "case/case_document.h"
