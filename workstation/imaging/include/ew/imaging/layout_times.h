#pragma once

#include <array>

#include "ew/imaging/slice_source.h"

namespace ew {

/// Times of the same slices from either layout, one thread, 200 x 140 pixels.
struct LayoutPair {
  double rows_us = 0.0;
  double bricks_us = 0.0;
  [[nodiscard]] bool choosesBricks() const { return bricks_us < rows_us; }
  [[nodiscard]] double chosen_us() const { return choosesBricks() ? bricks_us : rows_us; }
  bool operator==(const LayoutPair&) const = default;
};

/// What slices of a volume cost, on the machine, with the instruction set and beside the neighbours they were timed with.
struct LayoutTimes {
  std::array<LayoutPair, SliceClass::kCount> ofClass;  ///< by SliceClass::index; geometric means over directions of the class
  /// For each class the layout of its pair.
  [[nodiscard]] LayoutChoice choice() const;
  /// Geometric mean over all classes.
  [[nodiscard]] LayoutPair mean() const;
  /// Geometric mean of what is chosen.
  [[nodiscard]] double chosen_us() const;
  bool operator==(const LayoutTimes&) const = default;
};

/// Times both in turns, for about 0.15 s of the calling thread.
/// @param bricks made of `volume`
[[nodiscard]] LayoutTimes timeLayouts(const VolumeView<const std::uint8_t>& volume, const BrickVolume& bricks);

}  // namespace ew
