#include "ew/trackers/camera_calibration.h"

#include <gtest/gtest.h>

#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

#include "trackers/camera_frames.h"

namespace ew {
namespace {

using test::poseAt;

CharucoBoard aBoard() { return {.columns = 7, .rows = 5, .square_mm = 36.0, .marker_mm = 26.0, .dictionary = "aruco_5x5_100"}; }

/// What a camera measures of the board's corners, with noise; corners outside of the image are not there.
CharucoView viewOfBoard(const CameraModel& model, const glm::dmat4& boardToCamera, double noise_px, std::mt19937_64& random) {
  std::normal_distribution<double> noise(0.0, noise_px);
  CharucoView view;
  for (int id = 0; id < 24; ++id) {
    const glm::dvec4 at_board((1 + id % 6 - 3.5) * 36.0, (1 + id / 6 - 2.5) * 36.0, 0.0, 1.0);
    const glm::dvec2 at = pixelOf(model, glm::dvec3(boardToCamera * at_board)) + glm::dvec2(noise(random), noise(random));
    if (at.x < 2 || at.y < 2 || at.x > model.width - 3 || at.y > model.height - 3) continue;
    view.ids.push_back(id);
    view.corners_px.push_back(at);
  }
  return view;
}

std::vector<CharucoView> manyViews(const CameraModel& model, double noise_px) {
  std::mt19937_64 random(5);
  std::vector<CharucoView> views;
  for (int n = 0; n < 20; ++n) {
    const glm::dvec3 axis(n % 4 < 2 ? 1.0 : 0.2, n % 4 < 2 ? 0.2 : 1.0, 0.1 * n);
    views.push_back(viewOfBoard(model,
                                poseAt({40.0 * (n % 5 - 2), 30.0 * (n % 3 - 1), 330.0 + 15.0 * (n % 7)}, n % 2 == 0 ? 0.55 : -0.45, axis),
                                noise_px, random));
  }
  return views;
}

TEST(CameraCalibration, FindsTheCameraAgain) {
  const CameraModel truth = test::smallCamera();
  const auto found = calibrateCamera(manyViews(truth, 0.05), aBoard(), truth.width, truth.height, noProgress());
  ASSERT_TRUE(found) << found.error();
  EXPECT_EQ(found->quality, CameraCalibration::Quality::good) << found->verdict;
  EXPECT_NEAR(found->model.fx, truth.fx, 1.0);
  EXPECT_NEAR(found->model.fy, truth.fy, 1.0);
  EXPECT_NEAR(found->model.cx, truth.cx, 1.0);
  EXPECT_LT(found->model.rms_px, 0.1);
  EXPECT_LT(found->heldOut_px, 0.15);
  // What counts is where rays go, all over the image.
  for (const glm::dvec2 at : {glm::dvec2(20, 20), glm::dvec2(320, 240), glm::dvec2(600, 60), glm::dvec2(40, 440)})
    EXPECT_LT(glm::distance(at, pixelOf(found->model, glm::dvec3(rayThrough(truth, at), 1.0))), 1.5) << at.x << " " << at.y;
}

TEST(CameraCalibration, LeavesAViewOutInWhichTheBoardMoved) {
  const CameraModel truth = test::smallCamera();
  auto views = manyViews(truth, 0.05);
  for (std::size_t n = 0; n < views[6].corners_px.size(); ++n) views[6].corners_px[n].x += views[6].ids[n] % 2 == 0 ? 1.5 : -1.5;
  const auto found = calibrateCamera(views, aBoard(), truth.width, truth.height, noProgress());
  ASSERT_TRUE(found) << found.error();
  for (std::size_t n = 0; n < views.size(); ++n) EXPECT_EQ(found->leftOut[n], n == 6) << n;
  EXPECT_GT(found->residuals_px[6], 0.2);
}

TEST(CameraCalibration, NeedsEightViews) {
  auto views = manyViews(test::smallCamera(), 0.05);
  views.resize(7);
  const auto found = calibrateCamera(views, aBoard(), 640, 480, noProgress());
  ASSERT_FALSE(found);
  EXPECT_NE(found.error().sentence().find("7 images"), std::string::npos);
}

TEST(CameraCalibration, IsNotCalledGoodFromViewsThatAreAllStraightOn) {
  const CameraModel truth = test::smallCamera();
  std::mt19937_64 random(3);
  std::vector<CharucoView> views;
  for (int n = 0; n < 14; ++n) views.push_back(viewOfBoard(truth, poseAt({4.0 * n - 28.0, 10.0, 400.0}, 0.02), 0.1, random));
  const auto found = calibrateCamera(views, aBoard(), truth.width, truth.height, noProgress());
  ASSERT_TRUE(found) << found.error();
  EXPECT_EQ(found->quality, CameraCalibration::Quality::bad) << found->focalSpread_px << " px of " << found->model.fx;
  EXPECT_NE(found->verdict.english().find("tipped to all sides"), std::string::npos);
}

TEST(CameraCalibration, ReadsAPrintedBoardToATenthOfAPixel) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_5X5_100);
  const auto board = cv::aruco::CharucoBoard::create(7, 5, 36.0F, 26.0F, dictionary);
  cv::Mat drawn;
  board->draw(cv::Size(1260, 900), drawn, 0, 1);  // a square is 180 pixels
  const CharucoView view = findCharuco({drawn.data, drawn.cols, drawn.rows, static_cast<std::ptrdiff_t>(drawn.step)}, aBoard());
  ASSERT_EQ(view.ids.size(), 24u);
  // OpenCV counts rows from the lower edge; whichever way, steps between corners are whole squares.
  for (std::size_t n = 1; n < view.ids.size(); ++n) {
    if (view.ids[n] % 6 == 0) continue;
    EXPECT_NEAR(view.corners_px[n].x - view.corners_px[n - 1].x, 180.0, 0.1) << n;
    EXPECT_NEAR(view.corners_px[n].y, view.corners_px[n - 1].y, 0.1) << n;
  }
}

