#pragma once

#include <QPixmap>
#include <QString>
#include <QTest>
#include <QWidget>

namespace ew::ui::testing {

/// The folder for images that a person will look at; empty: none are kept.
inline QString screenshotFolder() { return qEnvironmentVariable("EW_SCREENSHOTS"); }

/// Keeps an image of a widget there as NAME.png.
inline void keepScreenshot(QWidget& widget, const char* name) {
  if (screenshotFolder().isEmpty()) return;
  QTest::qWait(300);  // what was asked of the window is painted
  widget.grab().save(screenshotFolder() + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".png"));
}

}  // namespace ew::ui::testing
