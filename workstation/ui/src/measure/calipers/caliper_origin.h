#pragma once

#include <QString>

#include "measure/calipers/calipers.h"

namespace ew::ui {

/// Where the uncertainty of a caliper comes from: pixel, and the beam at its points; of a strip columns, beams and rows. And what became
/// of its echoes.
[[nodiscard]] QString howItCameAbout(const Calipers::Line& line);

}  // namespace ew::ui
