#pragma once

#include <array>
#include <glm/glm.hpp>
#include <opencv2/aruco.hpp>
#include <string>
#include <vector>

namespace ew {

/// The set of markers that MarkerBody::dictionary names; null when it is not known.
[[nodiscard]] cv::Ptr<cv::aruco::Dictionary> markerDictionary(const std::string& name);

struct MarkerDetection {
  int id = 0;
  std::array<glm::dvec2, 4> corners_px{};  ///< to within a pixel or two, clockwise from the marker's own top left
};

/// A part of an image.
struct SearchRegion {
  cv::Rect at;
  int step = 1;  ///< 1: at full size; 2: at half of it
};

/// Markers of a dictionary in one region of an image.
/// @param smallest_px side of a marker in the image, below which none is looked for
[[nodiscard]] std::vector<MarkerDetection> findMarkers(const cv::Mat& grey, const SearchRegion& region,
                                                       const cv::Ptr<cv::aruco::Dictionary>& dictionary, double smallest_px);

}  // namespace ew
