#pragma once

#include <QString>

namespace ew::ui {

/// A text that people wrote, as an entry of a menu: a menu shows & as the key of an entry.
[[nodiscard]] inline QString menuText(QString text) { return text.replace(QLatin1Char('&'), QStringLiteral("&&")); }

}  // namespace ew::ui
