#pragma once

// What tests reach: the preparation of cases in the background, without widgets.

#include "case/case_preparation.h"
