#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace ew::ui {

/// One of the program's own line icons (resources/icons/NAME.svg) in a colour, sharp at every size.
[[nodiscard]] QIcon icon(const QString& name, const QColor& colour);

/// In the colour of the current theme's words.
[[nodiscard]] QIcon icon(const QString& name);

}  // namespace ew::ui
