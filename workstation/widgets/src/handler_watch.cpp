#include "ew/widgets/handler_watch.h"

#include <QAbstractEventDispatcher>
#include <QMetaEnum>
#include <algorithm>
#include <chrono>
#include <ctime>
#include <utility>

namespace ew {
namespace {

thread_local HandlerWatch* current = nullptr;

HandlerWatch::Times operator+(const HandlerWatch::Times& a, const HandlerWatch::Times& b) {
  return {a.wall_ms + b.wall_ms, a.worked_ms + b.worked_ms};
}
HandlerWatch::Times operator-(const HandlerWatch::Times& a, const HandlerWatch::Times& b) {
  return {a.wall_ms - b.wall_ms, a.worked_ms - b.worked_ms};
}

}  // namespace

HandlerWatch::HandlerWatch(double bound_ms, std::function<Times()> now)
    : bound_ms_(bound_ms), now_(std::move(now)), before_(std::exchange(current, this)) {}

HandlerWatch::~HandlerWatch() { current = before_; }

HandlerWatch::Entered::Entered(HandlerWatch& entered, Handled handled) : watch(entered) { watch.enter(std::move(handled)); }

HandlerWatch::Entered::~Entered() { watch.leave(); }

HandlerWatch::Part::Part(const char* name) : watch_(current) {
  if (watch_ == nullptr) return;
  Handled handled;
  handled.part = name;
  watch_->enter(std::move(handled));
}

HandlerWatch::Part::~Part() {
  if (watch_ != nullptr) watch_->leave();
}

void HandlerWatch::enter(Handled handled) {
  handled.begun = now_();
  open_.push_back(std::move(handled));
}

void HandlerWatch::leave() {
  const Handled handled = std::move(open_.back());
  open_.pop_back();
  const Times took = now_() - handled.begun;
  if (!open_.empty()) open_.back().inside = open_.back().inside + took;
  const Times own = took - handled.inside;
  if (handled.isWaiting || own.wall_ms <= bound_ms_) return;
  const QString name = nameOf(handled);
  Slow& slow = slow_[name];
  slow.name = name;
  ++slow.count;
  slow.total = slow.total + own;
  const bool isWorth = own.wall_ms > 2.0 * slow.worst.wall_ms;
  slow.worst = {std::max(slow.worst.wall_ms, own.wall_ms), std::max(slow.worst.worked_ms, own.worked_ms)};
  if (isWorth && told) told(slow);
}

void HandlerWatch::wait() {
  Handled waiting;
  waiting.isWaiting = true;
  enter(std::move(waiting));
}

void HandlerWatch::wake() {
  if (!open_.empty() && open_.back().isWaiting) leave();
}

void HandlerWatch::follow(const QAbstractEventDispatcher& loop) {
  QObject::connect(&loop, &QAbstractEventDispatcher::aboutToBlock, &follower_, [this] { wait(); });
  QObject::connect(&loop, &QAbstractEventDispatcher::awake, &follower_, [this] { wake(); });
}

HandlerWatch::Times HandlerWatch::threadNow() {
  timespec worked{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &worked);
  return {std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count(),
          1e3 * static_cast<double>(worked.tv_sec) + 1e-6 * static_cast<double>(worked.tv_nsec)};
}

QString HandlerWatch::namedAbove(const QObject& receiver) {
  if (!receiver.objectName().isEmpty()) return {};
  for (const QObject* above = receiver.parent(); above != nullptr; above = above->parent())
    if (!above->objectName().isEmpty()) return above->objectName();
  return {};
}

QString HandlerWatch::nameOf(const Handled& handled) {
  if (handled.part != nullptr) return QString::fromUtf8(handled.part);
  QString name = QString::fromLatin1(handled.className);
  if (!handled.name.isEmpty()) name += QStringLiteral(" '%1'").arg(handled.name);
  if (!handled.nameAbove.isEmpty()) name += QStringLiteral(" in '%1'").arg(handled.nameAbove);
  const char* const type = QMetaEnum::fromType<QEvent::Type>().valueToKey(handled.type);
  return name + QStringLiteral(", ") + (type != nullptr ? QString::fromLatin1(type) : QStringLiteral("event %1").arg(handled.type));
}

std::vector<HandlerWatch::Slow> HandlerWatch::slow() const {
  std::vector<Slow> all;
  for (const auto& [name, each] : slow_) all.push_back(each);
  std::sort(all.begin(), all.end(), [](const Slow& a, const Slow& b) { return a.total.wall_ms > b.total.wall_ms; });
  return all;
}

}  // namespace ew
