#include "message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVariant>
#include <algorithm>

#include "icons.h"
#include "words.h"

namespace ew::ui {

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("messageBar"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 8, 8, 8);
  row->setSpacing(16);
  sentence_ = new QLabel;
  sentence_->setObjectName(QStringLiteral("messageText"));
  sentence_->setWordWrap(true);
  sentence_->setTextFormat(Qt::PlainText);
  sentence_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  more_ = new QLabel;
  more_->setProperty("quiet", true);
  close_ = new QPushButton;
  close_->setObjectName(QStringLiteral("dismissMessage"));
  close_->setProperty("flat", true);
  close_->setToolTip(tr("Dismiss (Esc)"));
  close_->setAccessibleName(tr("Dismiss"));
  close_->setFixedSize(32, 32);
  close_->setFocusPolicy(Qt::TabFocus);  // it vanishes with its message; the focus had better stay where it was
  row->addWidget(sentence_, 1);
  row->addWidget(more_);
  row->addWidget(close_, 0, Qt::AlignTop);
  connect(close_, &QPushButton::clicked, this, &MessageBar::dismiss);
  refreshIcons();
  hide();
}

void MessageBar::refreshIcons() { close_->setIcon(icon(QStringLiteral("close"))); }

void MessageBar::showError(const Error& error) {
  QStringList details;
  for (const auto& [key, value] : error.context) details << QStringLiteral("%1: %2").arg(words(key), words(value));
  add({QStringLiteral("error"), words(error.sentence), details.join(QLatin1Char('\n'))});
}

void MessageBar::showError(const QString& sentence) { add({QStringLiteral("error"), sentence, {}}); }
void MessageBar::showNote(const QString& sentence) { add({QStringLiteral("note"), sentence, {}}); }

void MessageBar::add(Message message) {
  // The same sentence twice in a row tells nothing new.
  if (!waiting_.empty() && waiting_.back().sentence == message.sentence) return;
  waiting_.push_back(std::move(message));
  refresh();
}

QString MessageBar::text() const { return waiting_.empty() ? QString() : waiting_.front().sentence; }
bool MessageBar::isError() const { return !waiting_.empty() && waiting_.front().kind == QLatin1String("error"); }

void MessageBar::dismiss() {
  if (!waiting_.empty()) waiting_.pop_front();
  refresh();
}

void MessageBar::refresh() {
  setVisible(!waiting_.empty());
  if (waiting_.empty()) return;
  const Message& first = waiting_.front();
  setProperty("kind", first.kind);
  style()->unpolish(this);
  style()->polish(this);
  sentence_->setText(first.sentence);
  sentence_->setToolTip(first.details);
  const int others = static_cast<int>(waiting_.size()) - 1;
  more_->setText(others > 0 ? tr("%n more", nullptr, others) : QString());
  placeIn(area_);
}

void MessageBar::placeIn(const QRect& area) {
  area_ = area;
  if (waiting_.empty() || area.isEmpty()) return;
  const int width = std::min(area.width() - 32, 720);
  const int height = std::max(48, layout()->hasHeightForWidth() ? layout()->heightForWidth(width) : sizeHint().height());
  setGeometry(area.left() + (area.width() - width) / 2, area.top() + 12, width, height);
  raise();
}

}  // namespace ew::ui
