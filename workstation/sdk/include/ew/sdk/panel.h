#pragma once

// Small Qt conveniences for the panels of plugins. Not part of the library ew_sdk: a plugin that includes this links Qt5::Widgets itself.
// Colours and sizes come from the workstation's theme by way of properties; a panel sets none of its own.

#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QWheelEvent>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>

#include "ew/sdk/placement.h"
#include "ew/widgets/look.h"
#include "ew/widgets/words.h"

namespace ew::sdk {

inline constexpr int kGap_px = 8;  ///< the workstation's grid

inline QLabel* headingLabel(const QString& text, QWidget* parent = nullptr) {
  auto* label = new QLabel(text, parent);
  setLook(label, Look::heading);
  return label;
}

inline QLabel* quietLabel(const QString& text, QWidget* parent = nullptr) {
  auto* label = new QLabel(text, parent);
  setLook(label, Look::quiet);
  label->setWordWrap(true);
  return label;
}

/// A line for what is wrong, in the theme's colour of danger, hidden while it is empty: setProblem shows and hides it.
inline QLabel* problemLabel(QWidget* parent = nullptr) {
  auto* label = new QLabel(parent);
  label->setForegroundRole(QPalette::BrightText);
  label->setWordWrap(true);
  label->setVisible(false);
  return label;
}
inline void setProblem(QLabel* label, const QString& sentence) {
  label->setText(sentence);
  label->setVisible(!sentence.isEmpty());
}

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
    setMinimumWidth(11 * kGap_px);
  }
};

/// What a panel shows while it has nothing to work on: what to do next, and where it makes sense one button that does it.
inline QWidget* emptyState(const QString& title, const QString& sentence, QPushButton* button = nullptr, QWidget* parent = nullptr) {
  auto* page = new QWidget(parent);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(3 * kGap_px, 3 * kGap_px, 3 * kGap_px, 3 * kGap_px);
  column->setSpacing(kGap_px);
  column->addStretch(1);
  column->addWidget(headingLabel(title), 0, Qt::AlignHCenter);
  auto* hint = quietLabel(sentence);
  hint->setAlignment(Qt::AlignHCenter);
  column->addWidget(hint);
  if (button != nullptr) {
    setLook(button, Look::primary);
    column->addSpacing(kGap_px);
    column->addWidget(button, 0, Qt::AlignHCenter);
  }
  column->addStretch(2);
  return page;
}

/// Six number fields for a rigid placement. Keeps the numbers as they were typed: a matrix that means the same does not rewrite them.
template <class To, class From>
class PlacementFields final : public QWidget {
 public:
  explicit PlacementFields(QWidget* parent = nullptr) : QWidget(parent) {
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setSpacing(kGap_px);
    static constexpr std::array<const char*, 6> names = {"x", "y", "z", "rx", "ry", "rz"};
    const std::array<QString, 6> hints = {tr_("Towards the patient's left"), tr_("Towards the back"),      tr_("Towards the head"),
                                          tr_("Turn about the x axis"),      tr_("Turn about the y axis"), tr_("Turn about the z axis")};
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const bool length = i < 3;
      const QString unit = length ? QStringLiteral("mm") : QStringLiteral("°");
      auto* field = new NumberField(length ? -1e5 : -360.0, length ? 1e5 : 360.0, 3, unit, this);
      field->setObjectName(QLatin1String("placement_") + QLatin1String(names[i]));
      field->setToolTip(hints[i]);
      field->setAccessibleName(hints[i]);
      auto* name = quietLabel(QLatin1String(names[i]), this);
      name->setWordWrap(false);
      name->setBuddy(field);
      const int row = static_cast<int>(i % 3);
      const int column = length ? 0 : 2;
      grid->addWidget(name, row, column);
      grid->addWidget(field, row, column + 1);
      connect(field, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this, i](double value) {
        (i < 3 ? shown_.at_mm : shown_.rotation_deg)[static_cast<int>(i % 3)] = value;
        transform_ = transformOf<To, From>(shown_);
        if (onChanged) onChanged(transform_, names[i]);
      });
      fields_[i] = field;
    }
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
  }

  /// The exact matrix: what was set, until a field is edited.
  [[nodiscard]] const Transform<To, From>& transform() const { return transform_; }

  void setTransform(const Transform<To, From>& rigid) {
    double difference = 0.0;
    const auto now = transformOf<To, From>(shown_);
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r) difference = std::max(difference, std::abs(now.matrix[c][r] - rigid.matrix[c][r]));
    transform_ = rigid;
    if (difference < 1e-9) return;
    shown_ = placementOf(rigid);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
      const QSignalBlocker quiet(fields_[i]);
      fields_[i]->setValue((i < 3 ? shown_.at_mm : shown_.rotation_deg)[static_cast<int>(i % 3)]);
    }
  }

  /// Called when the user edits a field: "x", "y", "z", "rx", "ry" or "rz". Undo takes back one field, not all that were typed in a row.
  std::function<void(const Transform<To, From>&, const std::string& field)> onChanged;

 private:
  static QString tr_(const char* text) { return QCoreApplication::translate("ew::sdk::PlacementFields", text); }
  std::array<NumberField*, 6> fields_{};
  Placement shown_;
  Transform<To, From> transform_;
};

}  // namespace ew::sdk
