#include "publishing/bundle_reader.h"

#include <archive.h>
#include <archive_entry.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <map>
#include <set>
#include <system_error>

#include "files/utf8_names.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

// So little at a time that what it can grow to (zeros, 30,000 times) takes no tenth of a second.
constexpr std::size_t kPacked_bytes = 16u << 10;
constexpr std::size_t kUnpacked_bytes = 1u << 20;

}  // namespace

struct BundleReader::Parts {
  Utf8Names names;
  fs::path file;
  BundleLimits limits;
  Progress& progress;
  int descriptor = -1;
  std::uint64_t size_bytes = 0;
  struct archive* source = nullptr;
  std::array<char, kPacked_bytes> packed{};
  std::optional<Error> problem;      // met below libarchive, which only hears that reading failed
  std::uint64_t mostUnpacked_bytes;  // what the rest may grow to
  BundleHeader header;

  Parts(fs::path named, const BundleLimits& given, Progress& asked)
      : file(std::move(named)), limits(given), progress(asked), mostUnpacked_bytes(kLargestBundleHeader_bytes + (1u << 20)) {}
  ~Parts() {
    if (source != nullptr) archive_read_free(source);
    if (descriptor >= 0) ::close(descriptor);
  }
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;

  template <Literal text, class... More>
  [[nodiscard]] tl::unexpected<Error> refuse(ErrorCode code, More&&... more) const {
    return failure(code, say<text>(file, std::forward<More>(more)...), {{"file", file.string()}});
  }
  [[nodiscard]] tl::unexpected<Error> isNoBundle() const {
    return refuse<"'%1' is not a case bundle; choose a file that EchoWeave has exported (.ewcase).">(ErrorCode::badHeader);
  }
  [[nodiscard]] tl::unexpected<Error> problemNow() const;

  Result<void> openFile();
  Result<void> openArchive();
  Result<std::optional<std::string>> nextEntry(struct archive_entry** entry);
  Result<void> readHeader();
  Result<std::uint64_t> readData(std::uint64_t most_bytes, const TakePiece& take);
  Result<void> readFile(const FileSum& listed, BundleSink& sink, ByteCount& count);

  static la_ssize_t feed(struct archive* source, void* self, const void** bytes);
};

tl::unexpected<Error> BundleReader::Parts::problemNow() const {
  if (problem) return passOn(*problem);
  const char* said = archive_error_string(source);
  const std::string reason = said == nullptr ? "" : said;
  if (reason.find("runcated") != std::string::npos)
    return refuse<"The bundle '%1' ends too early; copy or download it again.">(ErrorCode::truncated);
  return refuse<"The bundle '%1' is damaged (%2); copy or download it again.">(ErrorCode::badHeader, reason);
}

la_ssize_t BundleReader::Parts::feed(struct archive* source, void* self, const void** bytes) {
  auto& parts = *static_cast<Parts*>(self);
  const auto fail = [&](tl::unexpected<Error> error) -> la_ssize_t {
    parts.problem = std::move(error.value());
    archive_set_error(source, EIO, "stopped");
    return -1;
  };
  if (parts.progress.cancelRequested()) return fail(stoppedAsAsked());
  if (archive_filter_count(source) > 0 && archive_filter_bytes(source, 0) > static_cast<la_int64_t>(parts.mostUnpacked_bytes))
    return fail(parts.refuse<"The bundle '%1' holds more than its list names; do not use it.">(ErrorCode::tooLarge));
  for (;;) {
    const ssize_t got = ::read(parts.descriptor, parts.packed.data(), parts.packed.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0)
      return fail(parts.refuse<"The bundle '%1' cannot be read (%2); check the medium it is on.">(ErrorCode::notReadable,
                                                                                                  std::generic_category().message(errno)));
    *bytes = parts.packed.data();
    return got;
  }
}

