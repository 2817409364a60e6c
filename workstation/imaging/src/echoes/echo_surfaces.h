#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "echo_layout.h"
#include "ew/imaging/bands.h"
#include "ew/imaging/tissue_maps.h"
#include "scatterers.h"
#include "surface_echoes.h"
#include "surface_rows.h"

namespace ew::detail {

inline constexpr double kFragmentCell_mm = 3.0;
inline constexpr double kMostFragment_mm = 11.1;  ///< from its middle to its rim

/// Mirrors: each line is followed through a few planes of the slice to where it crosses a reflecting surface, and adds an echo there, as
/// strong as the surface lies square to it:
///   a = A (u exp(-sin^2 b / (2 sin^2 fall)) + i r exp(-sin^2 b / (2 sin^2 roughFall))),  A as ReflectingSurface::echoLevel says, b the
/// incidence, r what is rough, in quadrature, u uneven within 3 to 6 mm, by 4 dB at most. In the field all mirrors have one phase, and all
/// that is rough has: laterally they add up to a line as wide as the beam, without beads, and a surface that leans in elevation is spread
/// over the depths at which it is met. Source: incidence as facts of the field have it (20 dB at 20 degrees for capsules and diaphragm);
/// the formula is ours.
class EchoSurfaces {
 public:
  void configure(const EchoLayout& layout);
  /// Adds to the fine grid, in units of kDepositUnit. Every line has rows of its own.
  /// @param maps with surfaces
  /// @param motion of what they show. A surface that moves is met where it has gone, at the
  /// incidence it has at rest but where tissue gives way to the face: there as it lies.
  void add(const TissueMaps& maps, const Transform<frame::Voxel, frame::Probe>& probeToVoxel, const EchoMotion& motion, Bands& bands,
           std::int32_t* fine, std::ptrdiff_t stride);

  /// Little walls and fissures, at most one in each block: bent discs of hashed place, direction and size that fade towards their rim, two
  /// in five of them with a second wall 1.2 to 3 mm behind, seen where they lie square to the beam, as much above the level around them as
  /// LiveEchoesEffect says, give or take 4 dB. Aim: 0.4 bright dashes of 3 mm and more in 4 cm2, as in a recorded liver.
  /// @param fragments lattice of which kBlockCells cells are kFragmentCell_mm
  /// @param reached   nothing is added beyond
  void addFragments(const SliceSource& level, const EchoPlace& fragments, const std::vector<ScatterBlock>& blocks,
                    const DepthRange& reached, std::int32_t* fine, std::ptrdiff_t stride) const;

 private:
  struct Scratch {
    std::vector<SurfaceCrossing> found;
    SurfaceCrossings met;
    std::vector<SurfaceProbe> probes;  ///< four for each that is found where tissue gives way: below and above, line after and line before
    std::vector<float> around_mm;
  };
  void addLines(int first, int count, const SurfaceWalk& walk, const glm::mat4& toVoxel, const EchoMotion& motion,
                const SurfaceEchoTask& echoes, Scratch& mine) const;
  [[nodiscard]] glm::vec2 turnedSlope(int line, float range_mm, const float* around_mm) const;
  void announce(const SurfaceEchoTask& echoes, int line, float range_mm, const glm::vec3& at) const;
  /// To a row counted from the first line's.
  void add(int row, double range_mm, double amplitude, double rough, std::int32_t* fine, std::ptrdiff_t stride) const;

  const EchoLayout* layout_ = nullptr;
  std::vector<glm::vec4> lines_;     ///< origin and direction
  std::vector<float> elevation_mm_;  ///< one standard deviation, by whole mm of depth
  std::vector<float> scale_;         ///< by column: of a surface's amplitude, to what is added to each row
  LineWays ways_;                    ///< in voxels
  SurfaceStrengths strengths_;
  std::array<std::vector<glm::vec3>, 3> back_;  ///< by ray: EchoMotion::rowsOf, in voxels
  std::vector<Scratch> scratch_;                ///< by thread
};

}  // namespace ew::detail
