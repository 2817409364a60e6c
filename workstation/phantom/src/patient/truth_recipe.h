#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/word_table.h"
#include "ew/phantom/truth.h"
#include "patient/recipe.h"

namespace ew::phantom {

enum class MeasurementKind { distance, diameter, extent, circumference, volume };
inline constexpr WordTable<MeasurementKind, 5> kMeasurementKindWords{{{"distance", MeasurementKind::distance},
                                                                      {"diameter", MeasurementKind::diameter},
                                                                      {"extent", MeasurementKind::extent},
                                                                      {"circumference", MeasurementKind::circumference},
                                                                      {"volume", MeasurementKind::volume}}};
/// Where along a tube's centre line its diameter is taken.
enum class TubePlace { given, largest, smallest };

/// One entry of "measurements". Places are those of the resting body.
struct MeasurementRequest {
  std::string name;
  MeasurementKind kind = MeasurementKind::distance;
  std::string plane;
  std::vector<std::string> of;      ///< shapes or organs; of several, all together
  std::string fromSurface;          ///< distance: the first crossing of this one's surface on the way from `from_mm` ...
  std::string toSurface;            ///< ... to the last crossing of this one's
  std::vector<std::string> gap;     ///< distance: from where the first of the two is left to where the second is entered
  std::optional<glm::dvec3> at_mm;  ///< diameter: near the place on the centre line, or the middle; circumference: inside the section
  std::optional<glm::dvec3> from_mm;
  std::optional<glm::dvec3> to_mm;
  glm::dvec3 direction{0.0, 1.0, 0.0};  ///< diameter, extent: unit; circumference: the section's normal
  TubePlace place = TubePlace::given;
};

[[nodiscard]] std::vector<MeasurementRequest> readMeasurements(const JsonFields& recipe, const ShapesByName& shapes,
                                                               const std::vector<StandardPlane>& planes);

/// The planes with their faces put on the skin; some are missing after the wish to cancel.
[[nodiscard]] std::vector<StandardPlane> readPlanes(const JsonFields& recipe, const ShapePtr& skin, const ShapesByName& shapes,
                                                    Progress& progress);

}  // namespace ew::phantom
