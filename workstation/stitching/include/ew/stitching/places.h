#pragma once

#include "ew/core/frames.h"

namespace ew::stitching {

/// Of a pair as its views are placed: here one of them becomes the fixed, the other the moving volume.
[[nodiscard]] inline Transform<frame::Moving, frame::Fixed> fixedToMovingOf(const Transform<frame::World, frame::View>& fixedView,
                                                                            const Transform<frame::World, frame::View>& movingView) {
  const auto fixedToWorld = renamed<frame::World, frame::Fixed>(fixedView);
  const auto movingToWorld = renamed<frame::World, frame::Moving>(movingView);
  return rigidInverse(movingToWorld) * fixedToWorld;
}

/// Of the same pair with its volumes in the other roles.
[[nodiscard]] inline Transform<frame::Moving, frame::Fixed> withRolesSwapped(const Transform<frame::Moving, frame::Fixed>& fixedToMoving) {
  return renamed<frame::Moving, frame::Fixed>(rigidInverse(fixedToMoving));
}

}  // namespace ew::stitching
