#pragma once

#include <glm/glm.hpp>
#include <optional>

namespace ew {

/// How the beams of a view run, in mm of its own frame.
struct Beams {
  /// The way that the apex of a fan went while it was swept: through a point runs the beam from the nearest place of that way. Equal ends:
  /// one apex for all.
  struct Fan {
    glm::dvec3 from_mm{0.0};
    glm::dvec3 to_mm{0.0};
    [[nodiscard]] glm::dvec3 apexFor(const glm::dvec3& p_mm) const;
    bool operator==(const Fan&) const = default;
  };
  glm::dvec3 direction{0.0};    ///< of the middle beam, of any length above 0
  std::optional<Fan> fan = {};  ///< none: all beams run along `direction`
  /// The beam at a point, of length 1; at the apex itself the middle one.
  [[nodiscard]] glm::dvec3 at(const glm::dvec3& p_mm) const;
  /// How far along its beam a point lies, mm: from the apex of a fan, else along `direction` from the frame's origin.
  [[nodiscard]] double depth_mm(const glm::dvec3& p_mm) const;
  bool operator==(const Beams&) const = default;
};

}  // namespace ew
