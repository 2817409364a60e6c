#include "gui/support/tracker_films.h"

#include <glm/gtc/matrix_transform.hpp>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "camera_truth/paper_camera.h"

namespace ew::ui::testing {
namespace {

constexpr int kWidth = 1280;
constexpr int kHeight = 720;
constexpr double kFilm_hz = 10.0;
constexpr int kInOnePlace = 10;  // images, a second of them
constexpr double kNoise_grey = 2.0;

/// From the front of the patient, a little from the left and from above.
glm::dmat4 cameraInWorld() {
  const glm::dvec3 at(330.0, -640.0, 110.0);
  const glm::dvec3 z = glm::normalize(glm::dvec3(70.0, -90.0, -150.0) - at);
  const glm::dvec3 x = glm::normalize(glm::cross(z, glm::dvec3(0.0, 0.0, 1.0)));
  const glm::dvec3 y = glm::cross(z, x);
  return {glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0), glm::dvec4(at, 1.0)};
}

/// The board lies beside the mannequin's left flank and looks up at the camera.
glm::dmat4 boardInWorld() {
  return {glm::dvec4(1.0, 0.0, 0.0, 0.0), glm::dvec4(0.0, 0.0, 1.0, 0.0), glm::dvec4(0.0, -1.0, 0.0, 0.0),
          glm::dvec4(250.0, -60.0, -150.0, 1.0)};
}

class Film {
 public:
  explicit Film(const std::string& file)
      : film_(file, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), kFilm_hz, cv::Size(kWidth, kHeight), true) {
    film_.set(cv::VIDEOWRITER_PROP_QUALITY, 95.0);
  }
  [[nodiscard]] bool isOpen() const { return film_.isOpened(); }
  /// A second of one view, each image with a noise of its own.
  void add(const cv::Mat& grey) {
    for (int n = 0; n < kInOnePlace; ++n) {
      cv::Mat noisy(grey.size(), CV_16S), noise(grey.size(), CV_16S), shown, coloured;
      grey.convertTo(noisy, CV_16S);
      random_.fill(noise, cv::RNG::NORMAL, 0.0, kNoise_grey);
      noisy += noise;
      noisy.convertTo(shown, CV_8U);
      cv::cvtColor(shown, coloured, cv::COLOR_GRAY2BGR);
      film_.write(coloured);
    }
  }

 private:
  cv::VideoWriter film_;
  cv::RNG random_{20261127};
};

}  // namespace

TrackerFilms::TrackerFilms(MarkerBody probe, MarkerBody board, CharucoBoard chess)
    : probe_(std::move(probe)),
      board_(std::move(board)),
      chess_(std::move(chess)),
      worldToCamera_(glm::inverse(cameraInWorld())),
      boardToWorld_(boardInWorld()) {
  lens_.width = kWidth;
  lens_.height = kHeight;
  lens_.fx = lens_.fy = 960.0;
  lens_.cx = 633.0;
  lens_.cy = 366.0;
}

