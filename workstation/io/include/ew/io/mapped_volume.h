#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/core/volume.h"

namespace ew {

struct MapOptions {
  /// Pages that the mapping may keep in memory before it gives them back (the system's file cache keeps them as long as it has room, so
  /// taking them up again is quick). What one slice touches between two looks comes on top.
  std::uint64_t residentBudget_bytes = 256ull << 20;
};

/// A volume that stays in its file: echo levels are read by the page as a slicer asks for them, whatever the size of the file. Reads as
/// one in memory does, pixel by pixel. Read-only; moving it keeps the voxels where they are.
///
/// The file must stay as it is. Other bytes written into it show up in the image; unchanged() tells. A file that is cut shorter takes the
/// pages away that are read next, which ends the program (SIGBUS): no file system offers a lock against that. Programs that replace
/// a file by renaming a new one onto it, as this one does, do no harm.
class MappedVolume {
 public:
  [[nodiscard]] VolumeView<const std::uint8_t> view() const;
  [[nodiscard]] const Grid& grid() const;
  /// What the reader had to decide, in sentences for the user.
  [[nodiscard]] const std::vector<Message>& notes() const;

  /// Success while the file has the size and the time of its last change that it had when it was mapped.
  /// @error notReadable
  [[nodiscard]] Result<void> unchanged() const;
  /// Gives all pages back now. Safe while someone reads: they come back as they are asked for.
  void release() const;

  ~MappedVolume();
  MappedVolume(MappedVolume&&) noexcept;
  MappedVolume& operator=(MappedVolume&&) noexcept;

 private:
  struct Mapping;
  explicit MappedVolume(std::unique_ptr<Mapping> mapping);
  friend Result<MappedVolume> mapVolume(const std::filesystem::path&, const MapOptions&);
  std::unique_ptr<Mapping> mapping_;
};

/// Maps the samples of an uncompressed .mha, .mhd + .raw, .nrrd, .nhdr + .raw or .nii of one 8 bit unsigned value a voxel. Header, grid and
/// length of the file are checked as readVolume checks them; more than 2^32 voxels are welcome.
/// @error as readVolume; unsupported (compressed, text, or other samples: these must be read), tooLarge (no room in the address space)
[[nodiscard]] Result<MappedVolume> mapVolume(const std::filesystem::path& file, const MapOptions& options = {});

/// Bytes of samples that mapVolume would map, 0 when the file cannot be mapped or its header cannot be read.
[[nodiscard]] std::uint64_t mappableBytes(const std::filesystem::path& file);

}  // namespace ew
