#include "ew/trackers/igtl_wire.h"

#include <igtl_util.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "ew/core/contract.h"
#include "igtl_numbers.h"

namespace ew {
namespace {

constexpr std::size_t kIgtlType_bytes = 12, kIgtlDevice_bytes = 20, kIgtlExtended_bytes = 12;
/// Larger bodies are no message but a stream out of step: a volume of 65,535 voxels along each axis is sent by nobody.
constexpr std::uint64_t kIgtlImpossibleBody_bytes = std::uint64_t{4} << 30u;

/// Types whose body is read. All others are passed over, whatever their size.
constexpr std::array<std::string_view, 13> kIgtlReadTypes = {"TRANSFORM",   "TDATA",      "QTDATA",    "POSITION",  "STATUS",
                                                             "QTRANS",      "RTS_TDATA",  "STT_TDATA", "GET_TRANS", "GET_STATUS",
                                                             "GET_CAPABIL", "RTS_QTDATA", "RTS_TRANS"};

bool isReadIgtlType(std::string_view type) { return std::find(kIgtlReadTypes.begin(), kIgtlReadTypes.end(), type) != kIgtlReadTypes.end(); }

/// A type is a word of ASCII, padded with zeros: anything else is no header.
bool isIgtlType(std::span<const std::uint8_t> name) {
  const auto isLetter = [](std::uint8_t c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  const auto end = std::find_if_not(name.begin(), name.end(), isLetter);
  return end != name.begin() && std::all_of(end, name.end(), [](std::uint8_t c) { return c == 0 || c == ' '; });
}

std::uint64_t igtlSumOf(std::span<const std::uint8_t> body) {
  // The library takes bytes it might write to and only reads them.
  return body.empty() ? 0 : crc64(const_cast<unsigned char*>(body.data()), body.size(), 0);
}

/// Takes the body of header version 2 apart. False when its lengths do not fit together.
/// Source: the structures that OpenIGTLink 3 sends; the text of the protocol still names an earlier layout of the extended header.
bool takeIgtlBodyApart(std::span<const std::uint8_t> body, IgtlMessage& message) {
  if (body.size() < kIgtlExtended_bytes) return false;
  const std::size_t extended = igtlUnsignedAt<std::uint16_t>(body, 0);
  const std::size_t index = igtlUnsignedAt<std::uint16_t>(body, 2);
  const std::size_t words = igtlUnsignedAt<std::uint32_t>(body, 4);
  message.id = igtlUnsignedAt<std::uint32_t>(body, 8);
  if (extended < kIgtlExtended_bytes || extended + index + words > body.size()) return false;
  const std::size_t content = body.size() - extended - index - words;
  const auto first = body.begin() + static_cast<std::ptrdiff_t>(extended);
  message.content.assign(first, first + static_cast<std::ptrdiff_t>(content));
  if (index < 2) return index == 0 && words == 0;

  const std::span<const std::uint8_t> sizes = body.subspan(extended + content, index), letters = body.last(words);
  const std::size_t count = igtlUnsignedAt<std::uint16_t>(sizes, 0);
  if (2 + 8 * count > index) return false;
  std::size_t at = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t key = igtlUnsignedAt<std::uint16_t>(sizes, 2 + 8 * n), value = igtlUnsignedAt<std::uint32_t>(sizes, 6 + 8 * n);
    if (key > words - at || value > words - at - key) return false;
    message.words.emplace_back(igtlNameAt(letters, at, key), igtlNameAt(letters, at + key, value));
    at += key + value;
  }
  return true;
}

}  // namespace

IgtlReader::IgtlReader(bool checksSums) : checksSums_(checksSums) { header_.reserve(kIgtlHeader_bytes); }

void IgtlReader::reset() {
  inBody_ = false;
  header_.clear();
  body_.clear();
}

Result<void> IgtlReader::read(std::span<const std::uint8_t> bytes, const std::function<void(const IgtlMessage&)>& message,
                              const std::function<void(Message)>& refuse) {
  const auto take = [&bytes](std::vector<std::uint8_t>& into, std::uint64_t most) {
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(most, bytes.size()));
    into.insert(into.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(count));
    bytes = bytes.subspan(count);
  };
  while (!bytes.empty()) {
    if (!inBody_) {
      take(header_, kIgtlHeader_bytes - header_.size());
      if (header_.size() < kIgtlHeader_bytes) break;
      if (auto taken = takeHeader(); !taken) return taken;
      inBody_ = true;
    }
    if (next_.isSkipped) {
      const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(body_bytes_ - skipped_bytes_, bytes.size()));
      bytes = bytes.subspan(count);
      skipped_bytes_ += count;
    } else {
      take(body_, body_bytes_ - body_.size());
    }
    if (skipped_bytes_ + body_.size() < body_bytes_) break;
    takeBody(message, refuse);
  }
  return {};
}

