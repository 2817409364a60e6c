#pragma once

#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/io/volume_file.h"

namespace ew::fuzz {

/// What a reader may take while it is fed with garbage.
inline constexpr ReaderLimits kSmall{64u << 20};

/// The bytes as a file of this ending, in memory where the system has a place for that; the same name every time.
inline std::filesystem::path asFile(const std::uint8_t* bytes, std::size_t size, const std::string& ending) {
  static const std::filesystem::path folder =
      std::filesystem::is_directory("/dev/shm") ? std::filesystem::path("/dev/shm") : std::filesystem::temp_directory_path();
  const auto file = folder / ("ew-fuzz-" + std::to_string(getpid()) + ending);
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  return file;
}

/// Stops the program: a broken promise is a finding.
inline void mustHold(bool promise) {
  if (!promise) std::abort();
}

/// What every refusal must be: a sentence, and never one of the kind that nobody foresaw.
inline void checkError(const Error& error) { mustHold(error.sentence().ends_with('.') && error.code != ErrorCode::internal); }

inline void checkVolume(const Volume& volume) {
  mustHold(checkGrid(volume.grid).has_value() && volume.echo.size() == volume.grid.voxelCount());
}

}  // namespace ew::fuzz
