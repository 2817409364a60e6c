#include "ew/io/mapped_volume.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>

#include "ew/core/file_errors.h"
#include "files/image_header.h"
#include "files/volume_extent.h"

namespace ew {
namespace {

using namespace detail;
namespace fs = std::filesystem;

/// How often the watcher looks. In this time a slicer on two threads took up at most some 150 MiB of pages that lay in the file cache.
constexpr std::chrono::milliseconds kLook{5};

/// Closes what it opened.
struct Descriptor {
  int number = -1;
  explicit Descriptor(int opened) : number(opened) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number >= 0) ::close(number);
  }
};

/// Bytes of files that this program has in memory, or 0 when the system does not say.
std::uint64_t residentFileBytes(int statm) {
  std::array<char, 128> text{};
  const ssize_t got = ::pread(statm, text.data(), text.size() - 1, 0);
  if (got <= 0) return 0;
  char* at = text.data();
  std::strtoull(at, &at, 10);  // size
  std::strtoull(at, &at, 10);  // resident
  return std::strtoull(at, nullptr, 10) * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// Why the samples do not lie in the file as they would lie in memory; nothing when they do.
Message whyNotMappable(const ImageHeader& header) {
  switch (header.packing) {
    case Packing::raw:
      break;
    case Packing::deflated:
      return say<"compressed">();
    case Packing::text:
      return say<"written as text">();
  }
  if (header.type != SampleType::u8) return say<"%1 samples">(nameOf(header.type));
  if (header.channels != 1) return say<"%1 values a voxel">(header.channels);
  if (!(header.slope > 0.0)) return say<"rescaled with a slope that is not positive">();
  return {};
}

/// Success when the samples lie in the file as they would lie in memory.
Result<void> checkMappable(const ImageHeader& header) {
  const Message found = whyNotMappable(header);
  if (found.empty()) return {};
  return failure(
      ErrorCode::unsupported,
      say<"%1 is %2, so it cannot be mapped; read it into memory, or save it uncompressed with 8 bit samples.">(quoted(header.file), found),
      {{"file", header.file.string()}, {"found", found.english()}, {"expected", "uncompressed 8 bit unsigned samples"}});
}

struct Place {
  std::uint64_t offset = 0;  ///< of the first sample
  struct stat status {};
};

/// Where the samples begin, once the file is known to hold them all.
Result<Place> placeOf(const ImageHeader& header, std::uint64_t promised_bytes, int file) {
  Place place;
  if (::fstat(file, &place.status) != 0)
    return failure(ErrorCode::notReadable, say<"%1 cannot be read; check its permissions.">(quoted(header.dataFile)),
                   {{"file", header.dataFile.string()}});
  const auto length = static_cast<std::uint64_t>(place.status.st_size);
  place.offset = header.dataOffset + header.skipUnpacked;
  if (header.dataAtEnd && promised_bytes <= length) place.offset = length - promised_bytes;
  const std::uint64_t available = place.offset < length ? length - place.offset : 0;
  if (promised_bytes > available)
    return failure(
        ErrorCode::truncated,
        say<"%1 is too short: its header promises %2 bytes of samples, the file has %3; get the file again.">(quoted(header.dataFile),
                                                                                                              promised_bytes, available),
        {{"file", header.dataFile.string()}, {"promised", std::to_string(promised_bytes)}, {"found", std::to_string(available)}});
  return place;
}

}  // namespace

struct MappedVolume::Mapping {
  fs::path file;
  Descriptor descriptor{-1};
  Descriptor statm{-1};
  struct stat status {};
  void* reserved = MAP_FAILED;  ///< the mapping and one page behind it
  std::size_t reserved_bytes = 0;
  std::size_t mapped_bytes = 0;
  VolumeView<const std::uint8_t> view;
  std::vector<Message> notes;
  std::uint64_t highest_bytes = 0;  ///< of resident pages of files, this program's others included

  std::mutex mutex;
  std::condition_variable wake;
  bool ending = false;
  std::thread watcher;

  Mapping(fs::path path, int opened) : file(std::move(path)), descriptor(opened), statm(::open("/proc/self/statm", O_RDONLY | O_CLOEXEC)) {}
  Mapping(const Mapping&) = delete;
  Mapping& operator=(const Mapping&) = delete;

  ~Mapping() {
    if (watcher.joinable()) {
      {
        const std::lock_guard lock(mutex);
        ending = true;
      }
      wake.notify_one();
      watcher.join();
    }
    if (reserved != MAP_FAILED) ::munmap(reserved, reserved_bytes);
  }

