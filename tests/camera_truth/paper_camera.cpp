#include "camera_truth/paper_camera.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRegularPolygonSource.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>
#include <random>

namespace ew::camera_truth {
namespace {

constexpr double kInk = 14.0, kPaper = 205.0;  // linear grey levels

Marker markerOn(const glm::dvec3& middle, const glm::dvec3& right, const glm::dvec3& down, double side_mm, int id) {
  const double half = 0.5 * side_mm;
  return {id,
          {middle - half * right - half * down, middle + half * right - half * down, middle + half * right + half * down,
           middle - half * right + half * down}};
}

vtkSmartPointer<vtkImageData> textureOf(int id, double marker_mm, double margin_mm, double texelsPerMm) {
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
  const int inner = static_cast<int>(std::lround(marker_mm * texelsPerMm)), margin = static_cast<int>(std::lround(margin_mm * texelsPerMm));
  cv::Mat marker;
  dictionary->drawMarker(id, inner, marker, 1);
  auto image = vtkSmartPointer<vtkImageData>::New();
  const int side = inner + 2 * margin;
  image->SetDimensions(side, side, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const bool isInside = x >= margin && y >= margin && x < margin + inner && y < margin + inner;
      const bool isBlack = isInside && marker.at<unsigned char>(y - margin, x - margin) < 128;
      std::fill_n(out + 3 * (y * side + x), 3, static_cast<unsigned char>(isBlack ? kInk : kPaper));
    }
  return image;
}

/// Rectangles of all sizes and greys, as a room behind has them.
vtkSmartPointer<vtkImageData> clutter(std::uint64_t seed) {
  constexpr int kSide = 512;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(kSide, kSide, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  cv::Mat out(kSide, kSide, CV_8UC3, image->GetScalarPointer());
  out.setTo(cv::Scalar::all(70));
  std::mt19937_64 random(seed);
  std::uniform_int_distribution<int> at(0, kSide), size(4, 90), grey(5, 220);
  for (int n = 0; n < 220; ++n)
    cv::rectangle(out, cv::Rect(at(random), at(random), size(random), size(random)), cv::Scalar::all(grey(random)), -1);
  return image;
}

vtkSmartPointer<vtkTexture> textured(vtkImageData* image, bool hasMipmap) {
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->SetMipmap(hasMipmap);
  texture->RepeatOff();
  texture->EdgeClampOn();
  return texture;
}

void setMatrix(vtkActor* actor, const glm::dmat4& matrix) {
  vtkNew<vtkMatrix4x4> rows;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) rows->SetElement(r, c, matrix[c][r]);
  actor->SetUserMatrix(rows);
}

}  // namespace

MarkerBody boxBody(double side_mm, double marker_mm, double faceBelow_mm, int firstId) {
  MarkerBody body;
  body.id = "box";
  body.name = "box";
  const double half = 0.5 * side_mm;
  const glm::dvec3 down(0, 1, 0);
  const glm::dvec3 outwards[] = {{0, 0, -1}, {1, 0, 0}, {0, 0, 1}, {-1, 0, 0}};
  for (int n = 0; n < 4; ++n)
    body.markers.push_back(markerOn(half * outwards[n], glm::cross(outwards[n], down), down, marker_mm, firstId + n));
  body.markers.push_back(markerOn({0, -half, 0}, {1, 0, 0}, {0, 0, -1}, marker_mm, firstId + 4));
  body.probeToTool.matrix[3] = glm::dvec4(0, faceBelow_mm, 0, 1);
  return body;
}

MarkerBody boardBody(int columns, int rows, double pitch_mm, double marker_mm, int firstId) {
  MarkerBody body;
  body.id = "board";
  body.name = "board";
  body.isBoard = true;
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c)
      body.markers.push_back(markerOn({(c - 0.5 * (columns - 1)) * pitch_mm, (r - 0.5 * (rows - 1)) * pitch_mm, 0}, {1, 0, 0}, {0, 1, 0},
                                      marker_mm, firstId + r * columns + c));
  return body;
}

