#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/result.h"

namespace ew {

/// One OpenIGTLink message as it stood on the wire: the 58 bytes of its header, and its body taken apart.
/// Source: protocol versions 1 to 3, openigtlink.org, "Message header". Protocols 1 and 2 write header version 1, protocol 3 writes 2:
/// there the body is an extended header, the content and pairs of words, which a reader of version 1 takes for content.
struct IgtlMessage {
  int version = 1;         ///< of the header
  std::string type;        ///< "TRANSFORM", "IMAGE", "STT_TDATA", ... at most 12 bytes
  std::string device;      ///< at most 20 bytes; what is no letter, digit or sign of ASCII reads "?"
  double time_s = 0.0;     ///< since 1970 (UTC) where the sender's clock is set; not a number: it stamps nothing
  std::uint32_t id = 0;    ///< of the message; only in header version 2
  bool isSkipped = false;  ///< the body was passed over unread: a type that carries no pose, or one larger than such a type may be
  std::vector<std::uint8_t> content;
  std::vector<std::pair<std::string, std::string>> words;  ///< metadata: "TransformStatus", "OK"; only in header version 2
  bool operator==(const IgtlMessage&) const = default;
};

inline constexpr std::size_t kIgtlHeader_bytes = 58;
/// A body of a type that is read is at most that long; larger ones belong to types that are passed over.
inline constexpr std::size_t kIgtlLargestBody_bytes = std::size_t{64} << 10;

/// Takes the bytes of a connection in portions of any size and gives the messages in them. It frames the stream by itself, since the
/// library of many systems loses step for good at the first message of header version 2. Memory: never more than one body of a type that is
/// read.
class IgtlReader {
 public:
  /// @param checksSums a message whose sum (CRC64 of ECMA-182 over the body) is wrong is refused
  explicit IgtlReader(bool checksSums = true);

  /// @param message called with each whole message, in order; `content` is valid during the call
  /// @param refuse  called with the reason for each message that cannot be used while the stream goes on
  /// @error badHeader when the stream is out of step or no OpenIGTLink: the connection has to be closed, and reset() called for the next.
  ///        Nothing after it is read.
  [[nodiscard]] Result<void> read(std::span<const std::uint8_t> bytes, const std::function<void(const IgtlMessage&)>& message,
                                  const std::function<void(Message)>& refuse);
  /// For a new connection.
  void reset();
  /// Bytes of the message that is not complete yet: what the reader holds on to.
  [[nodiscard]] std::size_t held_bytes() const { return header_.size() + body_.size(); }

 private:
  [[nodiscard]] Result<void> takeHeader();
  void takeBody(const std::function<void(const IgtlMessage&)>& message, const std::function<void(Message)>& refuse);
  bool checksSums_;
  bool inBody_ = false;
  std::vector<std::uint8_t> header_;  ///< what came of it
  std::vector<std::uint8_t> body_;
  std::uint64_t body_bytes_ = 0, skipped_bytes_ = 0, sum_ = 0;
  IgtlMessage next_;
};

/// The bytes to send: header version 1 (no words) or 2, sum included.
/// @param message type of at most 12 and device of at most 20 bytes (longer ones are cut); version 1 or 2
[[nodiscard]] std::vector<std::uint8_t> igtlBytes(const IgtlMessage& message);

}  // namespace ew
