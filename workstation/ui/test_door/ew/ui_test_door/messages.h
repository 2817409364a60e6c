#pragma once

// What tests reach: the bar that tells what went wrong or was done.

#include "jobs/message_bar.h"
