#pragma once

#include <optional>
#include <vector>

#include "cells.h"

namespace ew::stitching {

/// What one view shows, cell by cell, within the box that it can reach. Speckle is averaged out.
struct ViewSurvey {
  static constexpr double kLevelUnit = 1.0 / 128.0;
  static constexpr double kFull = 255.0;

  CellBox box;
  std::vector<std::uint16_t> level;  ///< local mean, kLevelUnit grey levels
  std::vector<std::uint8_t> share;   ///< of the cell that the view covers, kFull for all
  std::vector<std::uint8_t> trust;   ///< kFull where it saw well

  [[nodiscard]] bool covers(std::size_t cell) const { return share[cell] > 0; }
  [[nodiscard]] std::optional<double> levelAt(int i, int j, int k) const {
    if (!box.contains(i, j, k)) return std::nullopt;
    const std::size_t cell = box.indexOf(i, j, k);
    if (!covers(cell)) return std::nullopt;
    return level[cell] * kLevelUnit;
  }
  /// Of each cell of the box, at least half of which is covered. @error cancelled
  [[nodiscard]] Result<std::vector<float>> distanceFromBorder_mm(const Grid& cells, double limit_mm, int threads, Progress& progress) const;
};

/// @error cancelled
[[nodiscard]] Result<std::vector<ViewSurvey>> surveyViews(std::span<const View> views, const Grid& result, const glm::ivec3& ratio,
                                                          const SeamOptions& options, Progress& progress);

}  // namespace ew::stitching
