#pragma once

// What tests reach: long work in the background, without widgets.

#include "jobs/jobs.h"
