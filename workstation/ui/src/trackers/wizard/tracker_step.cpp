#include "trackers/wizard/tracker_step.h"

#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"

namespace ew::ui {

TrackerStep::TrackerStep(const QString& title, const QString& task, QWidget* parent) : QWidget(parent), title_(title) {
  rows_ = new QVBoxLayout(this);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(12);
  auto* heading = new QLabel(title);
  setLook(heading, Look::heading);
  rows_->addWidget(heading);
  auto* words = new QLabel(task);
  words->setWordWrap(true);
  rows_->addWidget(words);
}

QLabel* TrackerStep::addSentence(const char* objectName) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(objectName));
  label->setWordWrap(true);
  label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  holdLeastHeight(*label, 36);
  rows_->addWidget(label);
  return label;
}

void TrackerStep::say(QLabel& label, const QString& sentence, Tone tone) {
  const Theme& theme = currentTheme();
  QString sign, colour;
  switch (tone) {
    case Tone::plain:
      break;
    case Tone::good:
      sign = QStringLiteral("✓ ");
      colour = QStringLiteral("color: %1;").arg(theme.accent.name());
      break;
    case Tone::bad:
      sign = QStringLiteral("! ");
      colour = QStringLiteral("color: %1;").arg(theme.danger.name());
      break;
  }
  if (label.text() == sign + sentence) return;
  label.setStyleSheet(colour);
  label.setText(sentence.isEmpty() ? QString() : sign + sentence);
}

}  // namespace ew::ui
