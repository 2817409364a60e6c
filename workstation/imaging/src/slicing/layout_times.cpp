#include "ew/imaging/layout_times.h"

#include <time.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <vector>

#include "ew/imaging/slicing.h"

namespace ew {
namespace {

using ImageToVoxel = Transform<frame::Voxel, frame::Image>;

constexpr int kWidth_px = 200, kHeight_px = 140;  // a band: two thirds of the time of a square
constexpr int kDirections = 2;                    ///< of each class
constexpr std::size_t kSlides = 2;                ///< planes of a direction, as a hand slides
constexpr std::size_t kVisits = 2;                ///< of them, one after another
constexpr double kSlide_voxel = 1.3;
constexpr double kEnough_us = 1.2e5;

/// Of the calling thread: what other programs take from it meanwhile does not count.
double processorTime_us() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e6 * static_cast<double>(now.tv_sec) + 1e-3 * static_cast<double>(now.tv_nsec);
}

/// The n-th of orientations and places that are spread over all, in pixels of `pixel_voxel`. Places matter: planes about one point share
/// its lines of the cache, and a large volume looks as near as a small one.
ImageToVoxel planeOf(const glm::ivec3& dims, int n, double pixel_voxel) {
  const double t = n;
  const glm::dvec3 axis(std::sin(2.4 * t + 0.3), std::cos(1.7 * t), std::sin(3.1 * t + 1.0));
  const glm::dmat3 axes = glm::mat3_cast(glm::angleAxis(0.7 + 0.9 * t, glm::normalize(axis)));
  ImageToVoxel plane;
  for (int a = 0; a < 3; ++a) plane.matrix[a] = glm::dvec4(pixel_voxel * axes[a], 0.0);
  const glm::dvec3 halfDiagonal_voxel = 0.5 * pixel_voxel * ((kWidth_px - 1.0) * axes[0] + (kHeight_px - 1.0) * axes[1]);
  // Roberts' sequence R3, the golden ratio's in three dimensions.
  const glm::dvec3 place = 2.0 * glm::fract(t * glm::dvec3(0.8191725, 0.6710436, 0.5497005)) - 1.0;
  const glm::dvec3 room_voxel = glm::max(0.5 * glm::dvec3(dims - 1) - glm::length(halfDiagonal_voxel), glm::dvec3(0.0));
  plane.matrix[3] = glm::dvec4(0.5 * glm::dvec3(dims - 1) + place * room_voxel - halfDiagonal_voxel, 1.0);
  return plane;
}

/// Slices of one class. Frames of linear and cubic sampling mostly have several pixels a voxel, so where the class allows it every second
/// direction is one of these.
std::vector<ImageToVoxel> planesOf(const SliceClass& wanted, const glm::ivec3& dims) {
  std::vector<ImageToVoxel> planes;
  const bool hasFine = wanted.quality != Quality::weave && wanted.meets != SliceClass::Meets::many;
  for (int n = 0, found = 0; found < kDirections; ++n) {
    const ImageToVoxel first = planeOf(dims, n, hasFine && found % 2 == 1 ? 0.5 : 1.0);
    if (sliceClassOf(wanted.quality, glm::dvec3(first.matrix[0]), glm::dvec3(first.matrix[1])) != wanted) continue;
    ++found;
    for (std::size_t slide = 0; slide < kSlides; ++slide) {
      planes.push_back(first);
      planes.back().matrix[3] += kSlide_voxel * static_cast<double>(slide) * glm::normalize(first.matrix[2]);
    }
  }
  return planes;
}

/// The least time of each plane of a class on each visit.
struct ClassTimes {
  std::vector<ImageToVoxel> planes;
  std::array<std::vector<double>, 2> least_us;  ///< from rows, from bricks
};

double logMean_us(const std::vector<double>& times_us) {
  double sum = 0.0;
  for (const double time_us : times_us) sum += std::log(time_us);
  return std::exp(sum / static_cast<double>(times_us.size()));
}

}  // namespace

LayoutChoice LayoutTimes::choice() const {
  LayoutChoice choice;
  for (std::size_t n = 0; n < ofClass.size(); ++n) choice.set(n, ofClass[n].choosesBricks());
  return choice;
}

LayoutPair LayoutTimes::mean() const {
  LayoutPair sum;
  for (const LayoutPair& pair : ofClass) {
    sum.rows_us += std::log(pair.rows_us) / static_cast<double>(ofClass.size());
    sum.bricks_us += std::log(pair.bricks_us) / static_cast<double>(ofClass.size());
  }
  return {std::exp(sum.rows_us), std::exp(sum.bricks_us)};
}

double LayoutTimes::chosen_us() const {
  double sum = 0.0;
  for (const LayoutPair& pair : ofClass) sum += std::log(pair.chosen_us()) / static_cast<double>(ofClass.size());
  return std::exp(sum);
}

LayoutTimes timeLayouts(const VolumeView<const std::uint8_t>& volume, const BrickVolume& bricks) {
  const std::array<SliceSource, 2> sources = {SliceSource(volume), bricks.source(volume.grid)};
  std::array<ClassTimes, SliceClass::kCount> classes;
  for (std::size_t n = 0; n < classes.size(); ++n) {
    classes[n].planes = planesOf(SliceClass::at(n), volume.grid.dims);
    for (auto& times_us : classes[n].least_us) times_us.assign(kVisits * classes[n].planes.size(), std::numeric_limits<double>::infinity());
  }
  SliceScratch scratch;
  GreyImage image(kWidth_px, kHeight_px);
  const double begun_us = processorTime_us();
  // Two rounds at least, so that a disturbance does not decide. Each takes all classes from one layout and then all from the other, as a
  // program reads them that has chosen: in turns they would push one another out of the cache. The first visit finds voxels far away, as
  // after a jump, and the second near, as where a hand dwells. Rows do better near, bricks far: both count.
  for (int round = 0; round < 2 || processorTime_us() - begun_us < kEnough_us; ++round)
    for (std::size_t layout = 0; layout < sources.size(); ++layout)
      for (std::size_t n = 0; n < classes.size(); ++n)
        for (std::size_t first = 0; first < classes[n].planes.size(); first += kSlides)
          for (std::size_t visit = 0; visit < kVisits; ++visit)
            for (std::size_t at = first; at < first + kSlides; ++at) {
              const double start_us = processorTime_us();
              slice(SliceClass::at(n).quality, sources[layout], classes[n].planes[at], viewOf(image), scratch);
              double& least_us = classes[n].least_us[layout][kVisits * at + visit];
              least_us = std::min(least_us, std::max(processorTime_us() - start_us, 0.1));
            }
  LayoutTimes times;
  for (std::size_t n = 0; n < classes.size(); ++n)
    times.ofClass[n] = {logMean_us(classes[n].least_us[0]), logMean_us(classes[n].least_us[1])};
  return times;
}

}  // namespace ew
