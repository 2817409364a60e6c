#include "kept_layouts.h"

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "ew/core/simd.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

constexpr const char* kFile = "layouts.json";
// 1: one pair of times for all slices, 2: all slices about the middle of the volume. Another number whenever the classes of slices or what
// is timed for them change.
constexpr int kFormat = 3;

nlohmann::json readKept(const std::filesystem::path& folder) {
  return readJsonFile(folder / kFile, verbatim(kFile), 1u << 16).value_or(nlohmann::json::object());
}

/// A processor, the instruction set in use, and the power of two of the bytes.
std::string keyOf(std::uint64_t volume_bytes) {
  return processorName() + ", " + simdInUse() + ", 2^" + std::to_string(std::bit_width(volume_bytes)) + " bytes";
}

}  // namespace

std::optional<LayoutTimes> readLayoutTimes(const std::filesystem::path& folder, std::uint64_t volume_bytes) {
  const nlohmann::json kept = readKept(folder);
  const auto found = kept.find(keyOf(volume_bytes));
  if (found == kept.end() || !found->is_object()) return std::nullopt;
  const auto format = found->find("format");
  if (format == found->end() || *format != kFormat) return std::nullopt;
  LayoutTimes times;
  const auto read = [&](const char* name, double LayoutPair::*time_us) {
    const auto values = found->find(name);
    if (values == found->end() || !values->is_array() || values->size() != times.ofClass.size()) return false;
    for (std::size_t n = 0; n < times.ofClass.size(); ++n) {
      const nlohmann::json& value = (*values)[n];
      times.ofClass[n].*time_us = value.is_number() ? value.get<double>() : 0.0;
      if (!std::isfinite(times.ofClass[n].*time_us) || times.ofClass[n].*time_us <= 0.0) return false;
    }
    return true;
  };
  if (!read("rows_us", &LayoutPair::rows_us) || !read("bricks_us", &LayoutPair::bricks_us)) return std::nullopt;
  return times;
}

void keepLayoutTimes(const std::filesystem::path& folder, std::uint64_t volume_bytes, const LayoutTimes& times) {
  nlohmann::json kept = readKept(folder);
  nlohmann::json& entry = kept[keyOf(volume_bytes)] = {{"format", kFormat}};
  for (const LayoutPair& pair : times.ofClass) {
    entry["rows_us"].push_back(pair.rows_us);
    entry["bricks_us"].push_back(pair.bricks_us);
  }
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  static_cast<void>(writeFileSafely(folder / kFile, kept.dump(2) + "\n"));
}

}  // namespace ew
