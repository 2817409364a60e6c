#include "ew/widgets/handler_watch.h"

#include <QAbstractEventDispatcher>
#include <QMetaEnum>
#include <algorithm>
#include <chrono>
#include <utility>

namespace ew {
namespace {

thread_local HandlerWatch* current = nullptr;

}  // namespace

HandlerWatch::HandlerWatch(double bound_ms, std::function<double()> now_ms)
    : bound_ms_(bound_ms), now_ms_(std::move(now_ms)), before_(std::exchange(current, this)) {}

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
  handled.begun_ms = now_ms_();
  open_.push_back(std::move(handled));
}

void HandlerWatch::leave() {
  const Handled handled = std::move(open_.back());
  open_.pop_back();
  const double took_ms = now_ms_() - handled.begun_ms;
  if (!open_.empty()) open_.back().inside_ms += took_ms;
  const double own_ms = took_ms - handled.inside_ms;
  if (handled.isWaiting || own_ms <= bound_ms_) return;
  const QString name = nameOf(handled);
  Slow& slow = slow_[name];
  slow.name = name;
  ++slow.count;
  slow.total_ms += own_ms;
  const bool isWorth = own_ms > 2.0 * slow.worst_ms;
  slow.worst_ms = std::max(slow.worst_ms, own_ms);
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

double HandlerWatch::steadyNow_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
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
  std::sort(all.begin(), all.end(), [](const Slow& a, const Slow& b) { return a.total_ms > b.total_ms; });
  return all;
}

}  // namespace ew
