#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/library/case_values.h"

namespace ew::stitching {

/// A case as it is with another volume.
struct CaseWithVolume {
  Case edited;
  bool hadRecipe = false;        ///< its patient was a recipe; else its volume was a file
  bool hadLabels = false;        ///< the volume before had labels; they do not fit to the new one and are not taken over
  bool hadFrames = false;        ///< the volume before had the recorded images it was made of, which are not those of the new one
  bool isMoved = false;          ///< the new volume lay elsewhere than the one before, and was moved to where that lay
  std::size_t targets = 0;       ///< left out: only the recipe, or the labels of the volume before, knew where they are
  std::size_t measurements = 0;  ///< the same of these
  std::vector<Error> problems;   ///< that stay
};

/// The volume that a case takes over.
struct VolumeForCase {
  std::string file;   ///< relative to the case's folder; it need not be there yet
  std::string level;  ///< the same of its level (imaging/tissue_level.h); empty: it has none
  /// Grids of the volume that the case has now and of the new one, each in the frame of its file. One that lies beside the other, under the
  /// place the case has, is of another recording: it is moved, without turning, until their middles agree. Empty: its place is right.
  std::optional<std::pair<Grid, Grid>> grids = {};
};

/// Attribution and licence stay, for they are somebody's word, and so do directions and place.
/// @param opened a case that is valid
/// @param check everything that is wrong with a case, with the "field" in its context (sdk::Cases::check)
[[nodiscard]] CaseWithVolume caseWithVolume(Case opened, const VolumeForCase& next,
                                            const std::function<std::vector<Error>(const Case&)>& check);

}  // namespace ew::stitching
