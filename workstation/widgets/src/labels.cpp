#include "ew/widgets/labels.h"

#include <QPushButton>
#include <QVBoxLayout>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"

namespace ew {

QLabel* headingLabel(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  setLook(label, Look::heading);
  return label;
}

QLabel* quietLabel(const QString& text, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  setLook(label, Look::quiet);
  label->setWordWrap(true);
  return label;
}

QLabel* problemLabel(QWidget* parent) {
  auto* label = new QLabel(parent);
  label->setForegroundRole(QPalette::BrightText);
  label->setWordWrap(true);
  label->setVisible(false);
  return label;
}

void setProblem(QLabel* label, const QString& sentence) {
  label->setText(sentence);
  label->setVisible(!sentence.isEmpty());
}

QWidget* emptyState(const QString& title, const QString& sentence, QPushButton* button, QWidget* parent) {
  auto* page = new QWidget(parent);
  auto* column = new QVBoxLayout(page);
  column->setContentsMargins(3 * kGrid_px, 3 * kGrid_px, 3 * kGrid_px, 3 * kGrid_px);
  column->setSpacing(kGrid_px);
  column->addStretch(1);
  column->addWidget(headingLabel(title), 0, Qt::AlignHCenter);
  auto* hint = quietLabel(sentence);
  hint->setAlignment(Qt::AlignHCenter);
  column->addWidget(hint);
  if (button != nullptr) {
    setLook(button, Look::primary);
    column->addSpacing(kGrid_px);
    column->addWidget(button, 0, Qt::AlignHCenter);
  }
  column->addStretch(2);
  return page;
}

}  // namespace ew
