#pragma once

#include <opencv2/aruco/charuco.hpp>

#include "ew/trackers/camera_calibration.h"

namespace ew {

/// OpenCV's board; null where it cannot be.
[[nodiscard]] cv::Ptr<cv::aruco::CharucoBoard> charucoOf(const CharucoBoard& board);
/// An inner corner on the board, mm.
[[nodiscard]] cv::Point3d charucoCorner(const CharucoBoard& board, int id);
/// Why charucoOf() gave nothing.
[[nodiscard]] Error impossibleCharuco();

}  // namespace ew
