#include "ew/io/volume_stream.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "ew/core/contract.h"
#include "ew/core/file_errors.h"
#include "files/image_header.h"
#include "files/staging_file.h"
#include "volumes/meta_writer.h"

namespace ew {

namespace fs = std::filesystem;

struct VolumeStream::Parts {
  /// Written pages are given back to the system after so many bytes.
  static constexpr std::uint64_t kPutBetweenReleases = 64u << 20;
  /// A disk is told in pieces of this size, so that a wish to cancel is seen between them.
  static constexpr std::size_t kSyncPiece = 8u << 20;

  Grid grid;
  fs::path target;
  detail::StagingFile staged;
  int descriptor = -1;
  std::uint8_t* mapped = nullptr;
  std::size_t bytes = 0;   ///< of the file
  std::size_t offset = 0;  ///< of the first voxel
  std::uint64_t put_bytes = 0;

  Parts(const Grid& g, const fs::path& file, detail::StagingFile made) : grid(g), target(file), staged(std::move(made)) {}
  Parts(const Parts&) = delete;
  Parts& operator=(const Parts&) = delete;
  ~Parts() {
    if (mapped != nullptr) ::munmap(mapped, bytes);
    if (descriptor >= 0) ::close(descriptor);
  }

  [[nodiscard]] tl::unexpected<Error> refused(int number) const { return notWritable(target, number); }
};

VolumeStream::VolumeStream(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
VolumeStream::~VolumeStream() = default;
VolumeStream::VolumeStream(VolumeStream&&) noexcept = default;
VolumeStream& VolumeStream::operator=(VolumeStream&&) noexcept = default;

Result<VolumeStream> VolumeStream::create(const Grid& grid, const fs::path& file) {
  if (auto usable = checkGrid(grid); !usable) return passOn(usable.error());
  if (detail::lowerCase(file.extension().string()) != ".mha")
    return failure(ErrorCode::unsupported, say<"%1 cannot be written in blocks; end its name in .mha.">(detail::quoted(file)),
                   {{"file", file.string()}});
  auto staged = detail::StagingFile::create(file);
  if (!staged) return passOn(staged.error());
  auto parts = std::make_unique<Parts>(grid, file, std::move(*staged));
  const std::string header = detail::plainVolumeHeader(grid);
  parts->offset = header.size();
  parts->bytes = header.size() + grid.voxelCount();
  parts->descriptor = ::open(parts->staged.aside().c_str(), O_RDWR | O_CLOEXEC);
  if (parts->descriptor < 0) return parts->refused(errno);
  // A hole that turns out to have no room while it is written through a mapping would end the program, so the room is taken now.
  if (const int problem = ::posix_fallocate(parts->descriptor, 0, static_cast<off_t>(parts->bytes)); problem != 0)
    return parts->refused(problem);
  void* mapped = ::mmap(nullptr, parts->bytes, PROT_READ | PROT_WRITE, MAP_SHARED, parts->descriptor, 0);
  if (mapped == MAP_FAILED) return parts->refused(errno);
  parts->mapped = static_cast<std::uint8_t*>(mapped);
  std::memcpy(parts->mapped, header.data(), header.size());
  return VolumeStream(std::move(parts));
}

void VolumeStream::put(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values) {
  const Grid& grid = parts_->grid;
  EW_EXPECTS(size.x > 0 && size.y > 0 && size.z > 0 && grid.contains(corner) && grid.contains(corner + size - 1));
  const auto length = static_cast<std::size_t>(size.x);
  EW_EXPECTS(values.size() == length * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z));
  const std::uint8_t* from = values.data();
  for (int k = 0; k < size.z; ++k)
    for (int j = 0; j < size.y; ++j, from += length)
      std::memcpy(parts_->mapped + parts_->offset + grid.indexOf(corner.x, corner.y + j, corner.z + k), from, length);
  parts_->put_bytes += values.size();
  if (parts_->put_bytes < Parts::kPutBetweenReleases) return;
  parts_->put_bytes = 0;
  ::madvise(parts_->mapped, parts_->bytes, MADV_DONTNEED);  // shared: what was written stays in the system's file cache
}

Result<void> VolumeStream::finish(Progress& progress) {
  Parts& parts = *parts_;
  for (std::size_t at = 0; at < parts.bytes; at += Parts::kSyncPiece) {
    if (progress.cancelRequested()) {
      const fs::path file = parts.target;
      parts_.reset();
      return failure(ErrorCode::cancelled, say<"Writing %1 was stopped; nothing was left of it.">(detail::quoted(file)));
    }
    if (::msync(parts.mapped + at, std::min(Parts::kSyncPiece, parts.bytes - at), MS_SYNC) != 0) return parts.refused(errno);
    progress.report(say<"Writing voxels">(), static_cast<double>(at) / static_cast<double>(parts.bytes));
  }
  if (auto finished = parts.staged.finish(); !finished) return finished;
  return parts.staged.commit();
}

}  // namespace ew
