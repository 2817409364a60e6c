#include <opencv2/aruco.hpp>
#include <opencv2/calib3d.hpp>

#include "camera_markers.h"
#include "ew/trackers/camera_tracking.h"

namespace ew {
namespace {

std::optional<Transform<frame::Camera, frame::Tool>> plainPose(const cv::Mat& grey, const MarkerBody& body, const cv::Mat& camera,
                                                               const cv::Mat& lens) {
  const auto dictionary = markerDictionary(body.dictionary);
  if (dictionary == nullptr || body.markers.empty()) return {};
  std::vector<std::vector<cv::Point3f>> corners_mm;
  std::vector<int> ids;
  for (const Marker& marker : body.markers) {
    corners_mm.emplace_back();
    for (const auto& at : marker.corners_mm)
      corners_mm.back().emplace_back(static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z));
    ids.push_back(marker.id);
  }
  const auto board = cv::aruco::Board::create(corners_mm, dictionary, ids);
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> found;
  cv::aruco::detectMarkers(grey, dictionary, corners, found, parameters);
  cv::Vec3d turn, place;
  if (found.empty() || cv::aruco::estimatePoseBoard(corners, found, board, camera, lens, turn, place) == 0) return {};
  cv::Matx33d rotation;
  cv::Rodrigues(turn, rotation);
  Transform<frame::Camera, frame::Tool> pose;
  for (int c = 0; c < 3; ++c) {
    for (int r = 0; r < 3; ++r) pose.matrix[c][r] = rotation(r, c);
    pose.matrix[3][c] = place[c];
  }
  return pose;
}

}  // namespace

std::vector<std::optional<Transform<frame::Camera, frame::Tool>>> plainBoardPoses(const CameraModel& model,
                                                                                  const std::vector<MarkerBody>& bodies,
                                                                                  ImageView<const std::uint8_t> grey) {
  const cv::Mat image(grey.height, grey.width, CV_8UC1, const_cast<std::uint8_t*>(grey.data), static_cast<std::size_t>(grey.stride));
  const cv::Mat camera = (cv::Mat_<double>(3, 3) << model.fx, 0.0, model.cx, 0.0, model.fy, model.cy, 0.0, 0.0, 1.0);
  const cv::Mat lens(1, 5, CV_64F, const_cast<double*>(model.distortion.data()));
  std::vector<std::optional<Transform<frame::Camera, frame::Tool>>> poses;
  for (const MarkerBody& body : bodies) {
    try {
      poses.push_back(plainPose(image, body, camera, lens));
    } catch (const cv::Exception&) {
      poses.emplace_back();
    }
  }
  return poses;
}

}  // namespace ew
