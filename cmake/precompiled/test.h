#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "library.h"