Result<void> IgtlReader::takeHeader() {
  next_ = {};
  next_.version = igtlUnsignedAt<std::uint16_t>(header_, 0);
  body_bytes_ = igtlUnsignedAt<std::uint64_t>(header_, 42);
  sum_ = igtlUnsignedAt<std::uint64_t>(header_, 50);
  skipped_bytes_ = 0;
  if (!isIgtlType(std::span(header_).subspan(2, kIgtlType_bytes)) || next_.version < 1 || next_.version > 3)
    return failure(
        ErrorCode::badHeader,
        say<"What came is no OpenIGTLink, or its beginning was lost; the connection is opened anew. If this repeats, check that the "
            "port belongs to an OpenIGTLink server.">());
  next_.type = igtlNameAt(header_, 2, kIgtlType_bytes);
  while (next_.type.back() == ' ') next_.type.pop_back();
  next_.device = igtlNameAt(header_, 2 + kIgtlType_bytes, kIgtlDevice_bytes);
  next_.time_s = igtlSecondsOf(igtlUnsignedAt<std::uint64_t>(header_, 34));
  next_.isSkipped = !isReadIgtlType(next_.type);
  if (body_bytes_ > (next_.isSkipped ? kIgtlImpossibleBody_bytes : std::uint64_t{kIgtlLargestBody_bytes}))
    return failure(ErrorCode::badHeader,
                   say<"A message of the type %1 claims to be %2 bytes long, which it cannot be; the connection is opened anew.">(
                       next_.type, body_bytes_),
                   {{"device", next_.device}});
  return {};
}

void IgtlReader::takeBody(const std::function<void(const IgtlMessage&)>& message, const std::function<void(Message)>& refuse) {
  inBody_ = false;
  header_.clear();
  if (next_.isSkipped) {
    message(next_);
    return;
  }
  if (checksSums_ && igtlSumOf(body_) != sum_) {
    refuse(say<"A message of the type %1 arrived damaged: its check sum is wrong. If this repeats, the sender writes no sums; switch their "
               "check off.">(next_.type));
  } else if (next_.version < 2) {
    std::swap(next_.content, body_);
    message(next_);
    std::swap(next_.content, body_);  // keeps its memory for the next
  } else if (takeIgtlBodyApart(body_, next_)) {
    message(next_);
  } else {
    refuse(say<"A message of the type %1 does not hold together: the lengths of its parts do not fit its own.">(next_.type));
  }
  body_.clear();
}

std::vector<std::uint8_t> igtlBytes(const IgtlMessage& message) {
  EW_EXPECTS(message.version == 1 || message.version == 2);
  std::vector<std::uint8_t> body;
  if (message.version == 2) {
    std::size_t letters = 0;
    for (const auto& [key, value] : message.words) letters += key.size() + value.size();
    igtlPut(body, static_cast<std::uint16_t>(kIgtlExtended_bytes));
    igtlPut(body, static_cast<std::uint16_t>(2 + 8 * message.words.size()));
    igtlPut(body, static_cast<std::uint32_t>(letters));
    igtlPut(body, message.id);
  }
  body.insert(body.end(), message.content.begin(), message.content.end());
  if (message.version == 2) {
    constexpr std::uint16_t kAscii = 3;  // its number in IANA's list of character sets
    igtlPut(body, static_cast<std::uint16_t>(message.words.size()));
    for (const auto& [key, value] : message.words) {
      igtlPut(body, static_cast<std::uint16_t>(key.size()));
      igtlPut(body, kAscii);
      igtlPut(body, static_cast<std::uint32_t>(value.size()));
    }
    for (const auto& [key, value] : message.words) {
      igtlPutName(body, key, key.size());
      igtlPutName(body, value, value.size());
    }
  }
  std::vector<std::uint8_t> bytes;
  bytes.reserve(kIgtlHeader_bytes + body.size());
  igtlPut(bytes, static_cast<std::uint16_t>(message.version));
  igtlPutName(bytes, message.type, kIgtlType_bytes);
  igtlPutName(bytes, message.device, kIgtlDevice_bytes);
  igtlPut(bytes, igtlStampOf(message.time_s));
  igtlPut(bytes, static_cast<std::uint64_t>(body.size()));
  igtlPut(bytes, igtlSumOf(body));
  bytes.insert(bytes.end(), body.begin(), body.end());
  return bytes;
}

}  // namespace ew
