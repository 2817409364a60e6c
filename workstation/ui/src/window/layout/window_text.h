#pragma once

#include <QCoreApplication>
#include <QString>

namespace ew::ui {

/// Words of the window for rooms that stand below it: they are translated among its own.
struct WindowText {
  static QString tr(const char* source, const char* comment = nullptr, int count = -1) {
    return QCoreApplication::translate("ew::ui::MainWindow", source, comment, count);
  }
};

}  // namespace ew::ui
