#pragma once

// What tests reach: the host that the plugins of a window speak with.

#include "plugins/workstation_host.h"
