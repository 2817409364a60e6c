#pragma once

#include <QCoreApplication>
#include <QKeySequence>
#include <QString>

#include "ew/imaging/effect_info.h"

namespace ew::ui {

/// A text of effect_info.h in the window's language.
inline QString effectText(const char* source) { return QCoreApplication::translate(kEffectTexts, source); }

/// A tip with the key stroke, if there is one, as the system's language calls it.
inline QString effectTip(const char* tip, const char* keyStroke) {
  const QString keys = QKeySequence(QLatin1String(keyStroke)).toString(QKeySequence::NativeText);
  return keys.isEmpty() ? effectText(tip) : QStringLiteral("%1 (%2)").arg(effectText(tip), keys);
}

}  // namespace ew::ui