TEST(CalibrationCollector, KeepsAStillViewOnceAndSaysWhatIsMissing) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_5X5_100);
  const auto board = cv::aruco::CharucoBoard::create(7, 5, 36.0F, 26.0F, dictionary);
  cv::Mat drawn, image(720, 1280, CV_8UC1, cv::Scalar(200));
  board->draw(cv::Size(700, 500), drawn, 0, 1);
  drawn.copyTo(image(cv::Rect(290, 110, 700, 500)));
  const ImageView<const std::uint8_t> grey{image.data, image.cols, image.rows, static_cast<std::ptrdiff_t>(image.step)};
  auto collector = CalibrationCollector::make(aBoard(), 1280, 720);
  ASSERT_TRUE(collector);
  EXPECT_EQ(collector->coverage().views, 0);
  const auto first = collector->look(grey, 0.0);
  EXPECT_EQ(first.verdict, ViewVerdict::kept) << first.blur_px;
  EXPECT_EQ(collector->look(grey, 0.1).verdict, ViewVerdict::alike);
  const auto covered = collector->coverage();
  EXPECT_EQ(covered.views, 1);
  EXPECT_EQ(covered.straight, 1);
  EXPECT_FALSE(covered.enough);
  EXPECT_FALSE(covered.next.empty());
  cv::Mat blurred;
  cv::GaussianBlur(image, blurred, cv::Size(0, 0), 4.0);
  const ImageView<const std::uint8_t> washedOut{blurred.data, blurred.cols, blurred.rows, static_cast<std::ptrdiff_t>(blurred.step)};
  EXPECT_NE(collector->look(washedOut, 5.0).verdict, ViewVerdict::kept);
  const cv::Mat empty(720, 1280, CV_8UC1, cv::Scalar(90));
  EXPECT_EQ(collector->look({empty.data, empty.cols, empty.rows, static_cast<std::ptrdiff_t>(empty.step)}, 6.0).verdict,
            ViewVerdict::noBoard);
}

}  // namespace
}  // namespace ew
