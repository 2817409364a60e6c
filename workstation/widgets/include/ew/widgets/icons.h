#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace ew {

/// One of the program's own line icons (resources/icons/NAME.svg) in a colour, sharp at every size.
[[nodiscard]] QIcon icon(const QString& name, const QColor& colour);

/// A line icon that somebody else brings: the text of an SVG whose strokes are "currentColor".
[[nodiscard]] QIcon iconOf(const QByteArray& svg, const QColor& colour);

/// In the colour of the current theme's words.
[[nodiscard]] QIcon icon(const QString& name);

}  // namespace ew
