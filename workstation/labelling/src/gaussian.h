#pragma once

#include <vector>

#include "ew/core/volume.h"
#include "ew/labelling/labels.h"

namespace ew::labelling {

/// A value for each voxel of a box.
template <class T>
class Block {
 public:
  explicit Block(const VoxelBox& box) : box_(box), size_(box.end - box.first), values_(samplesIn(size_)) {}
  [[nodiscard]] const VoxelBox& box() const { return box_; }
  [[nodiscard]] const glm::ivec3& size() const { return size_; }
  [[nodiscard]] bool contains(const glm::ivec3& ijk) const {
    return glm::all(glm::greaterThanEqual(ijk, box_.first)) && glm::all(glm::lessThan(ijk, box_.end));
  }
  [[nodiscard]] std::size_t indexOf(const glm::ivec3& ijk) const {
    const glm::ivec3 at = ijk - box_.first;
    return sampleIndex(size_, at.x, at.y, at.z);
  }
  [[nodiscard]] T& operator[](const glm::ivec3& ijk) { return values_[indexOf(ijk)]; }
  [[nodiscard]] const T& operator[](const glm::ivec3& ijk) const { return values_[indexOf(ijk)]; }
  [[nodiscard]] std::vector<T>& values() { return values_; }
  [[nodiscard]] const std::vector<T>& values() const { return values_; }
  template <class Do>
  void forEach(const Do& call) {
    std::size_t n = 0;
    for (int k = box_.first.z; k < box_.end.z; ++k)
      for (int j = box_.first.y; j < box_.end.y; ++j)
        for (int i = box_.first.x; i < box_.end.x; ++i) call(i, j, k, values_[n++]);
  }

 private:
  VoxelBox box_;
  glm::ivec3 size_;
  std::vector<T> values_;
};

/// Averages by a Gaussian of `sigma` voxels along each axis, cut off at three sigma; at the border by what lies within. False: cancelled.
bool blur(Block<float>& values, const glm::dvec3& sigma, Progress& progress);

}  // namespace ew::labelling
