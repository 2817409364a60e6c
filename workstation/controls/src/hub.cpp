#include "ew/controls/hub.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

#include "ew/controls/hid_parser.h"
#include "ew/controls/midi_parser.h"

namespace ew::controls {

Connection::~Connection() = default;
Backend::~Backend() = default;
bool Backend::hasNumberedReports(const Device&) const { return false; }

namespace {

constexpr auto kLookAgain = std::chrono::seconds(2);
constexpr std::size_t kMostWaiting = 4096;  ///< events nobody took: a window that is busy gets the first of them

using Parse = std::function<void(std::span<const std::uint8_t>, std::vector<ControlEvent>&)>;

Parse parserOf(const Device& device, const Backend& backend) {
  if (device.bus == Device::Bus::midi)
    return [parser = MidiParser(device.name)](std::span<const std::uint8_t> bytes, std::vector<ControlEvent>& events) mutable {
      parser.take(bytes, events);
    };
  return [parser = HidParser(device.name, device.vendor, backend.hasNumberedReports(device))](
             std::span<const std::uint8_t> bytes, std::vector<ControlEvent>& events) mutable { parser.take(bytes, events); };
}

}  // namespace

struct Hub::Parts {
  std::vector<std::unique_ptr<Backend>> backends;
  std::function<void()> told;

  mutable std::mutex mutex;  ///< of all below but `open`, which is the looking thread's own
  std::condition_variable changed;
  std::set<std::string> wanted;
  bool all = false;
  bool ends = false;
  std::uint64_t asked = 0, looked = 0;
  std::vector<ControlEvent> events;
  State state;
  std::map<std::pair<std::size_t, std::string>, std::unique_ptr<Connection>> open;  ///< by backend and path
  std::thread looking;

  [[nodiscard]] bool wantsNothing() const { return wanted.empty() && !all; }

  void take(const std::vector<ControlEvent>& more) {
    if (more.empty()) return;
    bool isFirst = false;
    {
      const std::lock_guard lock(mutex);
      isFirst = events.empty();
      const std::size_t room = kMostWaiting - std::min(kMostWaiting, events.size());
      events.insert(events.end(), more.begin(), more.begin() + static_cast<std::ptrdiff_t>(std::min(room, more.size())));
    }
    if (isFirst) told();
  }

  Result<std::unique_ptr<Connection>> connect(Backend& backend, const Device& device) {
    return backend.open(device, [this, parse = parserOf(device, backend)](std::span<const std::uint8_t> bytes) mutable {
      std::vector<ControlEvent> more;
      parse(bytes, more);
      take(more);
    });
  }

  /// Opens what is wanted and there, lets go of the rest.
  void look(const std::set<std::string>& names, bool every, bool nothing) {
    State found;
    std::set<std::pair<std::size_t, std::string>> kept;
    for (std::size_t n = 0; n < backends.size() && !nothing; ++n) {
      const auto devices = backends[n]->devices();
      if (!devices) {
        found.problems.push_back(devices.error());
        continue;
      }
      for (const Device& device : *devices) {
        found.devices.push_back(device);
        if (!every && !names.contains(device.name)) continue;
        const std::pair<std::size_t, std::string> key(n, device.path);
        const auto present = open.find(key);
        if (present != open.end() && present->second->isLost()) open.erase(present);
        if (!open.contains(key)) {
          auto connection = connect(*backends[n], device);
          if (connection)
            open.emplace(key, std::move(*connection));
          else
            found.problems.push_back(connection.error());
        }
        kept.insert(key);
      }
    }
    std::erase_if(open, [&](const auto& each) { return !kept.contains(each.first); });
    bool isNews = false;
    {
      const std::lock_guard lock(mutex);
      isNews = !(state == found);
      state = std::move(found);
    }
    if (isNews) told();
  }

  void run() {
    std::unique_lock lock(mutex);
    while (!ends) {
      const std::uint64_t serving = asked;
      const std::set<std::string> names = wanted;
      const bool every = all, nothing = wantsNothing();
      lock.unlock();
      look(names, every, nothing);
      lock.lock();
      looked = std::max(looked, serving);
      changed.notify_all();
      const auto isAsked = [this] { return ends || asked > looked; };
      if (wantsNothing())
        changed.wait(lock, isAsked);
      else
        changed.wait_for(lock, kLookAgain, isAsked);
    }
  }
};

Hub::Hub(std::vector<std::unique_ptr<Backend>> backends, std::function<void()> told) : parts_(std::make_unique<Parts>()) {
  parts_->backends = std::move(backends);
  parts_->told = std::move(told);
}

Hub::~Hub() {
  {
    const std::lock_guard lock(parts_->mutex);
    parts_->ends = true;
  }
  parts_->changed.notify_all();
  if (parts_->looking.joinable()) parts_->looking.join();
  parts_->open.clear();
}

void Hub::want(std::set<std::string> names, bool all) {
  const std::lock_guard lock(parts_->mutex);
  if (names == parts_->wanted && all == parts_->all) return;
  parts_->wanted = std::move(names);
  parts_->all = all;
  ++parts_->asked;
  if (!parts_->looking.joinable()) parts_->looking = std::thread([parts = parts_.get()] { parts->run(); });
  parts_->changed.notify_all();
}

std::vector<ControlEvent> Hub::takeEvents() {
  const std::lock_guard lock(parts_->mutex);
  return std::exchange(parts_->events, {});
}

Hub::State Hub::state() const {
  const std::lock_guard lock(parts_->mutex);
  return parts_->state;
}

void Hub::lookNow() {
  std::unique_lock lock(parts_->mutex);
  if (!parts_->looking.joinable()) return;
  const std::uint64_t mine = ++parts_->asked;
  parts_->changed.notify_all();
  parts_->changed.wait(lock, [&] { return parts_->looked >= mine; });
}

}  // namespace ew::controls
