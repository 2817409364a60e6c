#include "tracker_step.h"

#include <QLabel>
#include <QVBoxLayout>
#include <QVariant>

#include "theme.h"

namespace ew::ui {

TrackerStep::TrackerStep(const QString& title, const QString& task, QWidget* parent) : QWidget(parent), title_(title) {
  rows_ = new QVBoxLayout(this);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(12);
  auto* heading = new QLabel(title);
  heading->setProperty("heading", true);
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
  const QString sign = tone == Tone::good ? QStringLiteral("✓ ") : tone == Tone::bad ? QStringLiteral("! ") : QString();
  if (label.text() == sign + sentence) return;
  label.setStyleSheet(tone == Tone::good  ? QStringLiteral("color: %1;").arg(theme.accent.name())
                      : tone == Tone::bad ? QStringLiteral("color: %1;").arg(theme.danger.name())
                                          : QString());
  label.setText(sentence.isEmpty() ? QString() : sign + sentence);
}

}  // namespace ew::ui
