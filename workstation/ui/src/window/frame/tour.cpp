#include "window/frame/tour.h"

#include <QApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"

namespace ew::ui {
namespace {

constexpr int kBubble_px = 304;   // wide, at text of 100 %
constexpr int kFromEdge_px = 12;  // of the window
constexpr int kFromThing_px = 12;
constexpr int kRing_px = 3;
constexpr int kWatch_ms = 150;

}  // namespace

Tour::Tour(std::vector<Step> steps, std::function<bool(Place)> goTo, QWidget* window)
    : QFrame(window), steps_(std::move(steps)), goTo_(std::move(goTo)) {
  setObjectName(QStringLiteral("tourBubble"));
  setFocusPolicy(Qt::StrongFocus);
  setAccessibleName(tr("Tour"));
  const auto overlay = [window](const char* name) {
    auto* made = new QWidget(window);
    made->setObjectName(QLatin1String(name));
    made->setAttribute(Qt::WA_StyledBackground);
    made->setAttribute(Qt::WA_TransparentForMouseEvents);
    made->hide();
    return made;
  };
  ring_ = overlay("tourRing");
  pointer_ = overlay("tourPointer");
  makeRows();
  hide();
  window->installEventFilter(this);
  // What is pointed at moves with splitters, pages and panels of plugins; asking is simpler than listening to all of them.
  watch_.setInterval(kWatch_ms);
  connect(&watch_, &QTimer::timeout, this, &Tour::follow);
}

void Tour::makeRows() {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(16, 12, 16, 12);
  rows->setSpacing(kGrid_px);
  name_ = new QLabel;
  name_->setObjectName(QStringLiteral("tourName"));
  setLook(name_, Look::heading);
  name_->setWordWrap(true);
  text_ = new QLabel;
  text_->setObjectName(QStringLiteral("tourText"));
  text_->setWordWrap(true);
  count_ = new QLabel;
  count_->setObjectName(QStringLiteral("tourCount"));
  setLook(count_, Look::quiet);
  setLook(count_, Look::small);
  const auto button = [this](const char* name, const QString& text) {
    auto* made = new QPushButton(text);
    made->setObjectName(QLatin1String(name));
    made->installEventFilter(this);
    return made;
  };
  auto* leaves = button("tourLeave", tr("Leave"));
  setLook(leaves, Look::flat);
  leaves->setToolTip(tr("Leave the tour (Escape). Help, Tour begins it again."));
  back_ = button("tourBack", tr("Back"));
  next_ = button("tourNext", tr("Next"));
  setLook(next_, Look::primary);
  auto* line = new QHBoxLayout;
  line->setSpacing(kGrid_px);
  line->addWidget(count_);
  line->addStretch(1);
  line->addWidget(leaves);
  line->addWidget(back_);
  line->addWidget(next_);
  rows->addWidget(name_);
  rows->addWidget(text_);
  rows->addLayout(line);
  line_ = line;
  connect(leaves, &QPushButton::clicked, this, &Tour::leave);
  connect(back_, &QPushButton::clicked, this, &Tour::back);
  connect(next_, &QPushButton::clicked, this, &Tour::next);
}

QWidget* Tour::thingOf(int step) const {
  if (step < 0 || step >= static_cast<int>(steps_.size())) return nullptr;
  QWidget* thing = steps_[static_cast<std::size_t>(step)].thing();
  return thing != nullptr && thing->isVisible() ? thing : nullptr;
}

void Tour::begin() {
  way_.clear();
  int first = 0;
  while (first < static_cast<int>(steps_.size()) && thingOf(first) == nullptr) ++first;
  if (first == static_cast<int>(steps_.size())) {
    for (first = 0; first < static_cast<int>(steps_.size()) && !tryStep(first);) ++first;
    if (first == static_cast<int>(steps_.size())) return leave();
  }
  before_ = QApplication::focusWidget();
  watch_.start();
  show(first);
  next_->setFocus(Qt::OtherFocusReason);
}

bool Tour::tryStep(int step) {
  if (thingOf(step) != nullptr) return true;
  const Step& wanted = steps_[static_cast<std::size_t>(step)];
  if (!goTo_(wanted.place)) return false;
  if (thingOf(step) == nullptr && wanted.bring) wanted.bring();
  return thingOf(step) != nullptr;
}

/// The steps form a ring that begins with the first one seen, so that the tour need not begin where the list does.
int Tour::neighbour(int way) const {
  const int count = static_cast<int>(steps_.size());
  const int next = (now_ + way + count) % count;
  return std::find(way_.begin(), way_.end(), next) == way_.end() ? next : -1;
}

void Tour::next() {
  const int from = now_;
  for (int to = neighbour(1); to >= 0; to = neighbour(1)) {
    if (tryStep(to)) return show(to);
    now_ = to;  // left out
    if (to == from) break;
    way_.push_back(to);
  }
  leave();
}

void Tour::back() {
  if (way_.size() < 2) return;
  do way_.pop_back();
  while (!way_.empty() && !tryStep(way_.back()));
  if (way_.empty()) return leave();
  const int to = way_.back();
  way_.pop_back();
  show(to);
}

void Tour::leave() {
  if (now_ < 0 && isHidden()) return;
  now_ = -1;
  watch_.stop();
  QWidget* before = before_.data();
  const bool hadFocus = isAncestorOf(QApplication::focusWidget()) || hasFocus();
  ring_->hide();
  pointer_->hide();
  hide();
  if (hadFocus && before != nullptr && before->isVisible()) before->setFocus(Qt::OtherFocusReason);
  Q_EMIT left();
}

void Tour::show(int step) {
  const Step& shown = steps_[static_cast<std::size_t>(step)];
  now_ = step;
  way_.push_back(step);
  const int count = static_cast<int>(steps_.size()), seen = static_cast<int>(way_.size());
  name_->setText(shown.name);
  text_->setText(shown.text);
  count_->setText(tr("%1 of %2").arg(seen).arg(count));
  back_->setEnabled(seen > 1);
  next_->setText(seen == count ? tr("Done") : tr("Next"));
  setAccessibleDescription(shown.name + QStringLiteral(". ") + shown.text);
  const bool keepsKeys = !isHidden() && isAncestorOf(QApplication::focusWidget());
  place();
  QFrame::show();
  raise();
  if (keepsKeys && !isAncestorOf(QApplication::focusWidget())) next_->setFocus(Qt::OtherFocusReason);
}

/// Whoever opens a case or turns to another page meanwhile goes on there; what is nowhere in sight leaves the bubble alone.
void Tour::follow() {
  if (now_ < 0) return;
  if (thingOf(now_) == nullptr) {
    for (int step = 0; step < static_cast<int>(steps_.size()); ++step)
      if (thingOf(step) != nullptr && std::find(way_.begin(), way_.end(), step) == way_.end()) {
        way_.pop_back();  // it went before it was read, and comes again
        return show(step);
      }
  }
  place();
}

/// Below, above or beside the thing, wherever there is room; else in the thing's lower corner. @param points where the pointer touches it
QRect Tour::bestPlace(const QRect& thing, const QSize& size, QPoint& points) const {
  const QRect area = parentWidget()->rect().adjusted(kFromEdge_px, kFromEdge_px, -kFromEdge_px, -kFromEdge_px);
  const QPoint middle = thing.center();
  const int x = std::clamp(middle.x() - size.width() / 2, area.left(), std::max(area.left(), area.right() - size.width()));
  const int y = std::clamp(middle.y() - size.height() / 2, area.top(), std::max(area.top(), area.bottom() - size.height()));
  const QRect right(QPoint(thing.right() + kFromThing_px, y), size), left(QPoint(thing.left() - kFromThing_px - size.width(), y), size);
  const QRect below(QPoint(x, thing.bottom() + kFromThing_px), size), above(QPoint(x, thing.top() - kFromThing_px - size.height()), size);
  const bool isMirrored = layoutDirection() == Qt::RightToLeft;
  for (const QRect& each : {below, isMirrored ? left : right, isMirrored ? right : left, above}) {
    if (!area.contains(each)) continue;
    points = each == below   ? QPoint(std::clamp(middle.x(), each.left() + 16, each.right() - 16), each.top())
             : each == above ? QPoint(std::clamp(middle.x(), each.left() + 16, each.right() - 16), each.bottom())
             : each == right ? QPoint(each.left(), std::clamp(middle.y(), each.top() + 16, each.bottom() - 16))
                             : QPoint(each.right(), std::clamp(middle.y(), each.top() + 16, each.bottom() - 16));
    return each;
  }
  points = QPoint();
  const QRect seen = thing.intersected(area);
  QRect inside(QPoint(seen.left() + kFromThing_px, seen.bottom() - kFromThing_px - size.height()), size);
  if (isMirrored) inside.moveRight(seen.right() - kFromThing_px);
  inside.moveLeft(std::clamp(inside.left(), area.left(), std::max(area.left(), area.right() - size.width())));
  inside.moveTop(std::clamp(inside.top(), area.top(), std::max(area.top(), area.bottom() - size.height())));
  return inside;
}

void Tour::place() {
  const QMargins edges = layout()->contentsMargins() + contentsMargins();
  const int wanted_px = std::max(scaled(kBubble_px), line_->sizeHint().width() + edges.left() + edges.right());
  const int width_px = std::min(wanted_px, parentWidget()->width() - 2 * kFromEdge_px);
  setFixedWidth(width_px);
  // A box layout asks a label once; embedded words may then take a line more.
  for (QLabel* each : {name_, text_}) each->setMinimumHeight(each->heightForWidth(width_px - edges.left() - edges.right()));
  const int height_px = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width_px) : sizeHint().height();
  const QSize size(width_px, std::min(height_px, parentWidget()->height() - 2 * kFromEdge_px));
  const QWidget* thing = thingOf(now_);
  if (thing == nullptr) {
    ring_->hide();
    pointer_->hide();
    const QPoint corner(kFromEdge_px, parentWidget()->height() - kFromEdge_px - size.height());
    setGeometry(QStyle::visualRect(layoutDirection(), parentWidget()->rect(), QRect(corner, size)));
    return;
  }
  const QRect seen = QRect(thing->mapTo(parentWidget(), QPoint()), thing->size()).intersected(parentWidget()->rect());
  QPoint points;
  const QRect best = bestPlace(seen, size, points);
  if (geometry() != best) setGeometry(best);
  if (ring_->geometry() != seen || ring_->isHidden()) {
    ring_->setGeometry(seen);
    const QRect all(QPoint(), seen.size());
    ring_->setMask(QRegion(all).subtracted(all.adjusted(kRing_px, kRing_px, -kRing_px, -kRing_px)));
    ring_->show();
    ring_->raise();
  }
  // A square on its corner, half of it below the bubble.
  pointer_->setVisible(!points.isNull());
  constexpr int kSide_px = 2 * kFromThing_px;
  const QRect square(points - QPoint(kFromThing_px, kFromThing_px), QSize(kSide_px, kSide_px));
  if (!points.isNull() && pointer_->geometry() != square) {
    pointer_->setGeometry(square);
    const QPolygon corners(
        {QPoint(kFromThing_px, 0), QPoint(kSide_px, kFromThing_px), QPoint(kFromThing_px, kSide_px), QPoint(0, kFromThing_px)});
    pointer_->setMask(QRegion(corners));
    pointer_->raise();
  }
  raise();
}

