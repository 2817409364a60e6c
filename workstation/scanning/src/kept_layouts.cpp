#include "kept_layouts.h"

#include <bit>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "ew/core/json_fields.h"
#include "ew/core/simd.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

constexpr const char* kFile = "layouts.json";

nlohmann::json readKept(const std::filesystem::path& folder) {
  const auto text = readTextFile(folder / kFile, 1u << 16);
  if (!text) return nlohmann::json::object();
  auto kept = parseJson(*text, verbatim(kFile));
  return kept && kept->is_object() ? *kept : nlohmann::json::object();
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
  const auto time_us = [&](const char* name) {
    const auto value = found->find(name);
    return value != found->end() && value->is_number() ? value->get<double>() : 0.0;
  };
  const LayoutTimes times{time_us("rows_us"), time_us("bricks_us")};
  if (!std::isfinite(times.rows_us) || !std::isfinite(times.bricks_us) || times.rows_us <= 0.0 || times.bricks_us <= 0.0)
    return std::nullopt;
  return times;
}

void keepLayoutTimes(const std::filesystem::path& folder, std::uint64_t volume_bytes, const LayoutTimes& times) {
  nlohmann::json kept = readKept(folder);
  kept[keyOf(volume_bytes)] = {{"rows_us", times.rows_us}, {"bricks_us", times.bricks_us}};
  std::error_code ignored;
  std::filesystem::create_directories(folder, ignored);
  static_cast<void>(writeFileSafely(folder / kFile, kept.dump(2) + "\n"));
}

}  // namespace ew
