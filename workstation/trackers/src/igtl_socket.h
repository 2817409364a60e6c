#pragma once

#include <netinet/in.h>
#include <sys/socket.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/result.h"

namespace ew {

/// A file descriptor that is closed with its owner.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor();
  [[nodiscard]] int number() const { return number_; }
  [[nodiscard]] explicit operator bool() const { return number_ >= 0; }

 private:
  int number_ = -1;
};

/// Wakes a thread that waits in poll().
class Wake {
 public:
  Wake();
  void call();
  void answer();  ///< until the next call
  [[nodiscard]] int number() const { return event_.number(); }

 private:
  Descriptor event_;
};

struct SocketAddress {
  sockaddr_storage bytes{};
  socklen_t length = 0;
};

/// Finds the addresses of a name without holding up its caller: a name server that does not answer keeps a thread of its own waiting, which
/// ends by itself when the system gives up, whether anybody still asks or not. Numbers and "localhost" need no thread.
class Lookup {
 public:
  Lookup(const std::string& host, int port);
  [[nodiscard]] bool isDone() const;
  /// Empty: the name is not known. Only when done.
  [[nodiscard]] std::vector<SocketAddress> addresses() const;

 private:
  struct State;
  std::shared_ptr<State> state_;
};

/// A TCP socket that connects: not blocking, small portions sent at once, and the other end asked for a sign of life every few seconds.
/// @return an error number of the system, or a socket that is connected or becomes writable when it is
[[nodiscard]] std::pair<Descriptor, int> connectingSocket(const SocketAddress& address);
/// How an attempt to connect ended: 0 or an error number of the system.
[[nodiscard]] int connectionError(const Descriptor& socket);
/// @param number a socket, as socket() or accept() gives it
/// @param patience_s how long the other end may leave unacknowledged, or untaken, what was sent before the connection counts as broken
void prepareSocket(int number, double patience_s);

struct Listening {
  Descriptor socket;
  int port = 0;
};
/// @param port 0: any that is free
/// @param everyone on all networks, IPv6 and IPv4; otherwise this computer alone (127.0.0.1)
/// @error notWritable with what to do
[[nodiscard]] Result<Listening> listenOn(int port, bool everyone);

/// Waits for a socket and a wake-up. @return poll()'s events of the socket, 0 when only time went by or somebody called
int waitFor(int socket, short events, const Wake& wake, double most_s);

}  // namespace ew
