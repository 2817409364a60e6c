#include "files/byte_source.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <limits>
#include <vector>

#include "ew/core/file_errors.h"
#include "ew/core/numbers.h"
#include "files/grey_samples.h"

namespace ew::detail {
namespace fs = std::filesystem;

ByteSource::~ByteSource() = default;

namespace {

class FileSource final : public ByteSource {
 public:
  FileSource(fs::path file, std::uint64_t offset, std::uint64_t bytes)
      : file_(std::move(file)), in_(file_, std::ios::binary), left_(bytes) {
    in_.seekg(static_cast<std::streamoff>(offset));
  }
  [[nodiscard]] bool ok() const { return in_.is_open() && in_.good(); }

  Result<std::size_t> read(std::span<std::uint8_t> into) override {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(into.size(), left_));
    if (wanted == 0) return std::size_t{0};
    in_.read(reinterpret_cast<char*>(into.data()), static_cast<std::streamsize>(wanted));
    if (in_.bad())
      return failure(ErrorCode::notReadable, say<"%1 cannot be read; check the medium it is on.">(quoted(file_)),
                     {{"file", file_.string()}});
    const auto got = static_cast<std::size_t>(in_.gcount());
    left_ = got < wanted ? 0 : left_ - got;
    return got;
  }

 private:
  fs::path file_;
  std::ifstream in_;
  std::uint64_t left_;
};

class InflateSource final : public ByteSource {
 public:
  InflateSource(fs::path file, std::unique_ptr<ByteSource> packed) : file_(std::move(file)), packed_(std::move(packed)), input_(kChunk) {
    constexpr int zlibOrGzip = 15 + 32;
    ok_ = inflateInit2(&stream_, zlibOrGzip) == Z_OK;
  }
  ~InflateSource() override {
    if (ok_) inflateEnd(&stream_);
  }
  InflateSource(const InflateSource&) = delete;
  InflateSource& operator=(const InflateSource&) = delete;

  Result<std::size_t> read(std::span<std::uint8_t> into) override {
    std::size_t filled = 0;
    while (ok_ && filled < into.size() && !ended_) {
      if (stream_.avail_in == 0) {
        const auto got = packed_->read(input_);
        if (!got) return passOn(got.error());
        if (*got == 0) break;
        stream_.next_in = input_.data();
        stream_.avail_in = static_cast<uInt>(*got);
      }
      if (betweenMembers_) {
        // gzip files may be several streams in a row (.nii.gz written in parallel); anything else after the end is not ours to read.
        if (!gzip_ || *stream_.next_in != 0x1f) {
          ended_ = true;
          break;
        }
        inflateReset(&stream_);
        betweenMembers_ = false;
      } else if (!started_) {
        gzip_ = *stream_.next_in == 0x1f;
        started_ = true;
      }
      const auto room = static_cast<uInt>(std::min<std::size_t>(into.size() - filled, std::numeric_limits<uInt>::max()));
      stream_.next_out = into.data() + filled;
      stream_.avail_out = room;
      const int status = inflate(&stream_, Z_NO_FLUSH);
      filled += room - stream_.avail_out;
      if (status == Z_STREAM_END) {
        betweenMembers_ = true;
        if (!gzip_) ended_ = true;
      } else if (status != Z_OK && status != Z_BUF_ERROR) {
        return failure(ErrorCode::notReadable, say<"The compressed samples of %1 are damaged; get the file again.">(quoted(file_)),
                       {{"file", file_.string()}, {"reason", stream_.msg != nullptr ? stream_.msg : "inflate failed"}});
      }
    }
    return filled;
  }
  [[nodiscard]] bool ok() const { return ok_; }

  /// Whether the stream came to its own end, checksum included.
  [[nodiscard]] bool complete() const { return ended_ || betweenMembers_; }

 private:
  static constexpr std::size_t kChunk = 256u << 10;
  fs::path file_;
  std::unique_ptr<ByteSource> packed_;
  std::vector<std::uint8_t> input_;
  z_stream stream_{};
  bool ok_ = false;
  bool started_ = false;
  bool gzip_ = false;
  bool betweenMembers_ = false;
  bool ended_ = false;
};

/// Numbers written as text, turned into samples of the header's type.
class TextSource final : public ByteSource {
 public:
  TextSource(fs::path file, SampleType type, bool bigEndian, std::unique_ptr<ByteSource> text)
      : file_(std::move(file)), type_(type), bigEndian_(bigEndian), text_(std::move(text)) {}

