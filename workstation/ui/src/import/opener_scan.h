#pragma once

#include <QString>

#include "ew/core/volume.h"
#include "ew/tracking/hand.h"

namespace ew::ui {

/// Topic of what opening something has to say.
[[nodiscard]] QString openingTopic();
[[nodiscard]] glm::dvec3 centreOf(const Grid& grid);
/// Where the skin lies in front of a point in mm, seen from the front.
[[nodiscard]] Skin::Contact skinInFrontOf(const Skin& skin, const glm::dvec3& p_mm);

}  // namespace ew::ui
