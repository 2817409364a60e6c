#pragma once

#include <QCoreApplication>
#include <QString>

#include "ew/imaging/effect_info.h"
#include "keys/key_table.h"
#include "keys/key_tips.h"

namespace ew::ui {

/// A text of effect_info.h in the window's language.
inline QString effectText(const char* source) { return QCoreApplication::translate(kEffectTexts, source); }

/// A tip with the keys of the effect, if it has any.
inline QString effectTip(const char* tip, const char* effectKey) {
  return tipWithKeys(effectText(tip) + QStringLiteral(" (%1)"), effectCommand(effectKey));
}

}  // namespace ew::ui
