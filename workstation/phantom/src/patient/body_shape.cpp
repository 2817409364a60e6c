#include "ew/phantom/body_shape.h"

#include <cmath>
#include <new>

#include "ew/core/contract.h"
#include "ew/core/parallel.h"
#include "patient/recipe.h"
#include "patient/whole_recipe.h"

namespace ew {
namespace {

class RecipeBody final : public BodyShape {
 public:
  explicit RecipeBody(phantom::ShapePtr shape) : shape_(std::move(shape)) {}
  double signedDistance_mm(const glm::dvec3& p_world_mm) const override { return shape_->distance_mm(p_world_mm); }
  Bounds bounds() const override { return shape_->bounds(); }

 private:
  phantom::ShapePtr shape_;
};

constexpr int kBodyBlock = 4;
// How far a first-order distance may exceed the true one; measured on the shipped body (below 1.4) and kept with a reserve.
constexpr double kBodyReserve = 1.5;

}  // namespace

BodyShape::~BodyShape() = default;

Result<std::unique_ptr<BodyShape>> readBodyShape(const std::filesystem::path& recipe) {
  const auto json = phantom::readWholeMannequin(recipe);
  if (!json) return passOn(json.error());
  JsonReading reading = phantom::readingOf(recipe);
  const JsonFields fields(*json, reading);
  fields.only({"format", "height_mm", "frames", "body"});
  fields.text("name");
  if (!fields.has("body")) fields.refuse("body", say<"a shape">());
  phantom::ShapePtr shape;
  const phantom::FramesByName frames = phantom::readFrames(fields);
  if (reading.good()) shape = phantom::readShape(fields.object("body"), {}, frames);
  if (reading.problem()) return passOn(*reading.problem());
  return std::make_unique<RecipeBody>(std::move(shape));
}

glm::dvec3 outwardNormal(const BodyShape& body, const glm::dvec3& p_world_mm, double step_mm) {
  EW_EXPECTS(step_mm > 0.0);
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 step(0.0);
    step[axis] = step_mm;
    gradient[axis] = body.signedDistance_mm(p_world_mm + step) - body.signedDistance_mm(p_world_mm - step);
  }
  const double length = glm::length(gradient);
  return length > 0.0 ? gradient / length : glm::dvec3(0.0, -1.0, 0.0);
}

Result<void> sampleDistance(const BodyShape& body, const Grid& grid, std::vector<float>& distances_mm, int threads, Progress& progress) {
  if (const auto usable = checkGrid(grid); !usable) return passOn(usable.error());
  try {
    distances_mm.resize(grid.voxelCount());
  } catch (const std::bad_alloc&) {
    return failure(ErrorCode::tooLarge, say<"There is not enough memory to sample the body at this spacing; use a coarser one.">());
  } catch (const std::length_error&) {
    return failure(ErrorCode::tooLarge, say<"There is not enough memory to sample the body at this spacing; use a coarser one.">());
  }
  const auto voxelToWorld = grid.voxelToWorld();
  const auto worldOf = [&](const glm::dvec3& ijk) { return (voxelToWorld * Point<frame::Voxel>{ijk}).at; };
  const glm::ivec3 blocks = (grid.dims + glm::ivec3(kBodyBlock - 1)) / kBodyBlock;
  const bool finished =
      forEachTask(blocks.y * blocks.z, threads, progress, say<"Shaping the body">(), [&](int row, int /*worker*/, const auto& stopped) {
        for (int bi = 0; bi < blocks.x && !stopped(); ++bi) {
          const glm::ivec3 first(bi * kBodyBlock, (row % blocks.y) * kBodyBlock, (row / blocks.y) * kBodyBlock);
          const glm::ivec3 last = glm::min(first + kBodyBlock, grid.dims) - 1;
          const glm::dvec3 centre = worldOf(0.5 * glm::dvec3(first + last));
          const double reach = glm::distance(centre, worldOf(glm::dvec3(first)));
          const double across = glm::distance(centre, worldOf(glm::dvec3(first.x, last.y, last.z)));
          const double radius = std::max({reach, across, glm::distance(centre, worldOf(glm::dvec3(last.x, first.y, last.z))),
                                          glm::distance(centre, worldOf(glm::dvec3(last.x, last.y, first.z)))});
          const double atCentre = body.signedDistance_mm(centre);
          const bool far = std::abs(atCentre) > kBodyReserve * radius;
          for (int k = first.z; k <= last.z; ++k) {
            for (int j = first.y; j <= last.y; ++j) {
              float* out = distances_mm.data() + grid.indexOf(first.x, j, k);
              for (int i = first.x; i <= last.x; ++i)
                *out++ = static_cast<float>(far ? atCentre : body.signedDistance_mm(worldOf(glm::dvec3(i, j, k))));
            }
          }
        }
      });
  if (!finished) return failure(ErrorCode::cancelled, say<"Shaping the body was stopped.">());
  return {};
}

}  // namespace ew
