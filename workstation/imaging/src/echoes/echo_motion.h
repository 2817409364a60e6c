#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "echo_layout.h"
#include "ew/imaging/bands.h"
#include "ew/imaging/slice_source.h"
#include "ew/imaging/tissue_motion.h"

namespace ew::detail {

// Of tissue that gives way to a face, which EchoMotion::press tells.
inline constexpr double kFarthestSkin_mm = 12.0;  ///< below the skin; a face that stands deeper presses no more
inline constexpr double kGives_mm = 35.0;

/// Where the tissue of a frame has gone: forward for scatterers, which take their place with them, and backward for lines, which ask at
/// each of their samples what rests there. Everything in the probe frame; "at rest" is where tissue would lie in a body at rest.
class EchoMotion {
 public:
  /// What a layout says of the nodes at which tissue gives way to its face.
  void configure(const EchoLayout& layout);
  /// From here on nothing moves.
  void rest() {
    fields_.clear();
    deepest_mm_ = pressedTo_mm_ = 0.0F;
  }
  /// @param motionToProbe from the frame of the motion's grids, rigid
  /// @param strength of every field, 0..1
  void take(const TissueMotion& motion, const BodyState& body, double strength, const Transform<frame::Probe, frame::World>& motionToProbe);
  /// Tissue gives way to the face that presses into it: along each line the skin comes to lie on the face, and what is below it moves as
  ///   p exp(-(s / S)^2),  p how far the face stands below the skin there, s the depth below the skin at rest, S kGives_mm,
  /// so that layers near the face follow its curve and get thinner. Skin up to kGel_mm in front of a face comes to it with the gel. The
  /// formula is ours; layers of the abdominal wall that follow a curved face as in recorded sweeps are the aim.
  /// @param level of tissue, 0 where none is
  void press(const EchoLayout& layout, const SliceSource& level, const Transform<frame::Voxel, frame::Probe>& probeToVoxel);
  /// Of what was taken since rest(): where all of it has gone, along the lines.
  void find(const EchoLayout& layout, Bands& bands);
  [[nodiscard]] bool moves() const { return !fields_.empty(); }
  /// Whether anything may move that deep or deeper.
  [[nodiscard]] bool movesFrom(double depth_mm) const { return moves() && depth_mm < static_cast<double>(deepest_mm_); }
  /// Whether tissue gives way to the face there.
  [[nodiscard]] bool isPressed(float depth_mm) const { return depth_mm < pressedTo_mm_; }

  /// How far what rests at a place has gone, mm.
  [[nodiscard]] glm::vec3 shiftAt(const glm::vec3& rest_mm) const;

  /// (place at rest - place now) at a place of now, mm. @param guess of it, that of a neighbour
  [[nodiscard]] glm::vec3 backAt(const glm::vec3& now_mm, const glm::vec3& guess) const;

  /// Bounds of (place at rest - place now) of what is seen between two ranges, mm.
  struct Reach {
    glm::dvec3 least_mm{0.0};
    glm::dvec3 most_mm{0.0};
  };
  [[nodiscard]] Reach reachBetween(double near_mm, double far_mm) const;

  /// (place at rest - place now) along all lines, `sigmas` standard deviations of the elevational beam beside the slice, -1..1.
  /// @param toVoxel takes mm of the probe frame to steps of a volume
  /// @param rows    knot after knot, by line; knots lie knot_mm() apart from range 0 on
  void rowsOf(double sigmas, const glm::mat3& toVoxel, Bands& bands, std::vector<glm::vec3>& rows) const;
  [[nodiscard]] double knot_mm() const { return knot_mm_; }
  /// Of rowsOf, the two around a range.
  struct RowsAround {
    const glm::vec3* near = nullptr;  ///< by line; null: nothing moves there
    const glm::vec3* next = nullptr;
    float part = 0.0F;  ///< of the way to the next
    [[nodiscard]] glm::vec3 at(int line) const { return near[line] + part * (next[line] - near[line]); }
  };
  /// Of rowsOf, as vector code reads them.
  struct Rows {
    const glm::vec3* first = nullptr;  ///< null: nothing moves
    int lines = 0, knots = 0;
    float perKnot = 0.0F;     ///< of a mm
    float deepest_mm = 0.0F;  ///< from there on nothing moves
  };
  [[nodiscard]] Rows asRows(const std::vector<glm::vec3>& rows) const {
    return moves() ? Rows{rows.data(), lines_, knots_, perKnot_, deepest_mm_} : Rows{};
  }
  [[nodiscard]] RowsAround rowsAround(const std::vector<glm::vec3>& rows, float range_mm) const {
    if (!moves() || range_mm >= deepest_mm_) return {};
    const float at = range_mm * perKnot_;
    const int knot = std::min(static_cast<int>(at), knots_ - 2);
    const glm::vec3* near = rows.data() + static_cast<std::ptrdiff_t>(knot) * lines_;
    return {near, near + lines_, at - static_cast<float>(knot)};
  }
  [[nodiscard]] glm::vec3 backOn(const std::vector<glm::vec3>& rows, int line, float range_mm) const {
    const RowsAround around = rowsAround(rows, range_mm);
    return around.near == nullptr ? glm::vec3(0.0F) : around.at(line);
  }

