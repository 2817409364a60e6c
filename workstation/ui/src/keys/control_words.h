#pragma once

#include <QCoreApplication>
#include <QString>

#include "ew/controls/binding.h"
#include "ew/controls/learn.h"

namespace ew::ui {

/// What people read about knobs and buttons.
class ControlWords {
  Q_DECLARE_TR_FUNCTIONS(ew::ui::ControlWords)

 public:
  [[nodiscard]] static QString nameOf(const controls::ControlId& control);  ///< "control 16 (channel 1)"
  [[nodiscard]] static QString nameOf(controls::Encoding encoding);
  [[nodiscard]] static QString sentenceOf(controls::Learner::Needs needs, controls::Target::Kind wanted);
};

}  // namespace ew::ui
