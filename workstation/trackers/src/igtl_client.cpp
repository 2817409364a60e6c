#include "ew/trackers/igtl_client.h"

#include <poll.h>
#include <sys/socket.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "ew/core/contract.h"
#include "ew/core/guarded.h"
#include "ew/trackers/igtl_session.h"
#include "igtl_socket.h"

namespace ew {
namespace {

/// Why no connection came about, in words.
Message igtlReasonOf(int error, const std::string& address) {
  switch (error) {
    case ECONNREFUSED:
      return say<"No server listens at %1; start it there, or check the address and the port. It is tried again by itself.">(address);
    case ETIMEDOUT:
    case EHOSTUNREACH:
    case ENETUNREACH:
      return say<"The computer of %1 does not answer; check its address, the network and its firewall. It is tried again by itself.">(
          address);
    default:
      return say<"%1 cannot be reached (%2). It is tried again by itself.">(address, verbatim(std::strerror(error)));
  }
}

class IgtlClient final : public TrackerDevice {
 public:
  IgtlClient(IgtlSettings settings, IgtlTiming timing) : settings_(std::move(settings)), timing_(timing) {}
  ~IgtlClient() override { IgtlClient::stop(); }

  void start() override {
    const std::scoped_lock lock(startOrStop_);
    if (thread_.joinable()) return;
    queue_.begin();
    stopping_ = false;
    wake_.answer();
    thread_ = std::thread([this] { runGuarded(); });
  }
  void stop() override {
    const std::scoped_lock lock(startOrStop_);
    if (!thread_.joinable()) return;
    stopping_ = true;
    wake_.call();
    thread_.join();
    queue_.setLink(LinkState::off, {});
  }
  std::vector<ToolReading> take() override { return queue_.take(); }
  DeviceStatus status() const override { return queue_.status(steadyNow_s(), timing_.silentAfter_s); }
  void onNews(std::function<void()> callback) override { queue_.onNews(std::move(callback)); }

 private:
  void runGuarded();
  void run();
  std::optional<Descriptor> connected(IgtlSession& session);
  void talk(const Descriptor& socket, IgtlSession& session);
  bool receive(const Descriptor& socket, IgtlSession& session);
  void send(const Descriptor& socket, IgtlSession& session);
  void waitUntil(double time_s);

  const IgtlSettings settings_;
  const IgtlTiming timing_;
  ReadingQueue queue_;
  Wake wake_;
  std::mutex startOrStop_;
  std::thread thread_;
  std::atomic<bool> stopping_ = false;
  std::optional<Lookup> lookup_;  ///< kept while it lasts, so that a name server that does not answer costs one thread
  std::vector<std::uint8_t> unsent_;
};

void IgtlClient::runGuarded() {
  while (!stopping_) {
    try {
      run();
    } catch (...) {
      const Thrown thrown = thrownNow();
      queue_.setLink(LinkState::connecting, say<"The connection with the tracker ended (%1); it is opened anew.">(thrown.reason));
      waitUntil(steadyNow_s() + timing_.longestPause_s);
    }
  }
}

void IgtlClient::run() {
  IgtlSession session(settings_, timing_, queue_);
  queue_.setLink(LinkState::connecting, say<"Connecting with %1.">(session.address()));
  while (!stopping_) {
    if (const auto socket = connected(session)) {
      session.opened(steadyNow_s());
      talk(*socket, session);
    }
    waitUntil(session.attempt_s());
  }
}

/// Nothing: stopped, or it failed and the session was told.
std::optional<Descriptor> IgtlClient::connected(IgtlSession& session) {
  if (!lookup_) lookup_.emplace(settings_.host, settings_.port);
  while (!stopping_ && !lookup_->isDone()) waitUntil(steadyNow_s() + 0.02);
  if (stopping_) return std::nullopt;
  const std::vector<SocketAddress> addresses = lookup_->addresses();
  lookup_.reset();  // the next attempt asks again: names move to other addresses
  if (addresses.empty()) {
    session.closed(steadyNow_s(), say<"The name of %1 is not known in this network; check how it is written. It is tried again by itself.">(
                                      session.address()));
    return std::nullopt;
  }
  int error = ECONNREFUSED;
  for (const SocketAddress& address : addresses) {
    auto [socket, problem] = connectingSocket(address);
    error = problem;
    if (!socket) continue;
    const double last_s = steadyNow_s() + timing_.gaveUpConnect_s;
    int events = 0;
    while (!stopping_ && events == 0 && steadyNow_s() < last_s) events = waitFor(socket.number(), POLLOUT, wake_, last_s - steadyNow_s());
    if (stopping_) return std::nullopt;
    error = events == 0 ? ETIMEDOUT : connectionError(socket);
    if (error == 0) return std::move(socket);
  }
  session.closed(steadyNow_s(), igtlReasonOf(error, session.address()));
  return std::nullopt;
}

/// Until the connection ends or the client is stopped.
void IgtlClient::talk(const Descriptor& socket, IgtlSession& session) {
  unsent_.clear();
  while (!stopping_) {
    if (!session.tick(steadyNow_s())) return;
    send(socket, session);
    const auto events = static_cast<short>(unsent_.empty() ? POLLIN : POLLIN | POLLOUT);
    if (waitFor(socket.number(), events, wake_, session.tick_s() - steadyNow_s()) != 0 && !receive(socket, session)) return;
  }
}

bool IgtlClient::receive(const Descriptor& socket, IgtlSession& session) {
  std::array<std::uint8_t, 32768> bytes;
  constexpr int kMostPortions = 32;  // then it is looked whether somebody wants to stop
  for (int portion = 0; portion < kMostPortions; ++portion) {
    const ssize_t count = ::recv(socket.number(), bytes.data(), bytes.size(), 0);
    if (count > 0) {
      if (!session.received(std::span(bytes).first(static_cast<std::size_t>(count)), steadyNow_s())) return false;
      continue;
    }
    if (count < 0 && (errno == EAGAIN || errno == EINTR)) return true;
    session.closed(
        steadyNow_s(),
        count == 0 || errno == ECONNRESET
            ? say<"The server at %1 closed the connection; it is opened anew as soon as the server listens again.">(session.address())
            : say<"The connection with %1 broke (%2); it is opened anew.">(session.address(), verbatim(std::strerror(errno))));
    return false;
  }
  return true;
}

/// What the session wants to say, which is little. An error shows when receiving.
void IgtlClient::send(const Descriptor& socket, IgtlSession& session) {
  const std::vector<std::uint8_t> more = session.takeToSend();
  constexpr std::size_t kMostUnsent_bytes = 4096;  // the other end takes nothing: questions repeated in vain are dropped
  if (unsent_.size() + more.size() <= kMostUnsent_bytes) unsent_.insert(unsent_.end(), more.begin(), more.end());
  if (unsent_.empty()) return;
  const ssize_t count = ::send(socket.number(), unsent_.data(), unsent_.size(), MSG_NOSIGNAL);
  if (count > 0) unsent_.erase(unsent_.begin(), unsent_.begin() + count);
}

void IgtlClient::waitUntil(double time_s) {
  for (double now_s = steadyNow_s(); !stopping_ && now_s < time_s; now_s = steadyNow_s()) waitFor(-1, 0, wake_, time_s - now_s);
}

}  // namespace

std::unique_ptr<TrackerDevice> makeIgtlClient(const IgtlSettings& settings, const IgtlTiming& timing) {
  EW_EXPECTS(settings.port > 0 && settings.port <= 65535);
  return std::make_unique<IgtlClient>(settings, timing);
}

}  // namespace ew