bool TrackerFilms::writeChess(const std::string& file) const {
  Film film(file);
  if (!film.isOpen()) return false;
  constexpr int kPixelsPerMm = 4;
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_5X5_100);
  const auto board = cv::aruco::CharucoBoard::create(chess_.columns, chess_.rows, static_cast<float>(chess_.square_mm),
                                                     static_cast<float>(chess_.marker_mm), dictionary);
  const double width_mm = chess_.columns * chess_.square_mm;
  const double height_mm = chess_.rows * chess_.square_mm;
  cv::Mat drawn, padded;
  board->draw(cv::Size(static_cast<int>(width_mm * kPixelsPerMm), static_cast<int>(height_mm * kPixelsPerMm)), drawn, 0, 1);
  constexpr int kMargin_mm = 12;
  cv::copyMakeBorder(drawn, padded, kMargin_mm * kPixelsPerMm, kMargin_mm * kPixelsPerMm, kMargin_mm * kPixelsPerMm,
                     kMargin_mm * kPixelsPerMm, cv::BORDER_CONSTANT, cv::Scalar::all(255));
  struct View {
    double x, y, distance_mm, tilt, turn;  // x and y as parts of the image
  };
  std::vector<View> views;
  for (const double distance_mm : {330.0, 480.0, 650.0})
    for (const auto& [x, y] : {std::pair{0.5, 0.5}, {0.28, 0.3}, {0.72, 0.3}, {0.28, 0.7}, {0.72, 0.7}}) {
      const int n = static_cast<int>(views.size());
      views.push_back({x, y, distance_mm, n % 3 == 0 ? 0.0 : n % 2 == 0 ? 0.42 : -0.42, n % 4 == 1 ? 0.45 : n % 4 == 3 ? -0.45 : 0.0});
    }
  views.push_back({0.5, 0.5, 178.0, 0.0, 0.0});  // near: more than half of the image
  views.push_back({0.45, 0.48, 192.0, 0.3, 0.0});
  views.push_back({0.55, 0.52, 186.0, 0.0, 0.3});
  for (const double tilt : {-0.5, 0.5}) views.push_back({0.5, 0.5, 420.0, tilt, 0.0});
  for (const double turn : {-0.5, 0.5}) views.push_back({0.5, 0.5, 420.0, 0.0, turn});
  for (const View& view : views) {
    const glm::dvec3 middle((view.x * kWidth - lens_.cx) / lens_.fx * view.distance_mm,
                            (view.y * kHeight - lens_.cy) / lens_.fy * view.distance_mm, view.distance_mm);
    glm::dmat4 pose = glm::translate(glm::dmat4(1.0), middle);
    pose = glm::rotate(pose, view.tilt, glm::dvec3(1.0, 0.0, 0.0));
    pose = glm::rotate(pose, view.turn, glm::dvec3(0.0, 1.0, 0.0));
    std::vector<cv::Point2f> from, to;
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}}) {
      const double x_mm = (x - 0.5) * (width_mm + 2 * kMargin_mm);
      const double y_mm = (y - 0.5) * (height_mm + 2 * kMargin_mm);
      const glm::dvec2 pixel = pixelOf(lens_, glm::dvec3(pose * glm::dvec4(x_mm, y_mm, 0.0, 1.0)));
      from.emplace_back(static_cast<float>(x * padded.cols - 0.5), static_cast<float>(y * padded.rows - 0.5));
      to.emplace_back(static_cast<float>(pixel.x), static_cast<float>(pixel.y));
    }
    // Drawn twice as large, so that a pixel is the mean of what falls into it.
    constexpr int kFiner = 2;
    for (cv::Point2f& each : to) each = (each + cv::Point2f(0.5F, 0.5F)) * kFiner - cv::Point2f(0.5F, 0.5F);
    cv::Mat large(kHeight * kFiner, kWidth * kFiner, CV_8U), image;
    cv::GaussianBlur(padded, large, cv::Size(), 1.2);
    cv::Mat seen;
    cv::warpPerspective(large, seen, cv::getPerspectiveTransform(from, to), cv::Size(kWidth * kFiner, kHeight * kFiner), cv::INTER_LINEAR,
                        cv::BORDER_CONSTANT, cv::Scalar::all(96));
    cv::resize(seen, image, cv::Size(kWidth, kHeight), 0.0, 0.0, cv::INTER_AREA);
    image.convertTo(image, CV_8U, 0.8, 15.0);
    film.add(image);
  }
  return true;
}

bool TrackerFilms::writePaper(const std::string& file, const std::vector<Transform<frame::World, frame::Probe>>& probes) const {
  Film film(file);
  if (!film.isOpen()) return false;
  camera_truth::PaperCameraOptions options;
  options.superSampling = 1;
  options.noise_grey = 0.0;  // the film has its own
  camera_truth::PaperCamera camera(lens_, {probe_, board_}, options);
  for (const auto& probeToWorld : probes) {
    const glm::dmat4 bodyToWorld = probeToWorld.matrix * glm::inverse(probe_.probeToTool.matrix);
    camera_truth::PaperShot shot;
    shot.poses = {{worldToCamera_ * bodyToWorld, worldToCamera_ * boardToWorld_}};
    GreyImage image = camera.image(shot);
    film.add(cv::Mat(image.height, image.width, CV_8U, image.pixels.data()));
  }
  return true;
}

bool TrackerFilms::writeEmpty(const std::string& file) const {
  Film film(file);
  if (!film.isOpen()) return false;
  camera_truth::PaperCameraOptions options;
  options.superSampling = 1;
  options.noise_grey = 0.0;
  camera_truth::PaperCamera camera(lens_, {board_}, options);
  camera_truth::PaperShot shot;
  shot.poses = {{worldToCamera_ * boardToWorld_}};
  GreyImage image = camera.image(shot);
  film.add(cv::Mat(image.height, image.width, CV_8U, image.pixels.data()));
  return true;
}

}  // namespace ew::ui::testing
