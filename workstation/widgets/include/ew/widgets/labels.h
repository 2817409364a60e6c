#pragma once

#include <QLabel>
#include <QString>

class QPushButton;

namespace ew {

[[nodiscard]] QLabel* headingLabel(const QString& text, QWidget* parent = nullptr);
/// A hint of as many lines as it takes.
[[nodiscard]] QLabel* quietLabel(const QString& text, QWidget* parent = nullptr);

/// A line for what is wrong, in the theme's colour of danger, hidden while it is empty: setProblem shows and hides it.
[[nodiscard]] QLabel* problemLabel(QWidget* parent = nullptr);
void setProblem(QLabel* label, const QString& sentence);

/// What a panel shows while it has nothing to work on: what to do next, and where it makes sense one button that does it.
[[nodiscard]] QWidget* emptyState(const QString& title, const QString& sentence, QPushButton* button = nullptr, QWidget* parent = nullptr);

}  // namespace ew
