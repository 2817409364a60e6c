#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <opencv2/aruco.hpp>

#include "ew/core/image.h"
#include "ew/trackers/camera_model.h"
#include "ew/trackers/marker_body.h"

namespace ew::test {

inline constexpr double kBoardPitch_mm = 54.0, kBoardMarker_mm = 44.0;

/// A flat board of 2 x 2 markers around the origin; z away from whoever sees it.
inline MarkerBody smallBoard(int firstId = 30) {
  MarkerBody body;
  body.id = "board";
  body.name = "small board";
  body.isBoard = true;
  const double half = 0.5 * kBoardMarker_mm;
  for (int n = 0; n < 4; ++n) {
    const glm::dvec3 middle((n % 2 - 0.5) * kBoardPitch_mm, (n / 2 - 0.5) * kBoardPitch_mm, 0.0);
    body.markers.push_back({firstId + n,
                            {middle + glm::dvec3(-half, -half, 0), middle + glm::dvec3(half, -half, 0), middle + glm::dvec3(half, half, 0),
                             middle + glm::dvec3(-half, half, 0)}});
  }
  return body;
}

inline CameraModel smallCamera() {
  CameraModel model = assumedCamera(640, 480, 1.0);
  model.cx += 3.0;
  model.distortion = {-0.08, 0.03, 0.0004, -0.0006, 0.0};
  return model;
}

inline glm::dmat4 poseAt(const glm::dvec3& place_mm, double tilt_rad, const glm::dvec3& axis = {0.3, 1.0, 0.1}) {
  glm::dmat4 pose = glm::rotate(glm::dmat4(1.0), tilt_rad, glm::normalize(axis));
  pose[3] = glm::dvec4(place_mm, 1.0);
  return pose;
}

/// What a camera sees of the board: each pixel is the mean of sixteen rays through it, without noise.
inline GreyImage imageOf(const CameraModel& model, const MarkerBody& board, const glm::dmat4& boardToCamera) {
  constexpr int kCells = 8, kRays = 4;
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
  std::vector<cv::Mat> bits(board.markers.size());
  for (std::size_t m = 0; m < bits.size(); ++m) dictionary->drawMarker(board.markers[m].id, kCells, bits[m], 1);
  const glm::dmat4 cameraToBoard = glm::inverse(boardToCamera);
  const glm::dvec3 eye = glm::dvec3(cameraToBoard[3]);
  const auto light = [&](const glm::dvec2& at_px) {
    const glm::dvec3 along = glm::dmat3(cameraToBoard) * glm::dvec3(rayThrough(model, at_px), 1.0);
    const glm::dvec3 p = eye - eye.z / along.z * along;
    if (std::max(std::abs(p.x), std::abs(p.y)) > kBoardPitch_mm + 8.0) return 90.0;
    for (std::size_t m = 0; m < bits.size(); ++m) {
      const glm::dvec2 cell = (glm::dvec2(p) - glm::dvec2(board.markers[m].corners_mm[0])) * (kCells / kBoardMarker_mm);
      if (cell.x < 0.0 || cell.y < 0.0 || cell.x >= kCells || cell.y >= kCells) continue;
      return bits[m].at<unsigned char>(static_cast<int>(cell.y), static_cast<int>(cell.x)) < 128 ? 20.0 : 220.0;
    }
    return 220.0;
  };
  GreyImage image(model.width, model.height, 90);
  glm::dvec2 low(1e9), high(-1e9);
  for (const double x : {-1.3, 1.3})
    for (const double y : {-1.3, 1.3}) {
      const glm::dvec2 at = pixelOf(model, glm::dvec3(boardToCamera * glm::dvec4(x * kBoardPitch_mm, y * kBoardPitch_mm, 0.0, 1.0)));
      low = glm::min(low, at);
      high = glm::max(high, at);
    }
  for (int y = std::max(0, static_cast<int>(low.y)); y < std::min(model.height, static_cast<int>(high.y)); ++y)
    for (int x = std::max(0, static_cast<int>(low.x)); x < std::min(model.width, static_cast<int>(high.x)); ++x) {
      double sum = 0.0;
      for (int n = 0; n < kRays * kRays; ++n) sum += light({x - 0.5 + (n % kRays + 0.5) / kRays, y - 0.5 + (n / kRays + 0.5) / kRays});
      viewOf(image).at(x, y) = static_cast<std::uint8_t>(std::lround(sum / (kRays * kRays)));
    }
  return image;
}

}  // namespace ew::test
