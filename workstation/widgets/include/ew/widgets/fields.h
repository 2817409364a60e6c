#pragma once

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QKeyEvent>
#include <QWheelEvent>
#include <algorithm>

#include "ew/widgets/theme.h"

namespace ew {

/// An editor of a value whose undo belongs to the host: Ctrl+Z in it takes back the last edit of the case, instead of a private history
/// that would count as one edit more.
template <class Editor>
class WithHostUndo : public Editor {
 public:
  using Editor::Editor;

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::ShortcutOverride) {
      const auto* key = static_cast<QKeyEvent*>(event);
      if (key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo)) {
        event->ignore();  // not claimed here, so the window's action gets it
        return true;
      }
    }
    return Editor::event(event);
  }
};

/// An editor that the wheel changes only when it has the focus, so that scrolling past it changes nothing.
template <class Editor>
class WheelWithFocus : public Editor {
 public:
  using Editor::Editor;

 protected:
  void wheelEvent(QWheelEvent* event) override {
    if (Editor::hasFocus())
      Editor::wheelEvent(event);
    else
      event->ignore();
  }
};

class NumberField final : public WheelWithFocus<WithHostUndo<QDoubleSpinBox>> {
 public:
  NumberField(double lowest, double highest, int decimals, const QString& unit, QWidget* parent = nullptr) : WheelWithFocus(parent) {
    setRange(lowest, highest);
    setDecimals(decimals);
    if (!unit.isEmpty()) setSuffix(QStringLiteral(" ") + unit);
    setAlignment(Qt::AlignRight);
    setFocusPolicy(Qt::StrongFocus);
    setKeyboardTracking(true);
    setMinimumWidth(11 * kGrid_px);
  }
};

/// A choice that becomes narrower than its longest text where the form has no room for it.
class ChoiceField final : public WheelWithFocus<QComboBox> {
 public:
  explicit ChoiceField(QWidget* parent = nullptr) : WheelWithFocus(parent) {}
  [[nodiscard]] QSize minimumSizeHint() const override {
    const QSize whole = QComboBox::minimumSizeHint();
    return {std::min(whole.width(), kLeastLetters * fontMetrics().averageCharWidth() + kBesideText_px), whole.height()};
  }

 private:
  static constexpr int kLeastLetters = 8, kBesideText_px = 32;  ///< its arrow and edges
};

}  // namespace ew