  Result<std::size_t> read(std::span<std::uint8_t> into) override {
    std::size_t filled = 0;
    while (filled < into.size()) {
      if (at_ < bytes_) {
        const std::size_t count = std::min(bytes_ - at_, into.size() - filled);
        std::memcpy(into.data() + filled, sample_.data() + at_, count);
        filled += count;
        at_ += count;
        continue;
      }
      const auto more = nextNumber();
      if (!more) return passOn(more.error());
      if (!*more) break;
    }
    return filled;
  }

 private:
  Result<bool> nextNumber() {
    std::string word;
    for (;;) {
      if (read_ == available_) {
        const auto got = text_->read(buffer_);
        if (!got) return passOn(got.error());
        available_ = *got;
        read_ = 0;
        if (available_ == 0) break;
      }
      const char letter = static_cast<char>(buffer_[read_++]);
      const bool blank = letter == ' ' || letter == '\n' || letter == '\r' || letter == '\t' || letter == ',';
      if (blank && !word.empty()) break;
      if (!blank) word.push_back(letter);
      if (word.size() > 64) break;
    }
    if (word.empty()) return false;
    const auto number = parseNumber(word);
    if (!number || !store(*number))
      return badField(file_, say<"a sample">(), verbatim(word), say<"a number that fits %1 samples">(nameOf(type_)));
    return true;
  }

  template <class T>
  bool storeAs(double number) {
    if constexpr (std::is_integral_v<T>) {
      // 2^63 and 2^64 are the first doubles beyond the range; the largest integers themselves are not doubles.
      const double lowest = static_cast<double>(std::numeric_limits<T>::lowest());
      const double beyond = std::ldexp(1.0, std::numeric_limits<T>::digits);
      if (!(number >= lowest && number < beyond) || number != std::floor(number)) return false;
    }
    const T value = static_cast<T>(number);
    bytes_ = sizeof(T);
    at_ = 0;
    std::memcpy(sample_.data(), &value, sizeof(T));
    if (bigEndian_ != (std::endian::native == std::endian::big)) std::reverse(sample_.begin(), sample_.begin() + sizeof(T));
    return true;
  }

  bool store(double number) {
    switch (type_) {
      case SampleType::u8:
        return storeAs<std::uint8_t>(number);
      case SampleType::i8:
        return storeAs<std::int8_t>(number);
      case SampleType::u16:
        return storeAs<std::uint16_t>(number);
      case SampleType::i16:
        return storeAs<std::int16_t>(number);
      case SampleType::u32:
        return storeAs<std::uint32_t>(number);
      case SampleType::i32:
        return storeAs<std::int32_t>(number);
      case SampleType::u64:
        return storeAs<std::uint64_t>(number);
      case SampleType::i64:
        return storeAs<std::int64_t>(number);
      case SampleType::f32:
        return storeAs<float>(number);
      case SampleType::f64:
        return storeAs<double>(number);
      case SampleType::none:
        return false;
    }
    return false;
  }

  fs::path file_;
  SampleType type_;
  bool bigEndian_;
  std::unique_ptr<ByteSource> text_;
  std::array<std::uint8_t, 4096> buffer_{};
  std::size_t available_ = 0;
  std::size_t read_ = 0;
  std::array<std::uint8_t, 8> sample_{};
  std::size_t bytes_ = 0;
  std::size_t at_ = 0;
};

/// Passes the inflated bytes on and turns a stream cut off before its checksum into an error.
class ChecksumSource final : public ByteSource {
 public:
  ChecksumSource(fs::path file, std::unique_ptr<InflateSource> inflated) : file_(std::move(file)), inflated_(std::move(inflated)) {}
  Result<std::size_t> read(std::span<std::uint8_t> into) override {
    auto got = inflated_->read(into);
    if (!got) return got;
    given_ += *got;
    if (*got < into.size() && !inflated_->complete())
      return failure(ErrorCode::truncated,
                     say<"The compressed samples of %1 break off after %2 unpacked bytes; get the file again.">(quoted(file_), given_),
                     {{"file", file_.string()}, {"unpacked", std::to_string(given_)}});
    return got;
  }

 private:
  fs::path file_;
  std::unique_ptr<InflateSource> inflated_;
  std::uint64_t given_ = 0;
};

}  // namespace

