#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/image.h"
#include "ew/core/result.h"
#include "ew/imaging/knobs.h"

namespace ew {

struct RowSpan;

/// The recorded images of a sweep, sliced as they are: a point lies between two of them, and is read from both at its place in each. So a
/// plane that was recorded shows the image of then, as sharp as it was, where voxels of 0.7 mm have lost half of its detail; and what was
/// recorded ends at the edge of its fan, not at the steps of voxels.
/// Where the planes of a probe that was rocked cross one another, close to its face, the image nearest to the point is read.
class FrameStack {
 public:
  /// @param pixels of all images, one after the other, each as width x height
  /// @param imageToVoxel of each image, in the order they were recorded: where its pixels lie among the voxels of a volume. Affine; the
  ///                     direction of z counts, not its length
  /// @error badField: fewer than two images, an image that is flat, pixels that are too few
  [[nodiscard]] static Result<FrameStack> make(std::vector<std::uint8_t> pixels, int width, int height,
                                               std::span<const Transform<frame::Voxel, frame::Image>> imageToVoxel);

  [[nodiscard]] std::size_t size() const { return frames_.size(); }

  /// Samples span.begin .. span.end - 1 of a row that lies at start_voxel + n * step_voxel, n from 0; 0 where nothing was recorded. Nothing
  /// else is written. Weave reads the nearest pixel of the nearest image; linear blends pixels and both images;
  /// cubic is cubic convolution over 4 x 4 pixels of each image (Keys, IEEE Trans. ASSP 29(6), 1981), and blends both.
  void sampleRow(Quality quality, const glm::dvec3& start_voxel, const glm::dvec3& step_voxel, const RowSpan& span,
                 std::uint8_t* row) const;

  /// Where a point lies in the stack: pixel along x and y, and the image, a whole number on its plane.
  /// @param near image from which the search begins; the one found
  /// @return z is NaN where nothing was recorded
  [[nodiscard]] glm::dvec3 at(const glm::dvec3& point_voxel, int& near) const;

 private:
  struct Frame {
    glm::dvec4 x, y;   ///< rows of voxel to image
    glm::dvec4 ahead;  ///< voxels before its plane, towards the next image
  };
  /// @param place within the stack, at least a thousandth before its last pixels and its last image
  [[nodiscard]] std::uint8_t greyAt(Quality quality, const glm::vec3& place) const;
  [[nodiscard]] glm::dvec3 nearest(const glm::dvec4& point, int& near) const;

  int width_ = 0, height_ = 0;
  std::vector<std::uint8_t> pixels_;
  std::vector<Frame> frames_;
  double usual_ = 1.0;  ///< from one image to the next, in the middle; in the unit of Frame::ahead
};

}  // namespace ew