struct PaperCamera::State {
  CameraModel model;
  PaperCameraOptions options;
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkRenderWindow> window;
  std::vector<MarkerBody> bodies;
  std::vector<std::vector<vtkSmartPointer<vtkActor>>> actors;  ///< of each body
  vtkNew<vtkActor> cover;
  vtkNew<vtkRegularPolygonSource> coverShape;
  int drawnWidth = 0, drawnHeight = 0;
  int windowWidth = 0, windowHeight = 0;
  vtkNew<vtkMatrix4x4> whole;  ///< projection onto the whole drawn image
  cv::Mat mapX, mapY;          ///< of the drawn image, for every pixel of the camera
  std::vector<float> noise;
  vtkNew<vtkUnsignedCharArray> read;

  void addMarker(const MarkerBody& body, const Marker& marker, double margin_mm, std::vector<vtkSmartPointer<vtkActor>>& to);
  void addBackground();
  void prepareLens();
  /// What is worked on: all of it, or what the bodies cover.
  struct Parts {
    cv::Rect seen, drawn;
  };
  [[nodiscard]] Parts parts(const std::vector<std::vector<glm::dmat4>>& poses) const;
  [[nodiscard]] cv::Mat drawn(const std::vector<glm::dmat4>& poses, const cv::Rect& part);
  [[nodiscard]] cv::Mat throughLens(const cv::Mat& image, const Parts& parts) const;
  void encode(const cv::Mat& seen, const cv::Rect& part, const PaperShot& shot, GreyImage& image) const;
};

void PaperCamera::State::addMarker(const MarkerBody& body, const Marker& marker, double margin_mm,
                                   std::vector<vtkSmartPointer<vtkActor>>& to) {
  const glm::dvec3 right = glm::normalize(marker.corners_mm[1] - marker.corners_mm[0]);
  const glm::dvec3 down = glm::normalize(marker.corners_mm[3] - marker.corners_mm[0]), outward = glm::cross(down, right);
  const glm::dvec3 middle = 0.5 * (marker.corners_mm[0] + marker.corners_mm[2]);
  const double side_mm = glm::distance(marker.corners_mm[0], marker.corners_mm[1]), half = 0.5 * side_mm + margin_mm;
  // A board bulges as a whole, the face of a box by itself.
  double reach = half;
  if (body.isBoard)
    for (const Marker& each : body.markers)
      for (const auto& corner : each.corners_mm) reach = std::max(reach, std::abs(corner.x) + margin_mm);
  constexpr int kSteps = 8;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> cells;
  for (int v = 0; v <= kSteps; ++v)
    for (int u = 0; u <= kSteps; ++u) {
      const double across = (2.0 * u / kSteps - 1.0) * half;
      glm::dvec3 at = middle + across * right + (2.0 * v / kSteps - 1.0) * half * down;
      const double x = (body.isBoard ? at.x : across) / reach;
      at += options.curl_mm * (1.0 - x * x) * outward;
      points->InsertNextPoint(at.x, at.y, at.z);
      places->InsertNextTuple2(static_cast<double>(u) / kSteps, static_cast<double>(v) / kSteps);
    }
  for (int v = 0; v < kSteps; ++v)
    for (int u = 0; u < kSteps; ++u) {
      const vtkIdType a = v * (kSteps + 1) + u;
      const vtkIdType square[] = {a, a + kSteps + 1, a + kSteps + 2, a + 1};  // counter-clockwise from outside
      cells->InsertNextCell(4, square);
    }
  vtkNew<vtkPolyData> paper;
  paper->SetPoints(points);
  paper->SetPolys(cells);
  paper->GetPointData()->SetTCoords(places);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(paper);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetTexture(textured(textureOf(marker.id, side_mm, margin_mm, options.room ? 4.0 : 2.0), options.room));
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->BackfaceCullingOn();
  renderer->AddActor(actor);
  to.push_back(actor);
}

void PaperCamera::State::addBackground() {
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> places;
  places->SetNumberOfComponents(2);
  vtkNew<vtkCellArray> cells;
  constexpr double kHalf_mm = 2200.0, kAway_mm = 1900.0;
  for (const auto& [x, y] : {std::pair{-1.0, -1.0}, {-1.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}}) {
    points->InsertNextPoint(x * kHalf_mm, y * kHalf_mm, kAway_mm);
    places->InsertNextTuple2(0.5 + 0.5 * x, 0.5 + 0.5 * y);
  }
  const vtkIdType square[] = {0, 1, 2, 3};
  cells->InsertNextCell(4, square);
  vtkNew<vtkPolyData> wall;
  wall->SetPoints(points);
  wall->SetPolys(cells);
  wall->GetPointData()->SetTCoords(places);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(wall);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetTexture(textured(clutter(options.seed), true));
  actor->GetProperty()->LightingOff();
  renderer->AddActor(actor);
}

