#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/image_header.h"

namespace ew::detail {

/// A vector "(a,b,c)" of `space directions`, or empty for "none".
using NrrdDirection = std::optional<std::vector<double>>;

/// What a NRRD header says of its axes beside their kinds, in the order of the file.
struct NrrdAxes {
  std::vector<std::string> units;                        ///< of each axis, "" of one without; empty: the file has none axis by axis
  std::vector<double> spacings;                          ///< NaN of an axis without one; empty: the file has none
  std::optional<std::vector<NrrdDirection>> directions;  ///< one an axis
};

/// Finds the axis of time of a header that need not name it by a kind, and enters it as "time" in `header.kinds`: an axis is one of time by
/// its kind (time, list), by a unit of time, or because it alone of four has no spacing (NaN) or no direction (none, or one along time).
/// @return the axis with a unit of time, whose spacing is therefore no length; empty: there is none
/// @error badField (hints that contradict each other; the sentence names both)
[[nodiscard]] Result<std::optional<std::size_t>> settleTimeAxis(ImageHeader& header, const NrrdAxes& axes);

}  // namespace ew::detail
