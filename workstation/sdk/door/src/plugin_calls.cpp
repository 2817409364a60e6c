#include "plugin_calls.h"

#include <algorithm>

namespace ew::door {

void PluginCalls::tell(const PluginFault& fault) {
  if (told_.insert(fault.moment).second && tell_) tell_(fault);
}

void PluginCalls::whenMade(std::function<void()> place) {
  if (isWithdrawn()) return;
  if (made_) {
    place();
  } else {
    waiting_.push_back(std::move(place));
  }
}

void PluginCalls::made() {
  made_ = true;
  for (const auto& place : std::exchange(waiting_, {})) place();
}

sdk::Cases::Ticket PluginCalls::keepTicket(sdk::Cases::Ticket ticket) {
  std::erase_if(tickets_, [](const auto& one) { return one.expired(); });
  auto kept = std::make_shared<sdk::Cases::Ticket>(std::move(ticket));
  tickets_.push_back(kept);
  return kept;
}

void PluginCalls::withdraw() {
  {
    std::unique_lock lock(mutex_);
    withdrawn_ = true;
    ended_.wait(lock, [this] { return working_ == 0; });
  }
  waiting_.clear();
  for (const auto& weak : std::exchange(tickets_, {}))
    if (const auto kept = weak.lock()) kept->reset();
}

bool PluginCalls::isWithdrawn() const {
  const std::lock_guard lock(mutex_);
  return withdrawn_;
}

Error PluginCalls::notRunning() const {
  return {ErrorCode::notFound, say<"The plugin '%1' is not running any more; start the program again.">(plugin_), {{"plugin", plugin_}}};
}

PluginCalls::Working::Working(PluginCalls& calls) : calls_(calls) {
  const std::lock_guard lock(calls_.mutex_);
  if (calls_.withdrawn_) return;
  began_ = true;
  ++calls_.working_;
}

PluginCalls::Working::~Working() {
  if (!began_) return;
  const std::lock_guard lock(calls_.mutex_);
  --calls_.working_;
  calls_.ended_.notify_all();
}

}  // namespace ew::door
