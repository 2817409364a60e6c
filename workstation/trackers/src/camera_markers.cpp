#include "camera_markers.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "marker_dictionary.h"

namespace ew {

cv::Ptr<cv::aruco::Dictionary> markerDictionary(const std::string& name) {
  if (markersOf(name) == 0) return nullptr;
  return cv::aruco::getPredefinedDictionary(opencvDictionary(name));
}

std::vector<MarkerDetection> findMarkers(const cv::Mat& grey, const SearchRegion& region, const cv::Ptr<cv::aruco::Dictionary>& dictionary,
                                         double smallest_px) {
  const cv::Rect at = region.at & cv::Rect(0, 0, grey.cols, grey.rows);
  if (at.width < 24 || at.height < 24) return {};
  cv::Mat part = grey(at);
  if (region.step > 1) {
    cv::Mat smaller;
    cv::resize(part, smaller, cv::Size(at.width / region.step, at.height / region.step), 0.0, 0.0, cv::INTER_AREA);
    part = smaller;
  }
  const double scale = region.step;
  const auto parameters = cv::aruco::DetectorParameters::create();
  // Thresholds against the mean around each pixel, in two sizes: light may fall off across the image, and a window smaller than a
  // marker's border leaves its outline.
  parameters->adaptiveThreshWinSizeMin = 5;
  parameters->adaptiveThreshWinSizeMax = 21;
  parameters->adaptiveThreshWinSizeStep = 16;
  parameters->adaptiveThreshConstant = 7;
  const double longest = std::max(part.cols, part.rows);
  parameters->minMarkerPerimeterRate = std::clamp(4.0 * smallest_px / scale / longest, 0.005, 1.0);
  parameters->maxMarkerPerimeterRate = 4.0;
  parameters->minCornerDistanceRate = 0.05;
  parameters->minDistanceToBorder = 2;
  parameters->polygonalApproxAccuracyRate = 0.04;
  parameters->perspectiveRemovePixelPerCell = 4;
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_NONE;
  parameters->errorCorrectionRate = 0.5;  // a wrong id is worse than a marker missed
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  try {
    cv::aruco::detectMarkers(part, dictionary, corners, ids, parameters);
  } catch (const cv::Exception&) {
    return {};  // its contours of a very small part
  }
  std::vector<MarkerDetection> found(ids.size());
  for (std::size_t m = 0; m < ids.size(); ++m) {
    found[m].id = ids[m];
    for (std::size_t n = 0; n < 4; ++n) {  // pixels have their centres at whole numbers, whatever their size
      const cv::Point2d corner = corners[m][n];
      found[m].corners_px[n] = {(corner.x + 0.5) * scale - 0.5 + at.x, (corner.y + 0.5) * scale - 0.5 + at.y};
    }
  }
  return found;
}

}  // namespace ew
