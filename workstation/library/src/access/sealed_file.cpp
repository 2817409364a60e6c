#include "access/sealed_file.h"

#include <sys/stat.h>

#include <array>
#include <fstream>
#include <nlohmann/json.hpp>

#include "access/sodium_ready.h"
#include "ew/core/json_fields.h"
#include "ew/library/sealed_answers.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::string_view kMagic = "EWSEALED";
constexpr std::size_t kStreamPiece_bytes = 64u << 10;
constexpr std::size_t kLongestHeader_bytes = 64u << 10;
constexpr std::size_t kMostInstructors = 20;
constexpr std::size_t kStreamKey_bytes = crypto_secretstream_xchacha20poly1305_KEYBYTES;
constexpr std::size_t kMore_bytes = crypto_secretstream_xchacha20poly1305_ABYTES;
using StreamKey = std::array<std::uint8_t, kStreamKey_bytes>;
using SealedBox = std::array<std::uint8_t, kStreamKey_bytes + crypto_box_SEALBYTES>;
using PrefixSum = std::array<std::uint8_t, crypto_generichash_BYTES>;

class KeyBuffer {
 public:
  KeyBuffer() = default;
  ~KeyBuffer() { ::sodium_memzero(bytes.data(), bytes.size()); }
  KeyBuffer(const KeyBuffer&) = delete;
  KeyBuffer& operator=(const KeyBuffer&) = delete;
  StreamKey bytes{};
};

std::string fourBytes(std::size_t number) {
  std::string bytes;
  for (int n = 0; n < 4; ++n) bytes += static_cast<char>((number >> (8 * n)) & 0xff);
  return bytes;
}

std::size_t numberOf(std::string_view bytes) {
  std::size_t number = 0;
  for (std::size_t n = 4; n-- > 0;) number = (number << 8) | static_cast<std::uint8_t>(bytes[n]);
  return number;
}

PrefixSum sumOf(const std::string& before) {
  PrefixSum sum{};
  ::crypto_generichash(sum.data(), sum.size(), reinterpret_cast<const std::uint8_t*>(before.data()), before.size(), nullptr, 0);
  return sum;
}

tl::unexpected<Error> sealedFileChanged(const fs::path& file) {
  return failure(ErrorCode::badField,
                 say<"\"%1\" was changed, damaged or cut off since the examination was made; use the bundle as it was exported.">(file),
                 {{"file", file.string()}});
}

tl::unexpected<Error> noSealedFile(const fs::path& file) {
  return failure(ErrorCode::badHeader, say<"\"%1\" holds no sealed answers; use the bundle as it was exported.">(file),
                 {{"file", file.string()}});
}

/// Collects what is written into pieces of the stream; one is held back until it is known whether it is the last.
class StreamWriter {
 public:
  explicit StreamWriter(PieceWriter& out) : out_(out) {}
  ~StreamWriter() { ::sodium_memzero(&state_, sizeof state_); }
  StreamWriter(const StreamWriter&) = delete;
  StreamWriter& operator=(const StreamWriter&) = delete;
  Result<void> begin(const StreamKey& key, const PrefixSum& before) {
    before_ = before;
    std::array<std::uint8_t, crypto_secretstream_xchacha20poly1305_HEADERBYTES> header{};
    ::crypto_secretstream_xchacha20poly1305_init_push(&state_, header.data(), key.data());
    return out_.write(std::as_bytes(std::span(header)));
  }
  Result<void> write(std::span<const std::byte> piece) {
    while (!piece.empty()) {
      if (held_.size() == kStreamPiece_bytes)
        if (auto written = push(0); !written) return written;
      const auto count = std::min(piece.size(), kStreamPiece_bytes - held_.size());
      held_.insert(held_.end(), piece.begin(), piece.begin() + static_cast<std::ptrdiff_t>(count));
      piece = piece.subspan(count);
    }
    return {};
  }
  Result<void> finish() { return push(crypto_secretstream_xchacha20poly1305_TAG_FINAL); }

