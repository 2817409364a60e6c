#pragma once

#include <array>
#include <glm/glm.hpp>
#include <iosfwd>

#include "ew/core/result.h"

namespace ew {

/// The coordinate frames of the program. A frame is a type, so a product in the wrong order does not compile.
namespace frame {
struct Image {};  ///< centre of the first pixel; x lateral towards the marker, y axial away from the probe, z = x × y; pixel
struct Probe {};  ///< centre of the transducer face; x lateral, y axial, z = x × y (elevational); mm
struct Voxel {};  ///< centre of voxel (0, 0, 0); i varies fastest in memory, then j, k; voxel
struct World {};  ///< origin of the case (or of a volume's own file, before it is placed); patient left, posterior, superior (LPS); mm

// A volume's own file, before it is placed, by the part the volume plays: origin and axes are those the file states (LPS); mm.
struct File {};    ///< of a case's volume
struct View {};    ///< of a subvolume, one of those that become a mosaic
struct Fixed {};   ///< of the volume of a pair that stays; points, centres and warps of a registration are given here
struct Moving {};  ///< of the volume of a pair that is looked for

struct Placed {};  ///< as World, where a stitch project puts its subvolumes before matching moves them; mm
}  // namespace frame

/// Takes coordinates in From and gives coordinates in To: a 4 x 4 matrix on the left of a column vector.
template <class To, class From>
struct Transform {
  glm::dmat4 matrix{1.0};
  bool operator==(const Transform&) const = default;
};

template <class Frame>
struct Point {
  glm::dvec3 at{0.0};
  bool operator==(const Point&) const = default;
};

/// A displacement or direction; the translation of a transform does not move it.
template <class Frame>
struct Direction {
  glm::dvec3 along{0.0};
  bool operator==(const Direction&) const = default;
};

template <class C, class B, class A>
Transform<C, A> operator*(const Transform<C, B>& bToC, const Transform<B, A>& aToB) {
  return {bToC.matrix * aToB.matrix};
}
template <class B, class A>
Point<B> operator*(const Transform<B, A>& aToB, const Point<A>& p_a) {
  return {glm::dvec3(aToB.matrix * glm::dvec4(p_a.at, 1.0))};
}
template <class B, class A>
Direction<B> operator*(const Transform<B, A>& aToB, const Direction<A>& d_a) {
  return {glm::dvec3(aToB.matrix * glm::dvec4(d_a.along, 0.0))};
}
template <class B, class A>
Transform<A, B> inverse(const Transform<B, A>& aToB) {
  return {glm::inverse(aToB.matrix)};
}
/// Of a rotation and a translation: exact in the rotation.
template <class B, class A>
Transform<A, B> rigidInverse(const Transform<B, A>& aToB) {
  const glm::dmat3 back = glm::transpose(glm::dmat3(aToB.matrix));
  Transform<A, B> bToA{glm::dmat4(back)};
  bToA.matrix[3] = glm::dvec4(-(back * glm::dvec3(aToB.matrix[3])), 1.0);
  return bToA;
}

/// Where a transform takes a point whose frame its name alone says.
template <class B, class A>
glm::dvec3 carried(const Transform<B, A>& aToB, const glm::dvec3& p_a) {
  return (aToB * Point<A>{p_a}).at;
}

/// The same numbers between frames of other names, where a frame plays another's part: a view as the fixed volume of a pair. The compiler
/// cannot check the claim, so each use is one to look at.
template <class To, class From, class OldTo, class OldFrom>
Transform<To, From> renamed(const Transform<OldTo, OldFrom>& t) {
  return {t.matrix};
}

/// Sixteen numbers in the order people write matrices in (row major), as in files and on the command line.
glm::dmat4 matrixFromRows(const std::array<double, 16>& rowMajor);
std::array<double, 16> rowsOf(const glm::dmat4& matrix);
template <class To, class From>
std::array<double, 16> rowsOf(const Transform<To, From>& t) {
  return rowsOf(t.matrix);
}

/// Why a matrix cannot be the pose of a rigid body, or success.
/// @error notRigid when an entry is not finite, the last row is not 0 0 0 1, an axis is not of unit length or two are not
///        orthogonal within `tolerance`, or the frame is mirrored (determinant below 0). Nothing is repaired.
[[nodiscard]] Result<void> checkRigid(const glm::dmat4& matrix, double tolerance = 1e-3);
template <class To, class From>
[[nodiscard]] Result<void> checkRigid(const Transform<To, From>& t, double tolerance = 1e-3) {
  return checkRigid(t.matrix, tolerance);
}

std::ostream& printMatrix(std::ostream& out, const glm::dmat4& matrix);
template <class To, class From>
std::ostream& operator<<(std::ostream& out, const Transform<To, From>& t) {
  return printMatrix(out, t.matrix);
}

}  // namespace ew
