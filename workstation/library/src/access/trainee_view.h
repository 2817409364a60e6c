#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/imaging/tissue_maps.h"
#include "ew/library/case.h"
#include "ew/library/lesson.h"

namespace ew {

/// The lessons as trainees of an examination have them, with what each was.
struct LessonsView {
  std::vector<Lesson> lessons;
  std::map<std::string, std::string> originalLessons;                       ///< by the view's id
  std::map<std::string, std::map<std::string, std::string>> originalSteps;  ///< by the view's ids
  std::set<std::string> images;                                             ///< that its texts show, relative to parts/lessons of the case
  std::size_t leftOut = 0;
};

/// The fields of a case that a trainee may read, each copied by its name; everything else is as in an empty Case. Volume, images, lessons
/// and sealed answers are not filled in.
/// @error badField (no title for trainees, a mannequin of the case's own)
[[nodiscard]] Result<Case> traineeView(const Case& original, const std::string& id);

/// @error badField (a step that scans another case), badUsage (nothing is asked)
[[nodiscard]] Result<LessonsView> traineeView(const std::vector<Lesson>& lessons);

/// A scene that says of tissues what sound does in them, and neither what they are nor more of where they are than sound tells: labels
/// whose acoustics are the same become one.
struct PlainTissues {
  Scene scene;
  std::array<std::uint8_t, 256> newLabel{};  ///< by the old one
  bool needsLabels = false;
};
/// @param whole with every tissue of the case (sceneWithTissues)
[[nodiscard]] PlainTissues plainTissues(const Scene& whole);

/// Maps whose surfaces say how they send sound back, and neither whose they are nor, but where that is seen, that they are several:
/// surfaces alike in everything but their name become one. Where two such lie side by side (voxels of both around one point) images show
/// a gap between them, so there they stay two. They come in the order of their properties, not of the patient's organs.
[[nodiscard]] TissueMaps plainSurfaces(TissueMaps maps);

}  // namespace ew