Result<void> BundleReader::Parts::openFile() {
  descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  struct stat found {};
  if (descriptor < 0 || ::fstat(descriptor, &found) != 0) {
    const std::string reason = std::generic_category().message(errno);
    return refuse<"The bundle '%1' cannot be opened (%2); check that it is there and that you may read it.">(
        errno == ENOENT ? ErrorCode::notFound : ErrorCode::notReadable, reason);
  }
  if (!S_ISREG(found.st_mode)) return isNoBundle();
  size_bytes = static_cast<std::uint64_t>(found.st_size);
  static constexpr std::array<unsigned char, 4> kZstd = {0x28, 0xb5, 0x2f, 0xfd};
  std::array<unsigned char, 4> begins{};
  if (::pread(descriptor, begins.data(), begins.size(), 0) != static_cast<ssize_t>(begins.size()) || begins != kZstd) return isNoBundle();
  return {};
}

Result<void> BundleReader::Parts::openArchive() {
  source = archive_read_new();
  if (source == nullptr) throw std::bad_alloc();
  const bool ready = names.good() && archive_read_support_filter_zstd(source) == ARCHIVE_OK &&
                     archive_read_support_format_tar(source) == ARCHIVE_OK &&
                     // Else reading ends where the tar says so, and nobody sees that the file does not.
                     archive_read_set_options(source, "tar:read_concatenated_archives,hdrcharset=UTF-8") == ARCHIVE_OK;
  if (!ready) return problemNow();
  if (archive_read_open(source, this, nullptr, &Parts::feed, nullptr) == ARCHIVE_OK) return {};
  if (problem) return passOn(*problem);
  return problemNow();
}

/// The path of the next entry, a regular file; nothing at the end.
Result<std::optional<std::string>> BundleReader::Parts::nextEntry(struct archive_entry** entry) {
  const int read = archive_read_next_header(source, entry);
  if (read == ARCHIVE_EOF) return std::nullopt;
  if (read != ARCHIVE_OK) return problemNow();
  const char* name = archive_entry_pathname_utf8(*entry);
  if (name == nullptr) return problemNow();
  const std::string path = name;
  if (archive_entry_filetype(*entry) != AE_IFREG || archive_entry_hardlink(*entry) != nullptr || archive_entry_symlink(*entry) != nullptr ||
      archive_entry_sparse_count(*entry) != 0)
    return refuse<
        "The bundle '%1' holds \"%2\", which is a link, a device or a folder instead of a file; do not use it, and ask for "
        "another one from somebody you trust.">(ErrorCode::unsupported, path);
  if (!archive_entry_size_is_set(*entry) || archive_entry_size(*entry) < 0) return problemNow();
  return path;
}

Result<std::uint64_t> BundleReader::Parts::readData(std::uint64_t most_bytes, const TakePiece& take) {
  std::vector<std::byte> piece(kUnpacked_bytes);
  std::uint64_t bytes = 0;
  for (;;) {
    const la_ssize_t got = archive_read_data(source, piece.data(), piece.size());
    if (got < 0) return problemNow();
    if (got == 0) return bytes;
    bytes += static_cast<std::uint64_t>(got);
    if (bytes > most_bytes) return bytes;
    if (auto taken = take(std::span(piece).first(static_cast<std::size_t>(got))); !taken) return passOn(taken.error());
  }
}