 private:
  /// A field of the motion as it stands.
  struct Field {
    bool isEverywhere;  ///< else at rest beyond its grid
    glm::mat3 probeToNode;
    glm::vec3 nodeOfProbe;  ///< where its origin lies
    glm::mat3 toProbe;      ///< amplitude included
    glm::vec3 last;         ///< node
    std::ptrdiff_t row, plane;
    const glm::vec3* shift;
  };
  [[nodiscard]] const glm::vec3& nodeAt(int side, int knot, int column) const {
    return nodes_[static_cast<std::size_t>((side * knots_ + knot) * columns_ + column)];
  }

  /// Of press(): a node's place in front of the face.
  struct FaceNode {
    int place = 0;      ///< along the face, the lower of two
    double part = 0.0;  ///< of the way to the next
    double depth_mm = 0.0;
    glm::dvec2 direction{0.0};
  };

  std::vector<Field> fields_;
  std::vector<FaceNode> faceNodes_;  ///< of one of the two planes of nodes, row after row
  glm::ivec3 faceDims_{0};
  glm::dvec2 faceOrigin_mm_{0.0};   ///< the first node
  std::vector<glm::vec3> pressed_;  ///< shifts at the nodes of press()
  float deepest_mm_ = 0.0F;         ///< from there on nothing moves
  float pressedTo_mm_ = 0.0F;       ///< the same of press() alone
  double knot_mm_ = 4.0;
  float perKnot_ = 0.25F;
  int knots_ = 0;
  int columns_ = 0;  ///< of nodes, evenly across the lines
  int lines_ = 0;
  double reach_ = 2.0;            ///< of the elevational beam, in standard deviations
  std::vector<glm::vec3> nodes_;  ///< two sides of the slice, one standard deviation off; by knot, by column
};

/// How far the blocks of a lattice have gone, between nodes a few blocks apart of which each is asked once.
class BlockShifts {
 public:
  /// @param place of the lattice; @param first, last blocks along i, j, k
  void begin(const EchoMotion& motion, const glm::dmat4& cellToProbe, int cellsOfBlock, const glm::ivec3& first, const glm::ivec3& last);
  /// Of the blocks of one row from here on.
  void row(int firstBlock, int lastBlock, int j, int k);
  /// Of the middle of a block of the row, mm.
  [[nodiscard]] glm::vec3 shiftAt(int i) const { return valueAt(i, 0); }
  /// From one cell to the next along an axis.
  [[nodiscard]] glm::vec3 stretchAlong(int i, int axis) const {
    return axis > 0 ? valueAt(i, axis) : (at(nodeOf(i) + 1, 0) - at(nodeOf(i), 0)) * perCell_;
  }

 private:
  [[nodiscard]] int nodeOf(int i) const { return (i - first_.x) / blocksOfNode_; }
  [[nodiscard]] const glm::vec3& at(int node, int what) const { return row_[static_cast<std::size_t>(3 * (node - rowFirst_) + what)]; }
  [[nodiscard]] glm::vec3 valueAt(int i, int what) const {
    const int node = nodeOf(i);
    const float t = partOf(i - first_.x - node * blocksOfNode_);
    return at(node, what) + t * (at(node + 1, what) - at(node, what));
  }
  /// Where the middle of the n-th block of a node's cell lies in it, 0..1.
  [[nodiscard]] float partOf(int n) const { return (static_cast<float>(n) + 0.5F) / static_cast<float>(blocksOfNode_); }
  [[nodiscard]] const glm::vec3& askedAt(int i, int j, int k);

  const EchoMotion* motion_ = nullptr;
  glm::dmat4 nodeToProbe_{1.0};
  glm::ivec3 first_{0};
  glm::ivec3 dims_{0};
  int blocksOfNode_ = 1;
  float perCell_ = 1.0F;
  int rowFirst_ = 0;
  std::vector<glm::vec3> nodes_;  ///< not a number until asked
  std::vector<glm::vec3> row_;    ///< by node: shift, and its change from cell to cell along j and k
};

}  // namespace ew::detail
