#pragma once

#include <vtkSmartPointer.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/tracking/hand.h"

class vtkPolyData;

namespace ew {
class BodyShape;
}

namespace ew::bridge {

/// The body the probe is moved over: triangles for the eye and a skin for the hand, in world coordinates (LPS, mm).
struct Mannequin {
  vtkSmartPointer<vtkPolyData> surface;  ///< triangles, counter-clockwise from outside, unit point normals; never changed after loading
  std::shared_ptr<const Skin> skin;
  Bounds bounds;
  std::vector<Message> notes;  ///< what was decided about the file, in sentences for the user ("… is in metres …")
};

/// The corners of the surface's triangles, in its order, and the unit normals there.
struct SkinVertices {
  std::vector<glm::vec3> points_mm;
  std::vector<glm::vec3> outward;
};
[[nodiscard]] SkinVertices skinVerticesOf(const Mannequin& mannequin);

struct MannequinOptions {
  double cell_mm = 7.0;  ///< of the grid a recipe's body is sampled on; half as much costs four times the triangles and eight times the
                         ///< time. Where the body is more curved, edges are halved up to twice
};

/// A body from a recipe (.json, see phantom's BodyShape) or a mesh (.stl, .ply, .obj; ASCII or binary). A mesh is taken to be in world
/// coordinates; one whose largest extent is 0.5 to 2.5 is in metres and is scaled by 1000, which a note says. Triangles facing inwards
/// are turned. Safe on a worker thread; about half a second for a recipe.
/// @error notFound, notReadable, unsupported (ending), truncated, badHeader, badField (a corner that does not exist, a coordinate that is
///        not finite, a body smaller than 100 mm or larger than 5 m), emptyVolume (no triangles), tooLarge (more than 20 million
///        triangles), cancelled, and those of readBodyShape
[[nodiscard]] Result<Mannequin> loadMannequin(const std::filesystem::path& file, const MannequinOptions& options = {},
                                              Progress& progress = noProgress());

/// The surface of an implicit body: flying edges on its field, normals from the field's gradient, the largest closed part only.
/// @error emptyVolume when the field has no surface inside its bounds, cancelled
[[nodiscard]] Result<Mannequin> polygonise(const BodyShape& body, const MannequinOptions& options = {}, Progress& progress = noProgress());

}  // namespace ew::bridge
