#include "ew/io/rest_in_file.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "ew/io/medium.h"
#include "files/image_header.h"

#if defined(__linux__)
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/vfs.h>
#include <unistd.h>
#endif

namespace ew {
namespace fs = std::filesystem;

#if defined(__linux__)
namespace {

constexpr std::uint64_t kWorthwhile_bytes = std::uint64_t{1} << 20;
/// Compared and given back together, so that hardly more than what is given back is needed meanwhile.
constexpr std::uint64_t kPiece_bytes = std::uint64_t{4} << 20;

/// Whether a file system lies on another machine, or in another program: what it has may go away (most of these numbers are in statfs(2)).
bool isElsewhere(int file) {
  constexpr std::array<std::uint32_t, 18> kElsewhere = {
      0x00006969,  // NFS
      0x0000517B,  // SMB
      0xFF534D42,  // CIFS
      0xFE534D42,  // SMB 2
      0x65735546,  // FUSE
      0x01021997,  // 9P
      0x00C36400,  // Ceph
      0x5346414F,  // AFS
      0x6B414653,  // the kernel's own AFS
      0x73757245,  // Coda
      0x0000564C,  // NCP
      0x47504653,  // GPFS
      0x0BD00BD0,  // Lustre
      0x19830326,  // BeeGFS
      0x01161970,  // GFS2
      0x7461636F,  // OCFS2
      0x786F4256,  // VirtualBox
      0xBACBACBC,  // VMware
  };
  struct statfs found {};
  if (::fstatfs(file, &found) != 0) return true;
  return std::find(kElsewhere.begin(), kElsewhere.end(), static_cast<std::uint32_t>(found.f_type)) != kElsewhere.end();
}

bool isLoose(dev_t device) {
  return canBePulledOut("/sys/dev/block/" + std::to_string(major(device)) + ":" + std::to_string(minor(device)));
}

/// Where pages of a file could not take the place of `to`, whose own the system may have taken away before it said so: pages of the program
/// with the same values.
void restore(std::span<std::uint8_t> to, const void* values) {
  void* const again = ::mmap(to.data(), to.size(), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_FIXED, -1, 0);
  if (again != MAP_FAILED) std::memcpy(again, values, to.size());
}

/// @param to begins and ends with a page @return whether the file has the same there
bool restPiece(std::span<std::uint8_t> to, int file, std::uint64_t offset_bytes) {
  void* const there = ::mmap(nullptr, to.size(), PROT_READ | PROT_WRITE, MAP_PRIVATE, file, static_cast<off_t>(offset_bytes));
  if (there == MAP_FAILED) return false;
  const bool isSame = std::memcmp(there, to.data(), to.size()) == 0;
  if (!isSame || ::mremap(there, to.size(), to.size(), MREMAP_MAYMOVE | MREMAP_FIXED, to.data()) == MAP_FAILED) {
    if (isSame) restore(to, there);
    ::munmap(there, to.size());
    return false;
  }
  ::madvise(to.data(), to.size(), MADV_DONTNEED);  // of the file's pages, which were compared: they come back as they are asked for
  return true;
}

}  // namespace

std::uint64_t restInFile(std::span<std::uint8_t> values, const fs::path& file, std::uint64_t offset_bytes) {
  if (values.size() < kWorthwhile_bytes) return 0;
  const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  const auto address = reinterpret_cast<std::uintptr_t>(values.data());
  if (address % page != offset_bytes % page) return 0;
  const std::uint64_t ahead = (page - address % page) % page;
  const std::uint64_t resting = (values.size() - ahead) / page * page;
  const int opened = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (opened < 0) return 0;
  struct stat found {};
  const bool isWhole = ::fstat(opened, &found) == 0 && static_cast<std::uint64_t>(found.st_size) >= offset_bytes + values.size();
  std::uint64_t done = 0;
  if (isWhole && !isElsewhere(opened) && !isLoose(found.st_dev))
    while (done < resting) {
      const std::uint64_t size = std::min(kPiece_bytes, resting - done);
      if (!restPiece(values.subspan(ahead + done, size), opened, offset_bytes + ahead + done)) break;
      done += size;
    }
  ::close(opened);
  return done;
}

#else

std::uint64_t restInFile(std::span<std::uint8_t>, const fs::path&, std::uint64_t) { return 0; }

#endif

std::uint64_t restInVolumeFile(std::span<std::uint8_t> values, const fs::path& file) {
  using namespace detail;
  const auto header = readImageHeader(file);
  if (!header || header->packing != Packing::raw || header->type != SampleType::u8 || header->channels != 1 || header->dataAtEnd) return 0;
  return restInFile(values, header->dataFile, header->dataOffset + header->skipUnpacked);
}

}  // namespace ew