Result<void> checkAgainstFile(const ImageHeader& header, std::uint64_t promisedBytes, std::uint64_t promisedSamples,
                              std::uint64_t packedBytes) {
  // Deflate cannot pack more tightly than 1032 to 1, and a number in text takes at least one character.
  constexpr std::uint64_t tightest = 1032;
  const bool deflated = header.packing == Packing::deflated;
  const std::uint64_t largest = deflated ? packedBytes * tightest + tightest : packedBytes;
  const std::uint64_t wanted = header.packing == Packing::text ? promisedSamples : promisedBytes;
  if (wanted <= largest) return {};
  return failure(
      ErrorCode::truncated,
      deflated ? say<"%1 is too short: its header promises %2 bytes of samples, the file has %3 compressed bytes, which cannot hold them; "
                     "get the file again.">(quoted(header.dataFile), promisedBytes, packedBytes)
               : say<"%1 is too short: its header promises %2 bytes of samples, the file has %3; get the file again.">(
                     quoted(header.dataFile), promisedBytes, packedBytes),
      {{"file", header.dataFile.string()}, {"promised", std::to_string(promisedBytes)}, {"found", std::to_string(packedBytes)}});
}

Result<ByteStream> openSamples(const ImageHeader& header, std::uint64_t promisedBytes, const Progress& progress) {
  std::error_code problem;
  const std::uint64_t fileBytes = fs::file_size(header.dataFile, problem);
  if (problem)
    return failure(ErrorCode::notReadable,
                   say<"%1 cannot be read (%2); check its permissions.">(quoted(header.dataFile), verbatim(problem.message())),
                   {{"file", header.dataFile.string()}});
  std::uint64_t offset = header.dataOffset;
  if (header.dataAtEnd) {
    if (header.packing != Packing::raw)
      return failure(ErrorCode::unsupported, say<"%1 asks for the last bytes of packed samples; store them unpacked.">(quoted(header.file)),
                     {{"file", header.file.string()}});
    if (promisedBytes > fileBytes)
      return failure(ErrorCode::truncated,
                     say<"%1 is too short: its header promises %2 bytes of samples, the file has %3; get the file again.">(
                         quoted(header.dataFile), promisedBytes, fileBytes),
                     {{"file", header.dataFile.string()}});
    offset = fileBytes - promisedBytes;
  }
  const std::uint64_t available = offset < fileBytes ? fileBytes - offset : 0;
  if (header.packedBytes && *header.packedBytes > available)
    return failure(
        ErrorCode::truncated,
        say<"%1 is too short: its header promises %2 compressed bytes, the file has %3; get the file again.">(
            quoted(header.dataFile), *header.packedBytes, available),
        {{"file", header.dataFile.string()}, {"promised", std::to_string(*header.packedBytes)}, {"found", std::to_string(available)}});
  ByteStream opened;
  opened.packedBytes = header.packedBytes ? *header.packedBytes : available;
  if (opened.packedBytes == 0 && promisedBytes > 0)
    return failure(ErrorCode::truncated,
                   say<"%1 is too short: its header promises %2 bytes of samples, the file has %3; get the file again.">(
                       quoted(header.dataFile), promisedBytes, 0),
                   {{"file", header.dataFile.string()}});
  errno = 0;
  auto file = std::make_unique<FileSource>(header.dataFile, std::min(offset, fileBytes), opened.packedBytes);
  if (!file->ok()) return notOpened(header.dataFile, errno);
  switch (header.packing) {
    case Packing::raw:
      opened.source = std::move(file);
      break;
    case Packing::text:
      opened.source = std::make_unique<TextSource>(header.dataFile, header.type, header.bigEndian, std::move(file));
      break;
    case Packing::deflated: {
      auto inflated = std::make_unique<InflateSource>(header.dataFile, std::move(file));
      if (!inflated->ok())
        return failure(ErrorCode::internal, say<"The decompressor could not be started; free some memory and try again.">());
      opened.source = std::make_unique<ChecksumSource>(header.dataFile, std::move(inflated));
      break;
    }
  }
  if (header.skipUnpacked > 0)
    if (const auto held = checkAgainstFile(header, header.skipUnpacked, header.skipUnpacked, opened.packedBytes); !held)
      return passOn(held.error());
  std::vector<std::uint8_t> skipped(static_cast<std::size_t>(std::min<std::uint64_t>(header.skipUnpacked, 64u << 10)));
  for (std::uint64_t left = header.skipUnpacked; left > 0;) {
    if (progress.cancelRequested()) return stopped(header.file);
    const auto part = std::span(skipped).first(static_cast<std::size_t>(std::min<std::uint64_t>(left, skipped.size())));
    const auto got = opened.source->read(part);
    if (!got) return passOn(got.error());
    if (*got < part.size())
      return failure(ErrorCode::truncated, say<"%1 ends before its samples begin; get the file again.">(quoted(header.dataFile)),
                     {{"file", header.dataFile.string()}});
    left -= *got;
  }
  return opened;
}

}  // namespace ew::detail