Result<void> BundleReader::Parts::readHeader() {
  struct archive_entry* entry = nullptr;
  const auto path = nextEntry(&entry);
  if (!path && path.error().code == ErrorCode::badHeader && !problem && archive_format(source) == 0) return isNoBundle();
  if (!path) return passOn(path.error());
  const bool isTarInZstd = archive_filter_count(source) == 2 && archive_filter_code(source, 0) == ARCHIVE_FILTER_ZSTD;
  if (!*path || **path != kBundleHeaderName || !isTarInZstd) return isNoBundle();
  std::string text;
  const auto read = readData(kLargestBundleHeader_bytes, [&](std::span<const std::byte> piece) -> Result<void> {
    text.append(reinterpret_cast<const char*>(piece.data()), piece.size());
    return {};
  });
  if (!read) return passOn(read.error());
  if (*read > kLargestBundleHeader_bytes)
    return refuse<"The list of the bundle '%1' is too long to be that of a case; do not use it.">(ErrorCode::tooLarge);
  auto understood = bundleHeaderFrom(text, file, size_bytes, limits);
  if (!understood) return passOn(understood.error());
  header = *std::move(understood);
  constexpr std::uint64_t kOfEachEntry_bytes = 8u << 10;  // headers with long names, and filling up
  mostUnpacked_bytes = text.size() + bytesOf(header.files) + (header.files.size() + 1) * kOfEachEntry_bytes + (1u << 20);
  return {};
}

Result<void> BundleReader::Parts::readFile(const FileSum& listed, BundleSink& sink, ByteCount& count) {
  const auto isOther = [&] {
    return refuse<"\"%2\" in the bundle '%1' is not what was put in; copy or download the bundle again.">(ErrorCode::badField, listed.path);
  };
  if (auto begun = sink.begin(listed); !begun) return begun;
  Sha256 sum;
  const auto read = readData(listed.size_bytes, [&](std::span<const std::byte> piece) -> Result<void> {
    sum.add(piece);
    if (auto taken = sink.data(piece); !taken) return taken;
    return count.add(piece.size());
  });
  if (!read) return passOn(read.error());
  if (*read != listed.size_bytes || sum.hex() != listed.sha256) return isOther();
  return sink.end();
}

Result<BundleReader> BundleReader::open(const fs::path& file, const BundleLimits& limits, Progress& progress) {
  auto parts = std::make_unique<Parts>(file, limits, progress);
  if (auto opened = parts->openFile(); !opened) return passOn(opened.error());
  if (auto opened = parts->openArchive(); !opened) return passOn(opened.error());
  if (auto read = parts->readHeader(); !read) return passOn(read.error());
  return BundleReader(std::move(parts));
}

BundleReader::BundleReader(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
BundleReader::~BundleReader() = default;
BundleReader::BundleReader(BundleReader&&) noexcept = default;

const BundleHeader& BundleReader::header() const { return parts_->header; }

Result<void> BundleReader::readFiles(BundleSink& sink, ByteCount& count) {
  Parts& parts = *parts_;
  std::map<std::string, const FileSum*> awaited;
  for (const FileSum& each : parts.header.files) awaited.emplace(each.path, &each);
  std::set<std::string> seen{kBundleHeaderName};
  for (struct archive_entry* entry = nullptr;;) {
    const auto path = parts.nextEntry(&entry);
    if (!path) return passOn(path.error());
    if (!*path) break;
    if (auto reason = problemOfPath(**path, parts.limits))
      return parts.refuse<
          "The bundle '%1' holds a file named \"%2\", which is refused (%3); do not use it, and ask for another one from "
          "somebody you trust.">(ErrorCode::badField, **path, std::move(*reason));
    if (!seen.insert(**path).second)
      return parts.refuse<"The bundle '%1' holds \"%2\" twice; do not use it, and ask for another one.">(ErrorCode::badField, **path);
    const auto listed = awaited.find(**path);
    if (listed == awaited.end())
      return parts.refuse<"The bundle '%1' holds \"%2\", which its list does not name; do not use it, and ask for another one.">(
          ErrorCode::badField, **path);
    if (auto read = parts.readFile(*listed->second, sink, count); !read) return read;
    awaited.erase(listed);
  }
  if (awaited.empty()) return {};
  return parts.refuse<"The bundle '%1' lists \"%2\", which is not in it; ask for it to be exported again.">(ErrorCode::truncated,
                                                                                                            awaited.begin()->first);
}

}  // namespace ew