/// Where each pixel of the camera lies in the drawn image, which is wide enough for the lens.
void PaperCamera::State::prepareLens() {
  glm::dvec2 reach(0.0);
  mapX.create(model.height, model.width, CV_32F);
  mapY.create(model.height, model.width, CV_32F);
  for (int y = 0; y < model.height; ++y)
    for (int x = 0; x < model.width; ++x) {
      const glm::dvec2 ray = rayThrough(model, {x, y});
      reach = glm::max(reach, glm::abs(ray));
      mapX.at<float>(y, x) = static_cast<float>(ray.x);
      mapY.at<float>(y, x) = static_cast<float>(ray.y);
    }
  const double focal = options.superSampling * model.fx;
  drawnWidth = 2 * static_cast<int>(std::ceil(reach.x * focal + 2.0));
  drawnHeight = 2 * static_cast<int>(std::ceil(reach.y * focal + 2.0));
  // Rows are read from the bottom up.
  mapX = mapX * focal + (0.5 * drawnWidth - 0.5);
  mapY = mapY * -focal + (0.5 * drawnHeight - 0.5);
  cv::Mat fixed, fraction;
  cv::convertMaps(mapX, mapY, fixed, fraction, CV_16SC2);
  mapX = fixed;
  mapY = fraction;
  // Of one body alone a small window that goes with it will do.
  constexpr int kSmall = 400;
  const bool isSmall = !options.room && bodies.size() == 1;
  windowWidth = isSmall ? std::min(drawnWidth, kSmall * options.superSampling) : drawnWidth;
  windowHeight = isSmall ? std::min(drawnHeight, kSmall * options.superSampling) : drawnHeight;
  window->SetSize(windowWidth, windowHeight);
  auto* camera = renderer->GetActiveCamera();
  camera->SetPosition(0, 0, 0);
  camera->SetFocalPoint(0, 0, 1);
  camera->SetViewUp(0, -1, 0);
  camera->SetViewAngle(2.0 * std::atan(0.5 * drawnHeight / focal) * 180.0 / std::numbers::pi);
  camera->SetClippingRange(50.0, 4000.0);
  whole->DeepCopy(camera->GetProjectionTransformMatrix(static_cast<double>(drawnWidth) / drawnHeight, -1.0, 1.0));
}

PaperCamera::State::Parts PaperCamera::State::parts(const std::vector<std::vector<glm::dmat4>>& poses) const {
  if (options.room) return {cv::Rect(0, 0, model.width, model.height), cv::Rect(0, 0, drawnWidth, drawnHeight)};
  glm::dvec2 low(1e9), high(-1e9), drawnLow(1e9), drawnHigh(-1e9);
  const double focal = options.superSampling * model.fx;
  for (const auto& each : poses)
    for (std::size_t b = 0; b < bodies.size(); ++b)
      for (const Marker& marker : bodies[b].markers)
        for (const auto& corner : marker.corners_mm) {
          const glm::dvec3 p = glm::dvec3(each[b] * glm::dvec4(1.4 * corner, 1.0));  // with the paper around
          if (p.z < 50.0) continue;
          const glm::dvec2 seen = pixelOf(model, p);
          const glm::dvec2 at{focal * p.x / p.z + 0.5 * drawnWidth, 0.5 * drawnHeight - focal * p.y / p.z};
          low = glm::min(low, seen);
          high = glm::max(high, seen);
          drawnLow = glm::min(drawnLow, at);
          drawnHigh = glm::max(drawnHigh, at);
        }
  const auto around = [](const glm::dvec2& from, const glm::dvec2& to, double margin, int width, int height) {
    return cv::Rect(cv::Point(static_cast<int>(from.x - margin), static_cast<int>(from.y - margin)),
                    cv::Point(static_cast<int>(to.x + margin), static_cast<int>(to.y + margin))) &
           cv::Rect(0, 0, width, height);
  };
  Parts found{around(low, high, 16.0, model.width, model.height), around(drawnLow, drawnHigh, 48.0, drawnWidth, drawnHeight)};
  if (windowWidth < drawnWidth || windowHeight < drawnHeight) {
    const glm::dvec2 middle = 0.5 * (drawnLow + drawnHigh);
    found.drawn =
        cv::Rect(std::clamp(static_cast<int>(middle.x) - windowWidth / 2, 0, drawnWidth - windowWidth),
                 std::clamp(static_cast<int>(middle.y) - windowHeight / 2, 0, drawnHeight - windowHeight), windowWidth, windowHeight);
  }
  return found;
}

