#include "files/file_pieces.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <utility>

#include "ew/core/file_errors.h"

namespace ew {
namespace {

constexpr std::size_t kPiece_bytes = 1u << 20;
constexpr std::uint64_t kSyncEvery_bytes = 8u << 20;

Message reasonNow() { return verbatim(std::generic_category().message(errno)); }

tl::unexpected<Error> cannotRead(const std::filesystem::path& file) {
  return failure(
      errno == ENOENT ? ErrorCode::notFound : ErrorCode::notReadable,
      say<"\"%1\" cannot be read (%2); check that it is there, that you may read it, and the medium it is on.">(file, reasonNow()),
      {{"file", file.string()}});
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int number() const { return number_; }

 private:
  int number_;
};

}  // namespace

tl::unexpected<Error> stoppedAsAsked() { return failure(ErrorCode::cancelled, say<"Stopped as asked; nothing was written.">()); }

Result<void> ByteCount::add(std::uint64_t bytes) {
  done_ += bytes;
  progress_.report(what_, total_ == 0 ? 1.0 : std::min(1.0, static_cast<double>(done_) / static_cast<double>(total_)));
  if (progress_.cancelRequested()) return stoppedAsAsked();
  return {};
}

Result<void> readInPieces(const std::filesystem::path& file, ByteCount& count, const TakePiece& take) {
  const Descriptor in(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));  // a pipe put there meanwhile does not hold us up
  if (in.number() < 0) return cannotRead(file);
  std::vector<std::byte> piece(kPiece_bytes);
  if (auto going = count.add(0); !going) return going;
  for (;;) {
    const ssize_t got = ::read(in.number(), piece.data(), piece.size());
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return cannotRead(file);
    if (got == 0) return {};
    if (auto taken = take(std::span(piece).first(static_cast<std::size_t>(got))); !taken) return taken;
    if (auto going = count.add(static_cast<std::uint64_t>(got)); !going) return going;
  }
}

Result<PieceWriter> PieceWriter::create(const std::filesystem::path& file) {
  std::error_code problem;
  std::filesystem::create_directories(file.parent_path(), problem);
  if (problem) return notWritable(file, verbatim(problem.message()));
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0) return notWritable(file, reasonNow());
  return PieceWriter(file, descriptor);
}

PieceWriter::PieceWriter(PieceWriter&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)), unsynced_(other.unsynced_) {}

PieceWriter::~PieceWriter() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<void> PieceWriter::write(std::span<const std::byte> piece) {
  unsynced_ += piece.size();
  while (!piece.empty()) {
    const ssize_t put = ::write(descriptor_, piece.data(), piece.size());
    if (put < 0 && errno == EINTR) continue;
    if (put < 0) return notWritable(file_, reasonNow());
    piece = piece.subspan(static_cast<std::size_t>(put));
  }
  if (unsynced_ < kSyncEvery_bytes) return {};
  unsynced_ = 0;
  return ::fdatasync(descriptor_) == 0 ? Result<void>() : notWritable(file_, reasonNow());
}

Result<void> PieceWriter::finish() {
  const bool synced = ::fsync(descriptor_) == 0;
  if (!synced) return notWritable(file_, reasonNow());
  if (::close(std::exchange(descriptor_, -1)) != 0) return notWritable(file_, reasonNow());
  return {};
}

Result<FileSum> copyInPieces(const std::filesystem::path& from, const std::filesystem::path& to, ByteCount& count) {
  auto out = PieceWriter::create(to);
  if (!out) return passOn(out.error());
  Sha256 sum;
  FileSum copied;
  auto read = readInPieces(from, count, [&](std::span<const std::byte> piece) {
    sum.add(piece);
    copied.size_bytes += piece.size();
    return out->write(piece);
  });
  if (!read) return passOn(read.error());
  if (auto finished = out->finish(); !finished) return passOn(finished.error());
  copied.sha256 = sum.hex();
  return copied;
}

Result<FileSum> sumInPieces(const std::filesystem::path& file, ByteCount& count) {
  Sha256 sum;
  FileSum read;
  auto all = readInPieces(file, count, [&](std::span<const std::byte> piece) -> Result<void> {
    sum.add(piece);
    read.size_bytes += piece.size();
    return {};
  });
  if (!all) return passOn(all.error());
  read.sha256 = sum.hex();
  return read;
}

std::uint64_t bytesOf(const std::vector<FileSum>& files) {
  std::uint64_t bytes = 0;
  for (const FileSum& each : files) bytes += each.size_bytes;
  return bytes;
}

Result<void> checkRoom(const std::filesystem::path& place, std::uint64_t bytes) {
  constexpr std::uint64_t kMore_bytes = 1u << 20;
  std::error_code problem;
  std::filesystem::path there = std::filesystem::absolute(place, problem);
  while (there.has_relative_path() && !std::filesystem::exists(there, problem)) there = there.parent_path();
  const auto room = std::filesystem::space(there, problem);
  if (problem || bytes + kMore_bytes <= room.available) return {};  // where nobody can tell, writing tells
  return failure(ErrorCode::notWritable,
                 say<"The place '%1' has %2 MiB left, and %3 MiB are needed; free some room or choose another place.">(
                     place, room.available >> 20, (bytes + kMore_bytes) >> 20),
                 {{"file", place.string()}});
}

}  // namespace ew
