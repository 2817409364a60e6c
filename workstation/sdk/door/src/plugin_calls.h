#pragma once

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/progress.h"
#include "ew/door/fault.h"
#include "ew/sdk/host.h"

namespace ew::door {

/// Every way from the program into one plugin. What the plugin throws stops here; once the plugin is withdrawn nothing reaches it any more.
/// On the window's thread but for what is said otherwise. Shared by all that was registered, so that it outlives each of them.
class PluginCalls {
 public:
  using Tell = std::function<void(const PluginFault&)>;

  /// @param tell is called for the first fault of each moment
  PluginCalls(std::string plugin, Tell tell) : plugin_(std::move(plugin)), tell_(std::move(tell)) {}

  /// Calls into the plugin and tells of what it throws. @error what it threw, or that the plugin is withdrawn; then it was not called
  template <class Call>
  auto call(PluginMoment moment, const std::string& what, Call&& call) {
    return into(std::forward<Call>(call), [&](const Thrown& thrown) {
      const PluginFault fault = faultOf(moment, what, thrown);
      tell(fault);
      return errorOf(fault);
    });
  }
  /// The same without telling: the caller hands the error on.
  template <class Call>
  auto callForError(PluginMoment moment, const std::string& what, Call&& call) {
    return into(std::forward<Call>(call), [&](const Thrown& thrown) { return errorOf(faultOf(moment, what, thrown)); });
  }

  [[nodiscard]] PluginFault faultOf(PluginMoment moment, const std::string& what, const Thrown& thrown) const {
    return {plugin_, moment, what, thrown};
  }
  void tell(const PluginFault& fault);

  /// Puts something of the plugin into place: at once, or when the plugin has been made. Without effect once it is withdrawn.
  void whenMade(std::function<void()> place);
  /// The plugin has been made: everything that waited for it is put into place, in the order it was asked for.
  void made();

  /// Keeps hold of a ticket, so that it can be taken back. @return the ticket to hand out
  [[nodiscard]] sdk::Cases::Ticket keepTicket(sdk::Cases::Ticket ticket);
  /// Keeps a document as long as these calls.
  void keepDocument(std::shared_ptr<sdk::PanelDocument> document) { documents_.push_back(std::move(document)); }

  /// Takes everything back: what waited is forgotten, tickets are given back, running work is asked to stop and waited for, later calls do
  /// not reach the plugin.
  void withdraw();
  [[nodiscard]] bool isWithdrawn() const;  ///< from any thread

  /// Work of a job, from any thread: withdraw() waits for its end.
  class Working {
   public:
    explicit Working(PluginCalls& calls);
    ~Working();
    Working(const Working&) = delete;
    Working& operator=(const Working&) = delete;
    [[nodiscard]] bool mayBegin() const { return began_; }

   private:
    PluginCalls& calls_;
    bool began_ = false;
  };

 private:
  template <class Call, class ErrorOf>
  auto into(Call&& call, ErrorOf&& errorOf) -> decltype(guarded(std::forward<Call>(call), std::forward<ErrorOf>(errorOf))) {
    if (isWithdrawn()) return passOn(notRunning());
    return guarded(std::forward<Call>(call), std::forward<ErrorOf>(errorOf));
  }
  [[nodiscard]] Error notRunning() const;

  std::string plugin_;
  Tell tell_;
  std::set<PluginMoment> told_;
  bool made_ = false;
  std::vector<std::function<void()>> waiting_;
  std::vector<std::weak_ptr<sdk::Cases::Ticket>> tickets_;
  std::vector<std::shared_ptr<sdk::PanelDocument>> documents_;
  mutable std::mutex mutex_;  ///< of what follows
  std::condition_variable ended_;
  bool withdrawn_ = false;
  int working_ = 0;
};

}  // namespace ew::door