cv::Mat PaperCamera::State::drawn(const std::vector<glm::dmat4>& poses, const cv::Rect& part) {
  for (std::size_t b = 0; b < actors.size(); ++b)
    for (auto& actor : actors[b]) setMatrix(actor, poses[b]);
  int left = part.x, bottom = part.y;
  if (windowWidth < drawnWidth || windowHeight < drawnHeight) {
    // The part fills the window: x and y of the whole image's clip space, from -1 to 1, are stretched and moved.
    vtkNew<vtkMatrix4x4> onto, projection;
    const double byX = static_cast<double>(drawnWidth) / windowWidth, byY = static_cast<double>(drawnHeight) / windowHeight;
    onto->SetElement(0, 0, byX);
    onto->SetElement(0, 3, byX - 1.0 - 2.0 * part.x / windowWidth);
    onto->SetElement(1, 1, byY);
    onto->SetElement(1, 3, byY - 1.0 - 2.0 * part.y / windowHeight);
    vtkMatrix4x4::Multiply4x4(onto, whole, projection);
    auto* camera = renderer->GetActiveCamera();
    camera->UseExplicitProjectionTransformMatrixOn();
    camera->SetExplicitProjectionTransformMatrix(projection);
    left = bottom = 0;
  }
  window->Render();
  window->GetRGBACharPixelData(left, bottom, left + part.width - 1, bottom + part.height - 1, 0, read);
  const cv::Mat all(part.height, part.width, CV_8UC4, read->GetPointer(0));
  cv::Mat red;
  cv::extractChannel(all, red, 0);
  return red;
}

cv::Mat PaperCamera::State::throughLens(const cv::Mat& image, const Parts& parts) const {
  cv::Mat blurred, seen;
  const double blur = options.lensBlur_px * options.superSampling;
  if (blur > 0.0)
    cv::GaussianBlur(image, blurred, cv::Size(0, 0), blur);
  else
    blurred = image;
  if (options.superSampling == 2) cv::blur(blurred, blurred, cv::Size(3, 3));  // about a pixel's own area
  const cv::Mat places = mapX(parts.seen) - cv::Scalar(parts.drawn.x, parts.drawn.y);
  cv::remap(blurred, seen, places, mapY(parts.seen), cv::INTER_LINEAR, cv::BORDER_CONSTANT, cv::Scalar::all(51));
  return seen;
}

PaperCamera::PaperCamera(const CameraModel& model, const std::vector<MarkerBody>& bodies, const PaperCameraOptions& options)
    : state_(std::make_unique<State>()) {
  state_->bodies = bodies;
  state_->model = model;
  state_->options = options;
  state_->window->SetOffScreenRendering(1);
  state_->window->SetMultiSamples(0);
  state_->window->AddRenderer(state_->renderer);
  state_->renderer->SetBackground(0.2, 0.2, 0.2);
  for (const MarkerBody& body : bodies) {
    auto& actors = state_->actors.emplace_back();
    for (const Marker& marker : body.markers) state_->addMarker(body, marker, body.isBoard ? 5.0 : options.paperMargin_mm, actors);
  }
  if (options.room) state_->addBackground();
  state_->coverShape->SetNumberOfSides(24);
  state_->coverShape->SetNormal(0, 0, -1);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(state_->coverShape->GetOutputPort());
  state_->cover->SetMapper(mapper);
  state_->cover->GetProperty()->LightingOff();
  state_->cover->GetProperty()->SetColor(0.42, 0.42, 0.42);
  state_->renderer->AddActor(state_->cover);
  state_->prepareLens();
  std::mt19937_64 random(options.seed + 77);
  std::normal_distribution<float> normal(0.0F, 1.0F);
  state_->noise.resize((1u << 20) + 4096u);
  for (float& each : state_->noise) each = normal(random);
}