/// While the bubble has the keys, arrows, Escape and Space are its own and not the probe's.
bool Tour::takesKey(QEvent* event) {
  if (event->type() != QEvent::ShortcutOverride) return false;
  const int key = static_cast<QKeyEvent*>(event)->key();
  for (const int own : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Escape, Qt::Key_Return, Qt::Key_Enter, Qt::Key_Space}) {
    if (key != own) continue;
    event->accept();
    return true;
  }
  return false;
}

bool Tour::event(QEvent* event) { return takesKey(event) || QFrame::event(event); }

void Tour::keyPressEvent(QKeyEvent* event) {
  const bool isMirrored = layoutDirection() == Qt::RightToLeft;
  switch (event->key()) {
    case Qt::Key_Escape:
      return leave();
    case Qt::Key_Right:
    case Qt::Key_Left:
      return (event->key() == Qt::Key_Right) != isMirrored ? next() : back();
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Space:
      return next();
    default:
      return QFrame::keyPressEvent(event);
  }
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
  if (watched == parentWidget()) {
    if (event->type() == QEvent::Resize && now_ >= 0) place();
    return false;
  }
  if (takesKey(event)) return true;
  if (event->type() != QEvent::KeyPress) return false;
  auto* key = static_cast<QKeyEvent*>(event);
  const bool isEnter = key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter;
  if (isEnter) static_cast<QPushButton*>(watched)->click();
  const bool isOurs = key->key() == Qt::Key_Escape || key->key() == Qt::Key_Left || key->key() == Qt::Key_Right;
  if (isOurs) keyPressEvent(key);
  return isEnter || isOurs;
}

}  // namespace ew::ui
