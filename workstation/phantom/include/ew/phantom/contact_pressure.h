#pragma once

#include <vector>

#include "ew/core/frames.h"
#include "ew/imaging/probe.h"
#include "ew/phantom/deformation.h"

namespace ew {

/// Tissue pushed in by a probe's face. The face moves what it touches with it, along its central beam; below it the push fades with depth
/// as under a flat round punch on an incompressible elastic half space,
///   D(d) = 2/pi (atan(a / d) + a d / (a^2 + d^2)),
/// d the depth below the resting skin, a the radius of a punch as large as the touched area. To the sides it fades where the face no longer
/// reaches, over a width that grows with depth. The skin at rest is where the gaps below the face say, else a plane square to the central
/// beam.
/// Source: Johnson, Contact Mechanics, 1985, section 3.6 (pressure under a rigid punch, integrated along the axis with Boussinesq's
/// solution). Ours differs: tissue moves along the beam alone, so volume is not kept.
/// Along the beam the mapping's derivative is at least 1 - indentation / (pi a), so it is one to one below the deepest indentation.
class ContactPressure final : public Deformation {
 public:
  /// @param probeToWorld   where the face is, pressed in
  /// @param indentation_mm 0..deepestIndentation_mm(probe)
  /// @param gaps_mm        how far each of evenly spaced points of the face (facePoints_mm of as many) was from the resting skin, along the
  ///                       central beam, when the face first touched it; each >= 0. Empty: of a plane
  ContactPressure(const Probe& probe, const Transform<frame::World, frame::Probe>& probeToWorld, double indentation_mm,
                  std::vector<double> gaps_mm = {});
  [[nodiscard]] glm::dvec3 moved(const glm::dvec3& rest_mm) const override;
  [[nodiscard]] glm::dvec3 rest(const glm::dvec3& moved_mm) const override;
  [[nodiscard]] double reach_mm() const override { return indentation_mm_; }

 private:
  [[nodiscard]] double gap_mm(double x_mm) const;
  [[nodiscard]] double faceY_mm(double x_mm) const;
  [[nodiscard]] double push_mm(const glm::dvec3& rest_probe_mm) const;

  Transform<frame::World, frame::Probe> probeToWorld_;
  Transform<frame::Probe, frame::World> worldToProbe_;
  double indentation_mm_;
  double faceHalfWidth_mm_;
  double faceHalfHeight_mm_;
  double faceRadius_mm_;   // 0: a straight face
  double punchRadius_mm_;  // a
  std::vector<double> gaps_mm_;
};

/// The deepest indentation a probe may press: beyond it tissue would be squeezed to less than a fifth of its thickness.
[[nodiscard]] double deepestIndentation_mm(const Probe& probe);

}  // namespace ew
