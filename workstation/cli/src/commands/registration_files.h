#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/registration/deformation.h"
#include "ew/registration/landmarks.h"

namespace ew::cli {

/// `--start T.txt`: sixteen numbers, row major, on as many lines as one likes; what follows a # is skipped.
/// @error notFound, notReadable, badField (not sixteen numbers), notRigid
[[nodiscard]] Result<Transform<frame::Moving, frame::Fixed>> readTransform(const std::filesystem::path& file);
/// Four rows of four numbers, each the shortest that reads back the same.
[[nodiscard]] std::string transformText(const Transform<frame::Moving, frame::Fixed>& fixedToMoving);

/// `--landmarks L.json`: {"landmarks": [{"name": "…", "fixed_mm": [x, y, z], "moving_mm": [x, y, z]}, …], "pick_error_mm": 1}; the pairs of
/// a stitching project have the same form. A pair without a name is called by its number.
struct LandmarkFile {
  std::vector<registration::LandmarkPair> pairs;
  std::optional<double> pickError_mm;
};
/// @error notFound, notReadable, tooLarge, badHeader (no JSON), badField (the field named)
[[nodiscard]] Result<LandmarkFile> readLandmarks(const std::filesystem::path& file);

/// Writes `--field` slice by slice: fixed point + displacement = moving point, the rigid part included. A grid of one slice gives a
/// two-dimensional file when `flat`.
[[nodiscard]] Result<void> writeField(const registration::Deformation& fixedToMoving, const Grid& fixed, bool flat,
                                      const std::filesystem::path& file, int threads, Progress& progress);

}  // namespace ew::cli
