#include "ew/trackers/camera_device.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <opencv2/videoio.hpp>
#include <thread>

#include "places.h"
#include "trackers/camera_frames.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using test::poseAt;
using test::smallBoard;
using test::smallCamera;

/// Waits until it is so; half a minute at most.
bool eventually(const std::function<bool()>& isSo) {
  for (int n = 0; n < 3000; ++n) {
    if (isSo()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  return isSo();
}

/// A film of a board that moves to the right; gone at the end.
class CameraFilm : public ::testing::Test {
 protected:
  static constexpr int kFrames = 8;
  void SetUp() override {
    const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    file_ = fs::temp_directory_path() / (std::string("ew_camera_film_") + test->name() + ".avi");
    cv::VideoWriter film(file_.string(), cv::CAP_OPENCV_MJPEG, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 25.0, cv::Size(640, 480), true);
    ASSERT_TRUE(film.isOpened());
    for (int n = 0; n < kFrames; ++n) {
      truth_.push_back(poseAt({4.0 * n, 0.0, 380.0}, 0.5));
      GreyImage image = test::imageOf(smallCamera(), smallBoard(), truth_.back());
      const cv::Mat grey(image.height, image.width, CV_8UC1, image.pixels.data());
      cv::Mat planes[] = {grey, grey, grey}, colours;
      cv::merge(planes, 3, colours);
      film.write(colours);
    }
  }
  void TearDown() override { fs::remove(file_); }

  [[nodiscard]] CameraSettings settings() const {
    CameraSettings made;
    made.device = file_.string();
    made.model = smallCamera();
    made.board = smallBoard();
    made.tracking.gamma = 1.0;
    made.filmSpeed = 0.0;  // every image, as fast as it goes
    return made;
  }
  fs::path file_;
  std::vector<glm::dmat4> truth_;
};

TEST_F(CameraFilm, GivesAReadingForEveryImageAndThenEnds) {
  const auto camera = makeCamera(settings());
  camera->start();
  ASSERT_TRUE(eventually([&] { return camera->status().link == LinkState::ended && camera->view().number == kFrames; }))
      << camera->status().sentence;
  const auto readings = camera->take();
  ASSERT_EQ(readings.size(), static_cast<std::size_t>(kFrames));
  for (std::size_t n = 0; n < readings.size(); ++n) {
    EXPECT_EQ(readings[n].tool, "board");
    EXPECT_EQ(readings[n].state, TrackingState::live);
    EXPECT_NEAR(readings[n].device_s, static_cast<double>(n) / 25.0, 1e-6);
    EXPECT_NEAR(readings[n].toolToTracker.matrix[3].x, truth_[n][3].x, 1.0);
    EXPECT_GT(readings[n].spread_mm, 0.0);
  }
  const CameraView view = camera->view();
  EXPECT_EQ(view.width, 640);
  EXPECT_EQ(view.preview.width, 640);
  EXPECT_EQ(view.names, std::vector<std::string>{"board"});
  EXPECT_EQ(view.sight.markers.size(), 4u);
  EXPECT_EQ(view.leftOut, 0u);
  camera->stop();
  EXPECT_EQ(camera->status().link, LinkState::off);
}

TEST_F(CameraFilm, LoopsWithTimesThatGoOn) {
  CameraSettings looping = settings();
  looping.filmLoops = true;
  const auto camera = makeCamera(looping);
  camera->start();
  std::vector<ToolReading> readings;
  ASSERT_TRUE(eventually([&] {
    for (auto& each : camera->take()) readings.push_back(std::move(each));
    return readings.size() > 2 * kFrames;
  }));
  for (std::size_t n = 1; n < readings.size(); ++n) EXPECT_GT(readings[n].device_s, readings[n - 1].device_s);
  camera->stop();
}

TEST_F(CameraFilm, WithoutAModelShowsImagesAndMeasuresNothing) {
  CameraSettings plain = settings();
  plain.model.reset();
  const auto camera = makeCamera(plain);
  camera->start();
  ASSERT_TRUE(eventually([&] { return camera->view().number == kFrames; }));
  EXPECT_TRUE(camera->take().empty());
  EXPECT_EQ(camera->image().width, 640);
}

TEST_F(CameraFilm, TakesAModelWhileItRuns) {
  CameraSettings later = settings();
  later.model.reset();
  later.filmLoops = true;
  const auto camera = makeCamera(later);
  camera->start();
  ASSERT_TRUE(eventually([&] { return camera->view().number > 2; }));
  EXPECT_NE(camera->status().sentence.english().find("calibrate"), std::string::npos);
  camera->setTracking(smallCamera(), std::nullopt, smallBoard(), later.tracking);
  EXPECT_TRUE(eventually([&] { return !camera->take().empty(); }));
}

TEST_F(CameraFilm, StartsAnewAfterStopping) {
  const auto camera = makeCamera(settings());
  for (int round = 0; round < 2; ++round) {
    camera->start();
    ASSERT_TRUE(eventually([&] { return camera->status().link == LinkState::ended; })) << round;
    camera->stop();
    EXPECT_EQ(camera->take().size(), static_cast<std::size_t>(kFrames)) << round;
  }
}

TEST(CameraDevice, SaysThatThereIsNoCameraAndGoesOnTrying) {
  CameraSettings settings;
  settings.device = "/dev/video97";
  const auto camera = makeCamera(settings);
  camera->start();
  ASSERT_TRUE(eventually([&] {
    return camera->status().sentence.english().find("There is no camera at /dev/video97") != std::string::npos;
  })) << camera->status().sentence;
  EXPECT_EQ(camera->status().link, LinkState::connecting);
  camera->stop();
  EXPECT_EQ(camera->status().link, LinkState::off);
}

TEST(CameraDevice, SaysThatAFilmIsMissingOrNone) {
  const auto sentenceOf = [](const std::string& file) {
    CameraSettings settings;
    settings.device = file;
    const auto camera = makeCamera(settings);
    camera->start();
    std::string said;
    eventually([&] {
      said = camera->status().sentence.english();
      return said.find("film") != std::string::npos;
    });
    return said;
  };
  EXPECT_NE(sentenceOf("/nowhere/film.avi").find("/nowhere/film.avi is not there"), std::string::npos);
  EXPECT_NE(sentenceOf(std::string(EW_SOURCE_DIR) + "/README.md").find("cannot be read as a film"), std::string::npos);
}

TEST(CameraDevice, ListsOnlyCamerasThatAreThere) {
  for (const CameraHere& camera : camerasHere()) {
    EXPECT_TRUE(fs::exists(camera.device)) << camera.device;
    EXPECT_FALSE(camera.name.empty());
  }
}

}  // namespace
}  // namespace ew
