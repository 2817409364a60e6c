#include "igtl_socket.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netdb.h>
#include <netinet/tcp.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <system_error>
#include <thread>

namespace ew {
namespace {

void setSocketOption(int number, int level, int name, int value) { ::setsockopt(number, level, name, &value, sizeof value); }

/// At once, without a name server; all addresses that fit otherwise.
std::vector<SocketAddress> socketAddressesOf(const std::string& host, int port, int flags) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  hints.ai_flags = flags | AI_NUMERICSERV;
  addrinfo* found = nullptr;
  std::vector<SocketAddress> addresses;
  if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) return addresses;
  for (const addrinfo* one = found; one != nullptr; one = one->ai_next) {
    if (one->ai_addrlen > sizeof(sockaddr_storage)) continue;
    SocketAddress address;
    std::memcpy(&address.bytes, one->ai_addr, one->ai_addrlen);
    address.length = one->ai_addrlen;
    addresses.push_back(address);
  }
  ::freeaddrinfo(found);
  return addresses;
}

}  // namespace

Descriptor::~Descriptor() {
  if (number_ >= 0) ::close(number_);
}

Wake::Wake() : event_(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)) {}

void Wake::call() {
  const std::uint64_t one = 1;
  [[maybe_unused]] const auto written = ::write(event_.number(), &one, sizeof one);  // full: it is called already
}

void Wake::answer() {
  std::uint64_t calls = 0;
  [[maybe_unused]] const auto read = ::read(event_.number(), &calls, sizeof calls);
}

struct Lookup::State {
  std::vector<SocketAddress> found;
  std::atomic<bool> isDone = false;
};

Lookup::Lookup(const std::string& host, int port) : state_(std::make_shared<State>()) {
  // "localhost" is this computer by definition (RFC 6761); servers of OpenIGTLink mostly listen on IPv4.
  for (const char* number : {"127.0.0.1", "::1"})
    if (host == "localhost") std::ranges::copy(socketAddressesOf(number, port, AI_NUMERICHOST), std::back_inserter(state_->found));
  if (state_->found.empty()) state_->found = socketAddressesOf(host, port, AI_NUMERICHOST);
  state_->isDone = !state_->found.empty();
  if (state_->isDone) return;
  try {
    std::thread([state = state_, host, port] {
      state->found = socketAddressesOf(host, port, AI_ADDRCONFIG);
      state->isDone = true;
    }).detach();
  } catch (const std::system_error&) {
    state_->isDone = true;  // no thread to be had: as a name that is not known, tried again later
  }
}

bool Lookup::isDone() const { return state_->isDone; }
std::vector<SocketAddress> Lookup::addresses() const { return state_->found; }

void prepareSocket(int number, double patience_s) {
  setSocketOption(number, IPPROTO_TCP, TCP_NODELAY, 1);
  // A peer that vanished without a word is found out after five seconds: two of silence, then a question each second.
  setSocketOption(number, SOL_SOCKET, SO_KEEPALIVE, 1);
  setSocketOption(number, IPPROTO_TCP, TCP_KEEPIDLE, 2);
  setSocketOption(number, IPPROTO_TCP, TCP_KEEPINTVL, 1);
  setSocketOption(number, IPPROTO_TCP, TCP_KEEPCNT, 3);
  setSocketOption(number, IPPROTO_TCP, TCP_USER_TIMEOUT, static_cast<int>(patience_s * 1e3));
}

std::pair<Descriptor, int> connectingSocket(const SocketAddress& address) {
  Descriptor socket(::socket(address.bytes.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
  if (!socket) return {Descriptor(), errno};
  constexpr double kPatience_s = 5.0;
  prepareSocket(socket.number(), kPatience_s);
  // The interface of the operating system wants this cast.
  if (::connect(socket.number(), reinterpret_cast<const sockaddr*>(&address.bytes), address.length) != 0 && errno != EINPROGRESS)
    return {Descriptor(), errno};
  return {std::move(socket), 0};
}

int connectionError(const Descriptor& socket) {
  int error = 0;
  socklen_t length = sizeof error;
  if (::getsockopt(socket.number(), SOL_SOCKET, SO_ERROR, &error, &length) != 0) return errno;
  if (error != 0) return error;
  // Who knocks at a port of his own computer where nobody listens may be given that very port to knock from, and TCP connects him with
  // himself.
  sockaddr_storage own{}, other{};
  socklen_t ownLength = sizeof own, otherLength = sizeof other;
  if (::getsockname(socket.number(), reinterpret_cast<sockaddr*>(&own), &ownLength) != 0 ||
      ::getpeername(socket.number(), reinterpret_cast<sockaddr*>(&other), &otherLength) != 0)
    return errno;
  return ownLength == otherLength && std::memcmp(&own, &other, ownLength) == 0 ? ECONNREFUSED : 0;
}

Result<Listening> listenOn(int port, bool everyone) {
  const auto refused = [port](int error) {
    if (error == EADDRINUSE)
      return failure(ErrorCode::notWritable,
                     say<"Another program already listens on port %1; choose another port or end that program.">(port));
    return failure(ErrorCode::notWritable, say<"No connection can be offered on port %1 (%2).">(port, verbatim(std::strerror(error))));
  };
  const auto bound = [port](const char* host) -> std::pair<Descriptor, int> {
    const std::vector<SocketAddress> addresses = socketAddressesOf(host, port, AI_NUMERICHOST);
    if (addresses.empty()) return {Descriptor(), EAFNOSUPPORT};
    const SocketAddress& address = addresses.front();
    Descriptor socket(::socket(address.bytes.ss_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket) return {Descriptor(), errno};
    setSocketOption(socket.number(), SOL_SOCKET, SO_REUSEADDR, 1);
    if (address.bytes.ss_family == AF_INET6) setSocketOption(socket.number(), IPPROTO_IPV6, IPV6_V6ONLY, 0);
    if (::bind(socket.number(), reinterpret_cast<const sockaddr*>(&address.bytes), address.length) != 0 ||
        ::listen(socket.number(), 8) != 0)
      return {Descriptor(), errno};
    return {std::move(socket), 0};
  };
  auto [socket, error] = bound(everyone ? "::" : "127.0.0.1");
  if (everyone && error != 0 && error != EADDRINUSE) std::tie(socket, error) = bound("0.0.0.0");  // a computer without IPv6
  if (error != 0) return refused(error);

  Listening listening;
  sockaddr_storage own{};
  socklen_t length = sizeof own;
  if (::getsockname(socket.number(), reinterpret_cast<sockaddr*>(&own), &length) != 0) return refused(errno);
  listening.port = ntohs(own.ss_family == AF_INET6 ? reinterpret_cast<const sockaddr_in6*>(&own)->sin6_port
                                                   : reinterpret_cast<const sockaddr_in*>(&own)->sin_port);
  listening.socket = std::move(socket);
  return listening;
}

int waitFor(int socket, short events, const Wake& wake, double most_s) {
  pollfd asked[2] = {{wake.number(), POLLIN, 0}, {socket, events, 0}};
  const auto most_ms = static_cast<int>(std::clamp(std::ceil(most_s * 1e3), 0.0, 1e6));
  if (::poll(asked, socket >= 0 ? 2 : 1, most_ms) <= 0) return 0;
  return socket >= 0 ? asked[1].revents : 0;
}

}  // namespace ew