  // The pages of a file that is only read hold nothing of their own: taken away, they are found again in the file.
  void release() const { ::madvise(reserved, mapped_bytes, MADV_DONTNEED); }

  void watch() {
    std::unique_lock lock(mutex);
    while (!wake.wait_for(lock, kLook, [this] { return ending; }))
      if (residentFileBytes(statm.number) > highest_bytes) release();
  }
};

MappedVolume::MappedVolume(std::unique_ptr<Mapping> mapping) : mapping_(std::move(mapping)) {}
MappedVolume::~MappedVolume() = default;
MappedVolume::MappedVolume(MappedVolume&&) noexcept = default;
MappedVolume& MappedVolume::operator=(MappedVolume&&) noexcept = default;

VolumeView<const std::uint8_t> MappedVolume::view() const { return mapping_->view; }
const Grid& MappedVolume::grid() const { return mapping_->view.grid; }
const std::vector<Message>& MappedVolume::notes() const { return mapping_->notes; }
void MappedVolume::release() const { mapping_->release(); }

Result<void> MappedVolume::unchanged() const {
  struct stat now {};
  const struct stat& then = mapping_->status;
  if (::fstat(mapping_->descriptor.number, &now) == 0 && now.st_size == then.st_size && now.st_mtim.tv_sec == then.st_mtim.tv_sec &&
      now.st_mtim.tv_nsec == then.st_mtim.tv_nsec)
    return {};
  return failure(ErrorCode::notReadable, say<"%1 was changed while it was in use; open it again.">(quoted(mapping_->file)),
                 {{"file", mapping_->file.string()}});
}

Result<MappedVolume> mapVolume(const fs::path& file, const MapOptions& options) {
  const auto header = readImageHeader(file);
  if (!header) return passOn(header.error());
  if (auto mappable = checkMappable(*header); !mappable) return passOn(mappable.error());
  std::vector<Message> notes = header->notes;
  const auto extent = volumeExtentOf(*header, notes);
  if (!extent) return passOn(extent.error());

  const int opened = ::open(header->dataFile.c_str(), O_RDONLY | O_CLOEXEC);
  if (opened < 0) return notOpened(header->dataFile, errno);
  auto mapping = std::make_unique<MappedVolume::Mapping>(header->dataFile, opened);
  const auto place = placeOf(*header, extent->promised, mapping->descriptor.number);
  if (!place) return passOn(place.error());
  mapping->status = place->status;

  const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  const std::uint64_t ahead = place->offset % page;
  mapping->mapped_bytes = static_cast<std::size_t>((ahead + extent->voxels + page - 1) / page * page);
  // A page of zeros behind the last voxel: a slicer may load a few bytes more than it uses.
  mapping->reserved_bytes = mapping->mapped_bytes + static_cast<std::size_t>(page);
  mapping->reserved = ::mmap(nullptr, mapping->reserved_bytes, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  if (mapping->reserved == MAP_FAILED || ::mmap(mapping->reserved, mapping->mapped_bytes, PROT_READ, MAP_SHARED | MAP_FIXED,
                                                mapping->descriptor.number, static_cast<off_t>(place->offset - ahead)) == MAP_FAILED)
    return failure(ErrorCode::tooLarge,
                   say<"%1 cannot be mapped (%2); read it into memory.">(quoted(header->dataFile), verbatim(std::strerror(errno))),
                   {{"file", header->dataFile.string()}});
  mapping->view = {static_cast<const std::uint8_t*>(mapping->reserved) + ahead, extent->grid};
  mapping->notes = std::move(notes);
  mapping->highest_bytes = residentFileBytes(mapping->statm.number) + options.residentBudget_bytes;
  try {
    mapping->watcher = std::thread([watched = mapping.get()] { watched->watch(); });
  } catch (const std::system_error&) {
    return failure(ErrorCode::tooLarge, say<"There are no threads left to keep watch over %1; close other programs.">(quoted(file)),
                   {{"file", file.string()}});
  }
  return MappedVolume(std::move(mapping));
}

std::uint64_t mappableBytes(const fs::path& file) {
  const auto header = readImageHeader(file);
  if (!header || !checkMappable(*header)) return 0;
  std::vector<Message> ignored;
  const auto extent = volumeExtentOf(*header, ignored);
  return extent ? extent->voxels : 0;
}

}  // namespace ew
