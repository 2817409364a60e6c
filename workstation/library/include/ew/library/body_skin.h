#pragma once

#include <filesystem>
#include <memory>

#include "ew/core/result.h"
#include "ew/tracking/hand.h"

namespace ew {

/// The surface of a mannequin's recipe itself as a skin to slide on, without a mesh: for hands that nobody sees. Points are on the surface
/// within 0.01 mm; normals are those of the body's distance smoothed over about half of a probe's face.
/// @param recipe resources/mannequin/NAME.json
/// @error as readBodyShape
[[nodiscard]] Result<std::shared_ptr<const Skin>> readBodySkin(const std::filesystem::path& recipe);

}  // namespace ew
