#include "jobs/message_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <utility>

#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

constexpr int kNoteStays_ms = 60000;
constexpr int kMostDetails_px = 120;  ///< six lines; more are scrolled, so that a small window keeps its views

}  // namespace

MessageBar::MessageBar(QWidget* parent) : QFrame(parent) {
  setObjectName(QStringLiteral("messageBar"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(16, 4, 8, 4);
  rows->setSpacing(4);
  auto* row = new QHBoxLayout;
  row->setSpacing(16);
  const auto textLabel = [](const char* name) {
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
  };
  sentence_ = textLabel("messageText");
  details_ = textLabel("messageDetails");
  more_ = new QLabel;
  setLook(more_, Look::quiet);
  unfold_ = new QPushButton(tr("Details"));
  unfold_->setObjectName(QStringLiteral("unfoldMessage"));
  unfold_->setCheckable(true);
  unfold_->setFocusPolicy(Qt::TabFocus);
  offer_ = new QPushButton;
  offer_->setObjectName(QStringLiteral("takeOffer"));
  setLook(offer_, Look::primary);
  offer_->setFocusPolicy(Qt::TabFocus);
  connect(offer_, &QPushButton::clicked, this, [this] {
    if (const auto taken = takePressed(); taken && taken->run) taken->run();
  });
  close_ = new QPushButton;
  close_->setObjectName(QStringLiteral("dismissMessage"));
  setLook(close_, Look::flat);
  close_->setToolTip(tr("Dismiss (Esc)"));
  close_->setAccessibleName(tr("Dismiss"));
  holdFixedWidth(*close_, 32);
  holdFixedHeight(*close_, 32);
  close_->setFocusPolicy(Qt::TabFocus);  // it vanishes with its message; the focus had better stay where it was
  row->addWidget(sentence_, 1);
  row->addWidget(more_);
  row->addWidget(unfold_);
  row->addWidget(offer_);
  row->addWidget(close_, 0, Qt::AlignTop);
  rows->addLayout(row);
  fold_ = new QScrollArea;
  fold_->setWidget(details_);
  fold_->setWidgetResizable(true);
  fold_->setFocusPolicy(Qt::TabFocus);
  fold_->viewport()->setAutoFillBackground(false);
  details_->setAutoFillBackground(false);
  details_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  rows->addWidget(fold_);
  connect(unfold_, &QPushButton::toggled, this, [this] {
    fold_->setVisible(unfold_->isChecked());
    waitForPassing(true);
    Q_EMIT rearranged();
  });
  passes_.setObjectName(QStringLiteral("notePasses"));
  passes_.setSingleShot(true);
  passes_.setInterval(kNoteStays_ms);
  connect(&passes_, &QTimer::timeout, this, [this] {
    if (underMouse()) return passes_.start();  // somebody is about to do something with it
    dismiss();
  });
  connect(close_, &QPushButton::clicked, this, &MessageBar::takePressed);
  // Another message may come to the front between press and click; keys and click() press, too.
  for (const QPushButton* button : {offer_, close_})
    connect(button, &QPushButton::pressed, this, [this] { pressed_ = front() != nullptr ? front()->id : 0; });
  refreshIcons();
  refresh();
}

void MessageBar::refreshIcons() { close_->setIcon(icon(QStringLiteral("close"))); }

void MessageBar::showError(const Error& error, const QString& topic) {
  QStringList facts;
  for (const auto& [key, value] : error.context) facts << QStringLiteral("%1: %2").arg(words(key), words(value));
  add({Kind::error, words(error.message), {}, facts.join(QLatin1Char('\n')), topic});
}

void MessageBar::showError(const QString& sentence, const QString& topic) { add({Kind::error, sentence, {}, {}, topic}); }
void MessageBar::showNote(const QString& sentence, const QString& topic) { add({Kind::note, sentence, {}, {}, topic}); }

void MessageBar::showOffer(const QString& sentence, const QString& button, std::function<void()> run, const QString& topic) {
  add({Kind::note, sentence, {}, {}, topic, button, std::move(run)});
}

void MessageBar::showNotes(const QString& summary, const std::vector<Message>& sentences, const QString& topic) {
  if (sentences.empty()) return forget(topic);
  if (sentences.size() == 1) return showNote(words(sentences.front()), topic);
  QStringList lines;
  for (const Message& sentence : sentences) lines << words(sentence);
  add({Kind::note, summary, lines.join(QLatin1Char('\n')), {}, topic});
}

void MessageBar::forgetWhatIsPast() {
  std::erase_if(waiting_, [](const Line& one) { return !one.topic.isEmpty() && !one.run; });  // an offer still stands
  refresh();
}

void MessageBar::forget(const QString& topic) {
  if (topic.isEmpty()) return;
  std::erase_if(waiting_, [&](const Line& one) { return one.topic == topic; });
  refresh();
}

void MessageBar::add(Line message) {
  const auto isSaidAgain = [&](const Line& one) { return one.kind == message.kind && one.sentence == message.sentence; };
  const auto again = std::find_if(waiting_.begin(), waiting_.end(), isSaidAgain);
  // Whoever dismisses a message means it however often it is said; of two offers only the one that was pressed is taken.
  message.id = again != waiting_.end() && !again->run && !message.run ? again->id : nextId_++;
  // What is said again tells nothing new, and what was said of the same topic before is past.
  std::erase_if(waiting_, [&](const Line& one) { return (!message.topic.isEmpty() && one.topic == message.topic) || isSaidAgain(one); });
  const auto at = message.kind == Kind::error
                      ? waiting_.end()
                      : std::find_if(waiting_.begin(), waiting_.end(), [](const Line& one) { return one.kind == Kind::error; });
  waiting_.insert(at, std::move(message));
  refresh();
}

const MessageBar::Line* MessageBar::front() const { return waiting_.empty() ? nullptr : &waiting_.back(); }
QString MessageBar::text() const { return front() != nullptr ? front()->sentence : QString(); }
QString MessageBar::details() const { return front() != nullptr ? front()->details : QString(); }
bool MessageBar::isError() const { return front() != nullptr && front()->kind == Kind::error; }

/// Its words get their size only when it is in sight, after whoever places it has asked for its height.
bool MessageBar::event(QEvent* event) {
  const bool isDone = QFrame::event(event);
  if (event->type() == QEvent::LayoutRequest && !isHidden()) Q_EMIT rearranged();
  return isDone;
}

int MessageBar::heightFor(int width_px) const {
  const QLayout& rows = *layout();
  return rows.hasHeightForWidth() ? rows.totalHeightForWidth(width_px) : rows.totalSizeHint().height();
}

void MessageBar::dismiss() {
  if (!waiting_.empty()) waiting_.pop_back();
  refresh();
}

std::optional<MessageBar::Line> MessageBar::takePressed() {
  const auto pressed = std::find_if(waiting_.begin(), waiting_.end(), [this](const Line& one) { return one.id == pressed_; });
  if (pressed == waiting_.end()) return std::nullopt;
  Line taken = std::move(*pressed);
  waiting_.erase(pressed);
  refresh();
  return taken;
}

void MessageBar::refresh() {
  const Line* first = front();
  setVisible(first != nullptr);
  bool isOther = true;
  if (first != nullptr) {
    setProperty("kind", first->kind == Kind::error ? QStringLiteral("error") : QStringLiteral("note"));
    style()->unpolish(this);
    style()->polish(this);
    const bool same = sentence_->text() == first->sentence && details_->text() == first->details;
    isOther = !same;
    sentence_->setText(first->sentence);
    sentence_->setToolTip(first->tip);
    details_->setText(first->details);
    fold_->setFixedHeight(std::min(
        scaled(kMostDetails_px), (static_cast<int>(first->details.count(QLatin1Char('\n'))) + 2) * details_->fontMetrics().lineSpacing()));
    unfold_->setVisible(!first->details.isEmpty());
    if (!same || first->details.isEmpty()) unfold_->setChecked(false);
    fold_->setVisible(unfold_->isChecked());
    offer_->setText(first->button);
    offer_->setVisible(!first->button.isEmpty());
    const int others = count() - 1;
    more_->setText(others > 0 ? tr("%n more", nullptr, others) : QString());
    more_->setVisible(others > 0);
  }
  waitForPassing(isOther);
  Q_EMIT rearranged();
}

void MessageBar::setNotesPassAfter(int stay_ms) {
  passes_.setInterval(stay_ms);
  waitForPassing(true);
}

void MessageBar::waitForPassing(bool isOther) {
  const Line* first = front();
  if (first == nullptr || first->kind == Kind::error || first->run || unfold_->isChecked())
    passes_.stop();
  else if (isOther || !passes_.isActive())
    passes_.start();
}

}  // namespace ew::ui
