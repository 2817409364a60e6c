#pragma once

#include <glm/glm.hpp>

#include "echoes/echo_motion.h"
#include "ew/imaging/frame.h"

namespace ew::detail {

/// How fast what is seen moves past the probe: by the body itself and because the probe was moved, as the difference to the frame before.
class RelativeMotion {
 public:
  /// @param motion of the image's echoes; null: tissue rests where its maps show it
  /// @param before where probe and body stood in the frame before
  void take(const FrameInput& input, const Scene& scene, const EchoMotion* motion, const FrameBefore& before,
            const Transform<frame::Probe, frame::World>& ownToProbe);
  /// Whether at() is not the same everywhere: nothing.
  [[nodiscard]] bool moves() const { return moves_; }
  struct At {
    glm::vec3 back_mm{0.0F};          ///< place at rest - place now
    glm::vec3 velocity_mmPerS{0.0F};  ///< of what is there now, seen from the probe
  };
  /// @param now_mm in the probe frame; @param guess of back_mm, that of a neighbour
  [[nodiscard]] At at(const glm::dvec3& now_mm, const glm::vec3& guess = glm::vec3(0.0F)) const;

 private:
  const EchoMotion* motion_ = nullptr;  ///< null: nothing gave way
  EchoMotion body_, bodyBefore_;        ///< without what gives way to the face
  glm::dmat4 toBefore_{1.0};            ///< from the probe frame to that of the frame before
  bool moves_ = false, bodyMoves_ = false, probeMoves_ = false;
  float perS_ = 0.0F;
};

/// What the next frame has to know of this one.
[[nodiscard]] inline FrameBefore frameBeforeOf(const FrameInput& input) { return {true, input.pose, input.body, input.time_s}; }

}  // namespace ew::detail
