// What is done to a whole label: its largest piece, rounding off.
#include <vector>

#include "ew/core/contract.h"
#include "gaussian.h"
#include "voxel_boxes.h"

namespace ew::labelling {

Result<VoxelBox> keepLargest(Volume& labels, std::uint8_t label, Progress& progress) {
  const VoxelBox box = boxOf(labels, label);
  if (box.empty()) return VoxelBox{};
  const Grid& grid = labels.grid;
  std::vector<std::uint32_t> pieceOf(grid.voxelCount(), 0);
  std::vector<std::size_t> sizes{0};
  std::vector<glm::ivec3> front;
  static constexpr int kSteps[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (int k = box.first.z; k < box.end.z; ++k) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Cancelled.">());
    progress.report(say<"Looking for the largest piece">(), static_cast<double>(k - box.first.z) / (box.end.z - box.first.z));
    for (int j = box.first.y; j < box.end.y; ++j)
      for (int i = box.first.x; i < box.end.x; ++i) {
        if (labels.echo[grid.indexOf(i, j, k)] != label || pieceOf[grid.indexOf(i, j, k)] != 0) continue;
        const auto piece = static_cast<std::uint32_t>(sizes.size());
        sizes.push_back(0);
        pieceOf[grid.indexOf(i, j, k)] = piece;
        front.assign(1, {i, j, k});
        while (!front.empty()) {
          const glm::ivec3 at = front.back();
          front.pop_back();
          if ((++sizes.back() & 0xffffu) == 0 && progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Cancelled.">());
          for (const auto& step : kSteps) {
            const glm::ivec3 to = at + glm::ivec3(step[0], step[1], step[2]);
            if (!grid.contains(to)) continue;
            const std::size_t there = grid.indexOf(to.x, to.y, to.z);
            if (labels.echo[there] != label || pieceOf[there] != 0) continue;
            pieceOf[there] = piece;
            front.push_back(to);
          }
        }
      }
  }
  const auto largest = static_cast<std::uint32_t>(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  for (std::size_t n = 0; n < pieceOf.size(); ++n)
    if (pieceOf[n] != 0 && pieceOf[n] != largest) labels.echo[n] = 0;
  return box;
}

Result<VoxelBox> smooth(Volume& labels, std::uint8_t label, double sigma_mm, Progress& progress) {
  EW_EXPECTS(sigma_mm > 0.0 && label != 0);
  const VoxelBox tight = boxOf(labels, label);
  if (tight.empty()) return VoxelBox{};
  const glm::ivec3 margin = glm::ivec3(glm::ceil(sigma_mm / labels.grid.spacing_mm)) + 1;
  const VoxelBox box = clipped({tight.first - margin, tight.end + margin}, labels.grid);
  Block<float> share(box);
  share.forEach([&](int i, int j, int k, float& value) { value = labels.echo[labels.grid.indexOf(i, j, k)] == label ? 1.0F : 0.0F; });
  if (!blur(share, sigma_mm / labels.grid.spacing_mm, progress)) return failure(ErrorCode::cancelled, say<"Cancelled.">());
  share.forEach([&](int i, int j, int k, const float& value) {
    std::uint8_t& here = labels.echo[labels.grid.indexOf(i, j, k)];
    if (here == label && value <= 0.5F) here = 0;
    if (here == 0 && value > 0.5F) here = label;
  });
  return box;
}

}  // namespace ew::labelling
