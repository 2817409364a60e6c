#pragma once

#include <QString>

class QWidget;

namespace ew {

/// Asks a person about a result that keeps less than a tenth of the pixels or of the frames. @return whether it is meant
/// @param sentence what would be kept, as questionAbout says it
[[nodiscard]] bool askAcceptsSmall(QWidget* parent, const QString& sentence);

}  // namespace ew