 private:
  Result<void> push(std::uint8_t tag) {
    std::vector<std::uint8_t> sealed(held_.size() + kMore_bytes);
    ::crypto_secretstream_xchacha20poly1305_push(&state_, sealed.data(), nullptr, reinterpret_cast<const std::uint8_t*>(held_.data()),
                                                 held_.size(), before_.data(), before_.size(), tag);
    held_.clear();
    return out_.write(std::as_bytes(std::span(sealed)));
  }

  PieceWriter& out_;
  crypto_secretstream_xchacha20poly1305_state state_{};
  PrefixSum before_{};
  std::vector<std::byte> held_;
};

struct SealFileHead {
  SealHeader header;
  std::string before;  ///< the bytes before the stream
  std::vector<SealedBox> boxes;
};

Result<SealFileHead> headerIn(std::ifstream& in, const fs::path& file) {
  if (auto ready = readySodium(); !ready) return passOn(ready.error());
  std::string begin(kMagic.size() + 8, '\0');
  in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
  if (!in || !begin.starts_with(kMagic)) return noSealedFile(file);
  const std::size_t format = numberOf(std::string_view(begin).substr(kMagic.size(), 4));
  if (format > kSealedFormat)
    return failure(ErrorCode::newerFormat,
                   say<"%1 has format %2, and this program reads formats up to %3; open it with a newer EchoWeave.">(
                       std::string(kSealedName), format, kSealedFormat),
                   {{"file", file.string()}});
  const std::size_t length = numberOf(std::string_view(begin).substr(kMagic.size() + 4, 4));
  if (format == 0 || length > kLongestHeader_bytes) return noSealedFile(file);
  std::string text(length, '\0');
  in.read(text.data(), static_cast<std::streamsize>(length));
  if (!in) return sealedFileChanged(file);
  const Message where = say<"the header of %1">(std::string(kSealedName));
  const auto document = parseJsonObject(text, where);
  if (!document) return passOn(document.error());
  JsonReading reading(where);
  const JsonFields fields(*document, reading);
  SealFileHead opened;
  opened.before = begin + text;
  opened.header.caseId = fields.text("case", {}, 1, 100);
  opened.header.view = fields.text("view", {}, 64, 64);
  for (const JsonFields& slot : fields.objects("slots", 1, kMostInstructors)) {
    opened.header.forWhom.push_back(slot.text("for", {}, 1, 40));
    SealedBox box{};
    if (!fromBase64(slot.text("box"), box)) slot.refuse("box", say<"%1 bytes in base64">(box.size()));
    opened.boxes.push_back(box);
  }
  if (reading.problem()) return passOn(*reading.problem());
  return opened;
}

Result<std::ifstream> streamOf(const fs::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0)
    return failure(ErrorCode::notFound, say<"\"%1\" is not there; use the bundle as it was exported.">(file), {{"file", file.string()}});
  std::ifstream in(file, std::ios::binary);
  if (!S_ISREG(found.st_mode) || !in)
    return failure(ErrorCode::notReadable, say<"\"%1\" cannot be opened; check its permissions.">(file), {{"file", file.string()}});
  return in;
}

bool openSlot(const SealFileHead& opened, const SecretKey& key, StreamKey& streamKey) {
  for (const SealedBox& box : opened.boxes)
    if (::crypto_box_seal_open(streamKey.data(), box.data(), box.size(), key.publicKey().bytes.data(), key.bytes()) == 0) return true;
  return false;
}