PaperCamera::~PaperCamera() = default;

GreyImage PaperCamera::image(const PaperShot& shot) {
  State& s = *state_;
  s.cover->SetVisibility(shot.cover ? 1 : 0);
  if (shot.cover) {
    s.coverShape->SetCenter(shot.cover->at_camera.x, shot.cover->at_camera.y, shot.cover->at_camera.z);
    s.coverShape->SetRadius(shot.cover->radius_mm);
  }
  const int count = static_cast<int>(shot.poses.size());
  const State::Parts parts = s.parts(shot.poses);
  GreyImage image(s.model.width, s.model.height, 60);
  if (parts.seen.empty() || parts.drawn.empty()) return image;
  cv::Mat seen;
  if (count == 1) {
    s.throughLens(s.drawn(shot.poses[0], parts.drawn), parts).convertTo(seen, CV_32F);
  } else if (s.options.readout_frames <= 0.0) {
    cv::Mat sum = cv::Mat::zeros(parts.drawn.size(), CV_16U);
    for (const auto& poses : shot.poses) cv::add(sum, s.drawn(poses, parts.drawn), sum, cv::noArray(), CV_16U);
    cv::Mat mean;
    sum.convertTo(mean, CV_8U, 1.0 / count);
    s.throughLens(mean, parts).convertTo(seen, CV_32F);
  } else {
    // Each row has the exposure's share of the poses, later ones further down.
    seen = cv::Mat::zeros(parts.seen.size(), CV_32F);
    const int exposed = std::max(1, static_cast<int>(std::lround(count * (1.0 - s.options.readout_frames))));
    for (int n = 0; n < count; ++n) {
      const cv::Mat one = s.throughLens(s.drawn(shot.poses[static_cast<std::size_t>(n)], parts.drawn), parts);
      for (int y = 0; y < one.rows; ++y) {
        const int first = static_cast<int>(std::lround(static_cast<double>(parts.seen.y + y) / s.model.height * (count - exposed)));
        if (n < first || n >= first + exposed) continue;
        for (int x = 0; x < one.cols; ++x)
          seen.at<float>(y, x) += static_cast<float>(one.at<unsigned char>(y, x)) / static_cast<float>(exposed);
      }
    }
  }
  s.encode(seen, parts.seen, shot, image);
  return image;
}

void PaperCamera::State::encode(const cv::Mat& seen, const cv::Rect& part, const PaperShot& shot, GreyImage& image) const {
  std::array<float, 1024> encoded{};  // light to grey
  for (std::size_t n = 0; n < encoded.size(); ++n)
    encoded[n] = 255.0F * static_cast<float>(std::pow(std::min(1.0, static_cast<double>(n) / 1020.0), 1.0 / options.gamma));
  std::mt19937_64 random(shot.seed);
  const glm::dvec2 towards(std::cos(shot.lightAngle_rad), std::sin(shot.lightAngle_rad));
  const auto lightStep = static_cast<float>(shot.exposure * -shot.unevenLight * towards.x / model.width);
  const auto deviation = static_cast<float>(options.noise_grey);
  for (int y = 0; y < part.height; ++y) {
    const float* const from = seen.ptr<float>(y);
    const float* const grain = noise.data() + random() % ((1u << 20) + 4096u - static_cast<unsigned>(model.width));
    std::uint8_t* const to = viewOf(image).row(part.y + y) + part.x;
    const double v = static_cast<double>(part.y + y) / model.height - 0.5, u = static_cast<double>(part.x) / model.width - 0.5;
    const auto light0 = static_cast<float>(shot.exposure * (1.0 - shot.unevenLight * (0.5 + towards.y * v + towards.x * u)));
    for (int x = 0; x < part.width; ++x) {
      const float light = std::clamp(4.0F * from[x] * (light0 + lightStep * static_cast<float>(x)), 0.0F, 1022.0F);
      const auto n = static_cast<std::size_t>(light);
      const float share = light - static_cast<float>(n);
      const float grey = encoded[n] + share * (encoded[n + 1] - encoded[n]) + deviation * grain[x] + 0.5F;
      to[x] = static_cast<std::uint8_t>(std::clamp(grey, 0.0F, 255.0F));
    }
  }
}

}  // namespace ew::camera_truth
