// What a plugin is to theme_gui_test.cpp: a library with a copy of ew_widgets of its own.

#include "ew/widgets/theme.h"

#define EW_COPY extern "C" __attribute__((visibility("default")))

EW_COPY bool copyIsDark() { return ew::currentTheme().dark; }
EW_COPY int copyScaled(int px) { return ew::scaled(px); }
EW_COPY void copyHoldsWidth(QWidget* widget, int px) { ew::holdFixedWidth(*widget, px); }