Result<void> pullPieces(std::ifstream& in, const fs::path& file, const SealFileHead& opened, const StreamKey& key, ByteCount& count,
                        const TakePiece& take) {
  crypto_secretstream_xchacha20poly1305_state state{};
  std::array<std::uint8_t, crypto_secretstream_xchacha20poly1305_HEADERBYTES> header{};
  in.read(reinterpret_cast<char*>(header.data()), static_cast<std::streamsize>(header.size()));
  if (!in || ::crypto_secretstream_xchacha20poly1305_init_pull(&state, header.data(), key.data()) != 0) return sealedFileChanged(file);
  const PrefixSum before = sumOf(opened.before);
  std::vector<std::uint8_t> sealed(kStreamPiece_bytes + kMore_bytes), plain(kStreamPiece_bytes);
  for (;;) {
    in.read(reinterpret_cast<char*>(sealed.data()), static_cast<std::streamsize>(sealed.size()));
    const auto got = static_cast<std::size_t>(in.gcount());
    std::uint8_t tag = 0;
    unsigned long long length = 0;
    if (got < kMore_bytes || ::crypto_secretstream_xchacha20poly1305_pull(&state, plain.data(), &length, &tag, sealed.data(), got,
                                                                          before.data(), before.size()) != 0)
      return sealedFileChanged(file);
    if (auto counted = count.add(length); !counted) return counted;
    if (auto taken = take(std::as_bytes(std::span(plain).first(length))); !taken) return taken;
    if (tag != crypto_secretstream_xchacha20poly1305_TAG_FINAL) continue;
    ::sodium_memzero(plain.data(), plain.size());
    return in.peek() == std::ifstream::traits_type::eof() ? Result<void>() : sealedFileChanged(file);
  }
}

}  // namespace

Result<void> sealFile(const fs::path& file, const std::string& caseId, const std::string& view, const std::vector<PublicKey>& instructors,
                      const std::function<Result<void>(const TakePiece&)>& write) {
  if (auto ready = readySodium(); !ready) return ready;
  if (instructors.empty() || instructors.size() > kMostInstructors)
    return failure(ErrorCode::badUsage,
                   say<"Say for whom the answers are sealed, with 1 to %1 public keys; without one nobody could judge the examination.">(
                       kMostInstructors));
  KeyBuffer key;
  ::crypto_secretstream_xchacha20poly1305_keygen(key.bytes.data());
  json slots = json::array();
  for (const PublicKey& each : instructors) {
    SealedBox box{};
    if (::crypto_box_seal(box.data(), key.bytes.data(), key.bytes.size(), each.bytes.data()) != 0)
      return failure(ErrorCode::badField,
                     say<"The public key %1 cannot be used; make a new one with 'echoweave key new'.">(shortNameOf(each)));
    slots.push_back({{"for", shortNameOf(each)}, {"box", base64Of(box)}});
  }
  const std::string header = json{{"case", caseId}, {"view", view}, {"slots", slots}}.dump();
  const std::string before = std::string(kMagic) + fourBytes(kSealedFormat) + fourBytes(header.size()) + header;
  auto out = PieceWriter::create(file);
  if (!out) return passOn(out.error());
  if (auto written = out->write(std::as_bytes(std::span(before))); !written) return written;
  StreamWriter stream(*out);
  if (auto begun = stream.begin(key.bytes, sumOf(before)); !begun) return begun;
  if (auto written = write([&](std::span<const std::byte> piece) { return stream.write(piece); }); !written) return written;
  if (auto finished = stream.finish(); !finished) return finished;
  return out->finish();
}

Result<SealHeader> readSealedFileHeader(const fs::path& file) {
  auto in = streamOf(file);
  if (!in) return passOn(in.error());
  auto opened = headerIn(*in, file);
  if (!opened) return passOn(opened.error());
  return std::move(opened->header);
}

Result<void> openSealedFile(const fs::path& file, const SecretKey& key, ByteCount& count, const TakePiece& take) {
  auto in = streamOf(file);
  if (!in) return passOn(in.error());
  const auto opened = headerIn(*in, file);
  if (!opened) return passOn(opened.error());
  KeyBuffer streamKey;
  if (!openSlot(*opened, key, streamKey.bytes)) {
    std::string names;
    for (const std::string& each : opened->header.forWhom) names += (names.empty() ? "" : ", ") + each;
    return failure(ErrorCode::badUsage,
                   say<"The key %1 does not open the answers of the examination '%2', which were sealed for %3; use that one.">(
                       shortNameOf(key.publicKey()), opened->header.caseId, names),
                   {{"file", file.string()}});
  }
  return pullPieces(*in, file, *opened, streamKey.bytes, count, take);
}

}  // namespace ew
