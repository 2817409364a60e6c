#include "cancellable_layer.h"

#include <fcntl.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <memory>

namespace ew::exporting {
namespace {

constexpr int kPiece_ms = 50;  // of a wait, after which it is asked whether to go on
constexpr const char* kStopped = "stopped as asked";

enum class Waited { ready, timeout, cancelled, failed };

/// @param events as poll() takes them
Waited waitFor(int socket, short events, double timeout_s, const Progress& progress) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeout_s);
  for (;;) {
    if (progress.cancelRequested()) return Waited::cancelled;
    pollfd asked{socket, events, 0};
    const int ready = ::poll(&asked, 1, kPiece_ms);
    if (ready > 0) return Waited::ready;
    if (ready < 0 && errno != EINTR) return Waited::failed;
    if (std::chrono::steady_clock::now() >= end) return Waited::timeout;
  }
}

class CancellableConnection final : public DcmTCPConnection {
 public:
  CancellableConnection(DcmNativeSocketType openSocket, const Progress& progress, double timeout_s)
      : DcmTCPConnection(openSocket), progress_(progress), timeout_s_(timeout_s) {}

  OFBool networkDataAvailable(int timeout_s) override {
    return waitFor(getSocket(), POLLIN, timeout_s, progress_) == Waited::ready ? OFTrue : OFFalse;
  }
  ssize_t read(void* bytes, size_t count) override { return may(POLLIN) ? ::recv(getSocket(), bytes, count, 0) : -1; }
  ssize_t write(void* bytes, size_t count) override {
    return may(POLLOUT) ? ::send(getSocket(), bytes, count, MSG_DONTWAIT | MSG_NOSIGNAL) : -1;
  }

 private:
  bool may(short events) {
    const Waited waited = waitFor(getSocket(), events, timeout_s_, progress_);
    if (waited == Waited::timeout) errno = ETIMEDOUT;
    if (waited == Waited::cancelled) errno = ECANCELED;
    return waited == Waited::ready;
  }

  const Progress& progress_;
  double timeout_s_;
};

struct CloseSocket {
  int socket;
  ~CloseSocket() { ::close(socket); }
};

std::string connectTo(const addrinfo& address, double timeout_s, const Progress& progress) {
  const int socket = ::socket(address.ai_family, address.ai_socktype | SOCK_NONBLOCK | SOCK_CLOEXEC, address.ai_protocol);
  if (socket < 0) return std::strerror(errno);
  const CloseSocket closed{socket};
  if (::connect(socket, address.ai_addr, address.ai_addrlen) == 0) return {};
  if (errno != EINPROGRESS) return std::strerror(errno);
  switch (waitFor(socket, POLLOUT, timeout_s, progress)) {
    case Waited::cancelled:
      return kStopped;
    case Waited::timeout:
      return std::strerror(ETIMEDOUT);
    case Waited::failed:
      return std::strerror(errno);
    case Waited::ready:
      break;
  }
  int error = 0;
  socklen_t size = sizeof error;
  if (::getsockopt(socket, SOL_SOCKET, SO_ERROR, &error, &size) != 0) error = errno;
  return error == 0 ? std::string() : std::strerror(error);
}

}  // namespace

DcmTransportConnection* CancellableLayer::createConnection(DcmNativeSocketType openSocket, OFBool) {
  return new CancellableConnection(openSocket, progress_, timeout_s_);  // DCMTK's from here on
}

std::string whyNotReached(const std::string& host, int port, double timeout_s, const Progress& progress) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (const int error = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found); error != 0) return ::gai_strerror(error);
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> addresses(found, &::freeaddrinfo);
  std::string why = "no address";
  for (const addrinfo* each = found; each != nullptr; each = each->ai_next) {
    if (progress.cancelRequested()) return kStopped;
    why = connectTo(*each, timeout_s, progress);
    if (why.empty()) return why;
  }
  return why;
}

}  // namespace ew::exporting
