#include "ew/core/responsive_thread.h"

/// As a plugin asks, which has core inside and hides its symbols.
extern "C" __attribute__((visibility("default"))) bool copySeesTheMark() { return ew::isResponsiveThread(); }
