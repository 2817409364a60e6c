#include "igtl_server_client.h"

#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace ew {
namespace {

constexpr std::ptrdiff_t kIgtlMostImages = 2;  // the one under way and the newest
constexpr std::size_t kIgtlMostPackets = 256;

}  // namespace

IgtlServerClient::IgtlServerClient(Descriptor socket) : socket_(std::move(socket)) {
  constexpr double kPatience_s =
      300.0;  // a viewer that is held in a debugger or loads a large file takes nothing for a while and is no fault
  prepareSocket(socket_.number(), kPatience_s);
  // What the system queues behind ours makes images late; it holds one image of common size.
  const int size = 512 * 1024;
  ::setsockopt(socket_.number(), SOL_SOCKET, SO_SNDBUF, &size, sizeof size);
}

IgtlServerClient::Dropped IgtlServerClient::add(IgtlPacket packet) {
  Dropped dropped;
  waiting_.push_back(std::move(packet));
  const auto dropFirst = [this](bool isImage) {
    const auto first = std::find_if(waiting_.begin() + (begun_bytes_ > 0 ? 1 : 0), waiting_.end() - 1,
                                    [isImage](const IgtlPacket& one) { return one.isImage == isImage; });
    const bool found = first != waiting_.end() - 1;
    if (found) waiting_.erase(first);
    return found;
  };
  while (std::count_if(waiting_.begin(), waiting_.end(), [](const IgtlPacket& one) { return one.isImage; }) > kIgtlMostImages &&
         dropFirst(true))
    ++dropped.images;
  while (waiting_.size() > kIgtlMostPackets && dropFirst(false)) ++dropped.poses;
  return dropped;
}

bool IgtlServerClient::send(std::uint64_t& sent) {
  while (!waiting_.empty()) {
    const std::vector<std::uint8_t>& bytes = *waiting_.front().bytes;
    const ssize_t count = ::send(socket_.number(), bytes.data() + begun_bytes_, bytes.size() - begun_bytes_, MSG_NOSIGNAL);
    if (count < 0) return errno == EAGAIN || errno == EINTR;
    begun_bytes_ += static_cast<std::size_t>(count);
    if (begun_bytes_ < bytes.size()) return true;
    begun_bytes_ = 0;
    waiting_.pop_front();
    ++sent;
  }
  return true;
}

bool IgtlServerClient::receive(const std::function<void(const IgtlMessage&)>& question) {
  std::array<std::uint8_t, 4096> bytes;
  const ssize_t count = ::recv(socket_.number(), bytes.data(), bytes.size(), 0);
  if (count < 0) return errno == EAGAIN || errno == EINTR;
  if (count == 0) return false;
  const auto take = [&](const IgtlMessage& message) {
    if (message.version >= 2) version_ = 2;
    question(message);
  };
  return reader_.read(std::span(bytes).first(static_cast<std::size_t>(count)), take, [](const Message&) {}).has_value();
}

std::size_t IgtlServerClient::waiting_bytes() const {
  std::size_t bytes = 0;
  for (const IgtlPacket& one : waiting_) bytes += one.bytes->size();
  return bytes - begun_bytes_;
}

}  // namespace ew
