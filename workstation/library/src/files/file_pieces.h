#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/library/checksums.h"

namespace ew {

/// Progress of work that is measured in bytes.
class ByteCount {
 public:
  ByteCount(Message what, std::uint64_t total, Progress& progress) : what_(std::move(what)), total_(total), progress_(progress) {}
  /// @error cancelled
  [[nodiscard]] Result<void> add(std::uint64_t bytes);
  [[nodiscard]] Progress& progress() { return progress_; }

 private:
  Message what_;
  std::uint64_t total_;
  Progress& progress_;
  std::uint64_t done_ = 0;
};

[[nodiscard]] tl::unexpected<Error> stoppedAsAsked();

using TakePiece = std::function<Result<void>(std::span<const std::byte>)>;

/// Reads a file once from its beginning, in pieces of at most a mebibyte.
/// @error notFound, notReadable, cancelled, of `take`
[[nodiscard]] Result<void> readInPieces(const std::filesystem::path& file, ByteCount& count, const TakePiece& take);

/// A new file that is written in pieces. Each few of them are brought to the medium at once: syncing gigabytes in the end would take
/// seconds in which nobody can stop it.
class PieceWriter {
 public:
  /// Makes the folders it lies in. @error notWritable (also when it is there)
  [[nodiscard]] static Result<PieceWriter> create(const std::filesystem::path& file);
  ~PieceWriter();
  PieceWriter(PieceWriter&& other) noexcept;
  PieceWriter& operator=(PieceWriter&&) = delete;
  [[nodiscard]] Result<void> write(std::span<const std::byte> piece);
  [[nodiscard]] Result<void> finish();

 private:
  PieceWriter(std::filesystem::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}
  std::filesystem::path file_;
  int descriptor_ = -1;
  std::uint64_t unsynced_ = 0;
};

/// Copies a file into a new one. @return its size and sum; `path` stays empty
/// @error as readInPieces, notWritable
[[nodiscard]] Result<FileSum> copyInPieces(const std::filesystem::path& from, const std::filesystem::path& to, ByteCount& count);

/// Size and sum of a file; `path` stays empty. @error as readInPieces
[[nodiscard]] Result<FileSum> sumInPieces(const std::filesystem::path& file, ByteCount& count);

[[nodiscard]] std::uint64_t bytesOf(const std::vector<FileSum>& files);

/// That a medium has room for so many bytes and some more for names. @param place need not be there yet
/// @error notWritable
[[nodiscard]] Result<void> checkRoom(const std::filesystem::path& place, std::uint64_t bytes);

}  // namespace ew
