#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "ew/core/volume.h"
#include "ew/registration/deformation.h"
#include "ew/stitching/join.h"

namespace ew::stitching {

/// A rectangle through volumes: pixel (x, y) of w x h lies at centre + pixel_mm ((x - (w-1)/2) right + (y - (h-1)/2) down).
struct Plane {
  glm::dvec3 centre_mm{0.0};
  glm::dvec3 right{1.0, 0.0, 0.0};  ///< unit vectors, square to each other
  glm::dvec3 down{0.0, 1.0, 0.0};
  double pixel_mm = 0.5;
  [[nodiscard]] glm::dvec3 normal() const { return glm::cross(right, down); }
  bool operator==(const Plane&) const = default;
};

/// Axial is seen from the feet, coronal from the front, sagittal from the patient's left: the patient's left (or front) is right (or left).
enum class Cut { axial, coronal, sagittal };

[[nodiscard]] Plane planeOf(Cut cut, const glm::dvec3& centre_mm, double pixel_mm);
[[nodiscard]] glm::dvec3 pointAt(const Plane& plane, const glm::ivec2& size, const glm::dvec2& pixel);
/// The foot of a point on the plane, as a pixel; `distanceTo` says how far the point lies off it.
[[nodiscard]] glm::dvec2 pixelOf(const Plane& plane, const glm::ivec2& size, const glm::dvec3& p_mm);
[[nodiscard]] double distanceTo(const Plane& plane, const glm::dvec3& p_mm);
/// The plane as seen in another frame.
template <class To, class From>
[[nodiscard]] Plane moved(const Plane& plane, const Transform<To, From>& rigid) {
  const glm::dmat3 turn(rigid.matrix);
  return {carried(rigid, plane.centre_mm), turn * plane.right, turn * plane.down, plane.pixel_mm};
}
/// Turned about a point of it (and so still through it): first about its own `down`, then about `right`, then about the normal.
[[nodiscard]] Plane turned(const Plane& plane, const glm::dvec3& about_mm, const glm::dvec3& rotation_deg);

/// How a point of the plane's frame, which is that of a pair's fixed volume, goes over into a volume's own: toGrid * (b + u(b)) with
/// b = toWarp * p. Where nothing warps, the fixed volume's frame may stand for the world; as it is made, all frames are one.
struct Mapping {
  Transform<frame::World, frame::Fixed> toWarp = {};
  const registration::ControlGrid* warp = nullptr;  ///< null: none
  Transform<frame::View, frame::World> toGrid = {};
  [[nodiscard]] glm::dvec3 operator()(const glm::dvec3& p_mm) const;
  [[nodiscard]] Transform<frame::View, frame::Fixed> withoutWarp() const { return toGrid * toWarp; }
};

struct GreySlice {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> grey;  ///< row by row, 0 where nothing was seen
  std::vector<std::uint8_t> seen;  ///< 1 where the volume covers the pixel
  bool operator==(const GreySlice&) const = default;
};
struct ColourSlice {
  glm::ivec2 size{0};
  std::vector<std::array<std::uint8_t, 3>> rgb;  ///< row by row
  bool operator==(const ColourSlice&) const = default;
};

/// The volume in the plane, by levelsAt of imaging: nothing outside the grid and where the nearest voxel is absent. Constants and ramps
/// are exact; voxel centres give their voxels.
[[nodiscard]] GreySlice sliced(const Volume& volume, const Plane& plane, const glm::ivec2& size, const Mapping& mapping);

enum class Overlay {
  checkerboard,  ///< fixed and moving in turn, in squares
  difference,    ///< moving minus fixed, halved, about middle grey
  flicker,       ///< one, then the other
  colours        ///< fixed green, moving magenta: grey where they agree
};
struct OverlayOptions {
  Overlay kind = Overlay::checkerboard;
  int square_px = 48;   ///< of the checkerboard
  bool second = false;  ///< of the flicker: show the moving one
};
/// Two images of one size over each other. Where only one of them sees anything, it is shown alone at half its brightness (flicker: as it
/// is, because there the eye compares); where neither does, black.
[[nodiscard]] ColourSlice overlaid(const GreySlice& fixed, const GreySlice& moving, const OverlayOptions& options);

/// A colour for a length from 0 to `longest_mm`: dark blue, teal, yellow; its brightness rises all the way, so it reads without colour too.
[[nodiscard]] std::array<std::uint8_t, 3> colourOfLength(double length_mm, double longest_mm);

/// Where `displaced` takes the lines of a square lattice around the plane's middle, in pixels; each with a point every quarter of a
/// square. Without any displacement they are straight and `spacing_mm` apart.
[[nodiscard]] std::vector<std::vector<glm::dvec2>> deformedLattice(const Plane& plane, const glm::ivec2& size, double spacing_mm,
                                                                   const std::function<glm::dvec3(const glm::dvec3&)>& displaced);

/// A view in the world, for images of the whole.
struct WorldView {
  const Volume* volume = nullptr;  ///< null: not read yet, shows nothing
  Mapping fromPlane;
};
/// Each pixel from the view that the seam map gives it, tinted with that view's colour, borders between views drawn bright.
[[nodiscard]] ColourSlice seamImage(const SeamMap& seams, std::span<const WorldView> views, const Plane& plane, const glm::ivec2& size,
                                    const Transform<frame::World, frame::Fixed>& planeToWorld);
/// Index of the view at a world point, or -1.
[[nodiscard]] int viewAt(const SeamMap& seams, const glm::dvec3& p_world_mm);
/// The colour in which a view is shown, everywhere the same; eight of them, then from the beginning.
[[nodiscard]] std::array<std::uint8_t, 3> colourOfView(std::size_t view);

/// The moving volume moved within the fixed frame: shifted by `shift_mm`, after a turn about `pivot_mm` (axis times degrees, fixed frame).
[[nodiscard]] Transform<frame::Moving, frame::Fixed> nudged(const Transform<frame::Moving, frame::Fixed>& fixedToMoving,
                                                            const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg,
                                                            const glm::dvec3& pivot_mm);
/// The rigid motion of such a nudge, in the frame in which it happens: the fixed volume's, or the world.
template <class Frame>
[[nodiscard]] Transform<Frame, Frame> motionOf(const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg, const glm::dvec3& pivot_mm);

/// Plain correlation of grey levels over what both cover, on a lattice of `step_mm` in the fixed volume; none below 200 common points.
/// For a hand that nudges: a figure that moves at once. Not a verdict.
struct QuickAgreement {
  double correlation = 0.0;
  double overlapShare = 0.0;  ///< of the fixed volume's covered points
  std::size_t points = 0;
};
[[nodiscard]] QuickAgreement quickAgreement(const Volume& fixed, const Volume& moving,
                                            const Transform<frame::Moving, frame::Fixed>& fixedToMoving, double step_mm);

}  // namespace ew::stitching
