#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "ew/trackers/igtl_wire.h"
#include "igtl_socket.h"

namespace ew {

/// Bytes that several clients are sent; one copy for all of them.
struct IgtlPacket {
  std::shared_ptr<const std::vector<std::uint8_t>> bytes;
  bool isImage = false;
};

/// What a server keeps for one client: a bounded queue, and the version the client speaks.
class IgtlServerClient {
 public:
  explicit IgtlServerClient(Descriptor socket);

  /// Hands over; drops old images first, then old poses, when the client does not keep up. Returns what was dropped.
  struct Dropped {
    int images = 0, poses = 0;
  };
  Dropped add(IgtlPacket packet);
  /// As much as the socket takes. False when the connection ended.
  [[nodiscard]] bool send(std::uint64_t& sent);
  /// Reads what the client says. False when the connection ended or it talks no OpenIGTLink.
  [[nodiscard]] bool receive(const std::function<void(const IgtlMessage&)>& question);

  [[nodiscard]] int number() const { return socket_.number(); }
  [[nodiscard]] int version() const { return version_; }
  [[nodiscard]] bool hasMore() const { return !waiting_.empty(); }
  [[nodiscard]] std::size_t waiting_bytes() const;

 private:
  Descriptor socket_;
  IgtlReader reader_{false};
  std::deque<IgtlPacket> waiting_;
  std::size_t begun_bytes_ = 0;  ///< of the first packet that are sent: from then on it has to be sent to its end
  int version_ = 1;
};

}  // namespace ew
