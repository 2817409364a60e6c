#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "ew/tracking/tracker_device.h"
#include "igtl_messages.h"

/// Partners for the tests of OpenIGTLink over real sockets of this computer.
namespace ew::test {

inline void sleep_s(double time_s) { std::this_thread::sleep_for(std::chrono::duration<double>(time_s)); }

/// Waits until something is so, and says how long that took; nothing when it was not so in a time that a very slow machine does not need.
inline std::optional<double> eventually(const std::function<bool()>& isSo, double most_s = 60.0) {
  const double begin_s = steadyNow_s();
  while (!isSo()) {
    if (steadyNow_s() - begin_s > most_s) return std::nullopt;
    sleep_s(0.002);
  }
  return steadyNow_s() - begin_s;
}

inline std::size_t threadsNow() {
  // The thread sanitizer has a thread of its own from the first one on that a program starts.
  [[maybe_unused]] static const bool hasStartedOne = (std::thread([] {}).join(), true);
  std::size_t count = 0;
  for ([[maybe_unused]] const auto& one : std::filesystem::directory_iterator("/proc/self/task")) ++count;
  return count;
}

/// Memory of this process that is in use.
inline double resident_mb() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / 1e6;
}

/// What memory may grow by where it is to stay flat, for caches and fragments; address sanitizers keep hundreds of megabytes of what was
/// freed.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double kFlat_mb = 500.0;
#else
constexpr double kFlat_mb = 20.0;
#endif

/// A server that does what the test says, good or bad, with the bytes the test says. One client at a time.
class Partner {
 public:
  explicit Partner(int port = 0, bool isIpv6 = false) {
    sockaddr_storage address{};
    socklen_t length = isIpv6 ? sizeof(sockaddr_in6) : sizeof(sockaddr_in);
    if (isIpv6) {
      auto* six = reinterpret_cast<sockaddr_in6*>(&address);
      six->sin6_family = AF_INET6;
      six->sin6_addr = in6addr_loopback;
      six->sin6_port = htons(static_cast<std::uint16_t>(port));
    } else {
      auto* four = reinterpret_cast<sockaddr_in*>(&address);
      four->sin_family = AF_INET;
      four->sin_addr.s_addr = htonl(INADDR_LOOPBACK);
      four->sin_port = htons(static_cast<std::uint16_t>(port));
    }
    listening_ = ::socket(address.ss_family, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const int yes = 1;
    ::setsockopt(listening_, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
    isListening_ = ::bind(listening_, reinterpret_cast<sockaddr*>(&address), length) == 0 && ::listen(listening_, 4) == 0;
    ::getsockname(listening_, reinterpret_cast<sockaddr*>(&address), &length);
    port_ = ntohs(isIpv6 ? reinterpret_cast<sockaddr_in6*>(&address)->sin6_port : reinterpret_cast<sockaddr_in*>(&address)->sin_port);
  }
  ~Partner() {
    hangUp();
    ::close(listening_);
  }
  Partner(const Partner&) = delete;
  Partner& operator=(const Partner&) = delete;

  [[nodiscard]] bool isListening() const { return isListening_; }
  [[nodiscard]] int port() const { return port_; }

  /// Waits for a client; an earlier one is hung up on.
  bool accept(double most_s = 60.0) {
    hangUp();
    pollfd asked{listening_, POLLIN, 0};
    if (::poll(&asked, 1, static_cast<int>(most_s * 1e3)) <= 0) return false;
    client_ = ::accept(listening_, nullptr, nullptr);
    const int yes = 1;
    ::setsockopt(client_, IPPROTO_TCP, TCP_NODELAY, &yes, sizeof yes);
    return client_ >= 0;
  }
  bool send(const Bytes& bytes) {
    for (std::size_t sent = 0; sent < bytes.size();) {
      const ssize_t count = ::send(client_, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL);
      if (count <= 0) return false;
      sent += static_cast<std::size_t>(count);
    }
    return true;
  }
  bool send(const IgtlMessage& message) { return send(igtlBytes(message)); }
  /// What the client says within a time, at least one message; empty: nothing.
  std::vector<IgtlMessage> hear(double most_s = 60.0) {
    std::vector<IgtlMessage> heard;
    IgtlReader reader;
    const double end_s = steadyNow_s() + most_s;
    while (heard.empty() && steadyNow_s() < end_s) {
      pollfd asked{client_, POLLIN, 0};
      if (::poll(&asked, 1, 50) <= 0) continue;
      Bytes bytes(4096);
      const ssize_t count = ::recv(client_, bytes.data(), bytes.size(), 0);
      if (count <= 0) break;
      bytes.resize(static_cast<std::size_t>(count));
      if (!reader.read(
              bytes, [&](const IgtlMessage& one) { heard.push_back(one); }, [](const Message&) {}))
        break;
    }
    return heard;
  }
  /// Whether the client ends the connection, whatever it says before.
  bool isLeft() {
    return eventually([this] {
             char byte = 0;
             return ::recv(client_, &byte, 1, MSG_DONTWAIT) == 0;
           })
        .has_value();
  }
  void hangUp() {
    if (client_ >= 0) ::close(std::exchange(client_, -1));
  }
  /// Ends the connection as a program that crashes: the client gets a reset.
  void crash() {
    const linger none{1, 0};
    ::setsockopt(client_, SOL_SOCKET, SO_LINGER, &none, sizeof none);
    hangUp();
  }
  /// Ends the connection as a cable that is pulled: the client gets nothing. False where this needs rights the test has not.
  bool vanish() {
    const int repair = 1;
    if (::setsockopt(client_, IPPROTO_TCP, TCP_REPAIR, &repair, sizeof repair) != 0) return false;
    hangUp();
    return true;
  }

 private:
  int listening_ = -1, client_ = -1, port_ = 0;
  bool isListening_ = false;
};

/// A client under test with what it gave so far.
struct Watched {
  explicit Watched(std::unique_ptr<TrackerDevice> made) : device(std::move(made)) {
    device->onNews([this] { ++news; });
    device->start();
  }
  const std::vector<ToolReading>& all() {
    for (ToolReading& one : device->take()) readings.push_back(std::move(one));
    return readings;
  }
  LinkState link() const { return device->status().link; }
  std::string sentence() const { return device->status().sentence.english(); }
  /// Waits for a pose of that number behind the one that was waited for last.
  bool getsPose(int n, const std::string& tool = "ProbeToTracker") {
    return eventually([&] {
             all();
             while (looked < readings.size()) {
               const ToolReading& one = readings[looked++];
               if (one.tool == tool && one.state == TrackingState::live && difference(one.toolToTracker.matrix, igtlPoseNumber(n)) < 1e-4)
                 return true;
             }
             return false;
           })
        .has_value();
  }

  std::unique_ptr<TrackerDevice> device;
  std::vector<ToolReading> readings;
  std::size_t looked = 0;
  std::atomic<int> news = 0;
};

}  // namespace ew::test
