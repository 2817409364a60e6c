#pragma once

#include <QStringList>
#include <initializer_list>

class QComboBox;
class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QWidget;

namespace ew::ui {

/// What is said beside a field, in a line or two; a dash at first.
[[nodiscard]] QLabel* valueLabel(const char* name);
/// Small sentences, in as many lines as they need.
[[nodiscard]] QLabel* smallText(const char* name);
/// A choice whose list is as wide as its words while the field may be narrower.
[[nodiscard]] QComboBox* narrowChoice();
[[nodiscard]] QDoubleSpinBox* numberBox(const char* name, double lowest, double highest, double step, int decimals, const QString& suffix);
/// The widgets side by side; lines of text take the room that is left.
[[nodiscard]] QHBoxLayout* inOneRow(std::initializer_list<QWidget*> widgets);
/// "a; b" as two names of files.
[[nodiscard]] QStringList filesIn(const QString& text);

}  // namespace ew::ui
