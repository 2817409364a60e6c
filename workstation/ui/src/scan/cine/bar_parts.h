#pragma once

#include <QPushButton>

#include "ew/widgets/look.h"

namespace ew::ui {

inline constexpr int kBarTick_ms = 20;  ///< between two looks at the clock while something plays

/// A button of the bars below the scan, without a word on it yet.
/// @param name object name @param tip also what a screen reader says
inline QPushButton* smallButton(const char* name, const QString& tip) {
  auto* button = new QPushButton;
  button->setObjectName(QString::fromLatin1(name));
  setLook(button, Look::compact);
  button->setFocusPolicy(Qt::TabFocus);  // a click must not take the arrow keys away
  button->setAccessibleName(tip);
  button->setToolTip(tip);
  return button;
}

}  // namespace ew::ui
