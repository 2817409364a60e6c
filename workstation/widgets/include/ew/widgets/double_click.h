#pragma once

#include <QWidget>
#include <functional>

namespace ew {

/// Calls `act` in place of what a double click on the widget would do. Lives as long as the widget.
void onDoubleClick(QWidget* widget, std::function<void()> act);

}  // namespace ew
