#include "bench/bench_tracking.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <optional>

#include "bench/tools/bench_parts.h"
#include "ew/core/json_fields.h"
#include "ew/core/word_table.h"
#include "ew/io/json_files.h"
#include "ew/trackers/camera_tracking.h"
#include "ew/tracking/pose_filter.h"

namespace ew {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr WordTable<FilterKind, 4> kFilterKindWords{
    {{"automatic", FilterKind::automatic}, {"none", FilterKind::none}, {"kalman", FilterKind::kalman}, {"one_euro", FilterKind::oneEuro}}};
const char* wordOf(FilterKind kind) { return wordIn(kFilterKindWords, kind); }

struct TruthFrame {
  GreyImage image;
  double time_s = 0.0;
  int sequence = 0;
  std::vector<Transform<frame::Camera, frame::Tool>> poses;
};

struct TruthViews {
  CameraModel camera;
  std::vector<MarkerBody> bodies;
  std::vector<TruthFrame> frames;
};

Result<GreyImage> readPgm(const fs::path& file, const CameraModel& camera) {
  std::ifstream in(file, std::ios::binary);
  std::string magic;
  int width = 0, height = 0, most = 0;
  in >> magic >> width >> height >> most;
  in.get();
  if (!in || magic != "P5" || width != camera.width || height != camera.height || most != 255)
    return failure(ErrorCode::badHeader,
                   say<"%1 is no grey PGM image of %2 x %3 pixels; make the views again.">(file.filename(), camera.width, camera.height));
  GreyImage image(width, height);
  in.read(reinterpret_cast<char*>(image.pixels.data()), static_cast<std::streamsize>(image.pixels.size()));
  if (!in) return failure(ErrorCode::truncated, say<"%1 ends too early; make the views again.">(file.filename()));
  return image;
}

MarkerBody bodyFrom(const JsonFields& fields) {
  MarkerBody body;
  body.id = body.name = fields.text("id");
  body.isBoard = fields.flag("is_board");
  body.dictionary = fields.text("dictionary");
  body.probeToTool.matrix[3] = glm::dvec4(fields.point("face_mm", 1e4), 1.0);
  for (const JsonFields& each : fields.objects("markers", 1, 1000)) {
    Marker marker;
    marker.id = static_cast<int>(each.whole("id", 0, 100000));
    const auto corners = each.numbers("corners_mm", 12, 12, -1e4, 1e4);
    for (std::size_t n = 0; n < corners.size(); ++n) marker.corners_mm[n / 3][static_cast<int>(n % 3)] = corners[n];
    body.markers.push_back(marker);
  }
  return body;
}

Result<TruthViews> readViews(const TrackingBenchOptions& options, Progress& progress) {
  const Message where = verbatim("views.json");
  const auto document = readJsonFile(options.views / "views.json", where, 64u << 20);
  if (!document) return passOn(document.error());
  JsonReading reading(where);
  const JsonFields fields(*document, reading);
  TruthViews views;
  for (const JsonFields& each : fields.objects("bodies", 1, 16)) views.bodies.push_back(bodyFrom(each));
  const auto camera = parseCameraModel(fields.object("camera").value().dump(), where);
  if (!camera) return passOn(camera.error());
  views.camera = *camera;
  for (const JsonFields& each : fields.objects("frames", 1, 1000000)) {
    if (options.frames > 0 && static_cast<int>(views.frames.size()) >= options.frames) break;
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
    TruthFrame frame;
    frame.time_s = each.number("time_s", 0.0, 1e9);
    frame.sequence = static_cast<int>(each.whole("sequence", 0, 1000000));
    const auto poses = each.numbers("poses", 16 * views.bodies.size(), 16 * views.bodies.size(), -1e6, 1e6);
    const std::string file = each.text("file");
    if (reading.problem()) return passOn(*reading.problem());
    for (std::size_t b = 0; b < views.bodies.size(); ++b) {
      std::array<double, 16> rows{};
      std::copy_n(poses.begin() + static_cast<std::ptrdiff_t>(16 * b), 16, rows.begin());
      frame.poses.push_back({matrixFromRows(rows)});
    }
    auto image = readPgm(options.views / fs::path(file).filename(), views.camera);
    if (!image) return passOn(image.error());
    frame.image = *std::move(image);
    views.frames.push_back(std::move(frame));
  }
  if (reading.problem()) return passOn(*reading.problem());
  return views;
}

/// Each pixel the mean of four.
GreyImage halved(const GreyImage& image) {
  GreyImage half(image.width / 2, image.height / 2);
  for (int y = 0; y < half.height; ++y) {
    const std::uint8_t* const above = viewOf(image).row(2 * y);
    const std::uint8_t* const below = viewOf(image).row(2 * y + 1);
    for (int x = 0; x < half.width; ++x) {
      const std::ptrdiff_t left = 2 * static_cast<std::ptrdiff_t>(x);
      viewOf(half).at(x, y) = static_cast<std::uint8_t>((above[left] + above[left + 1] + below[left] + below[left + 1] + 2) / 4);
    }
  }
  return half;
}

struct TrackingSetting {
  std::string name;
  bool half = false;
  int markers = 12;
  CornerMethod corners = CornerMethod::edges;
  FilterKind filter = FilterKind::none;
  bool plain = false;
};

std::vector<TrackingSetting> trackingSettings() {
  return {{"edges", false, 12, CornerMethod::edges, FilterKind::none, false},
          {"edges, half the resolution", true, 12, CornerMethod::edges, FilterKind::none, false},
          {"edges, two markers", false, 2, CornerMethod::edges, FilterKind::none, false},
          {"edges, one marker", false, 1, CornerMethod::edges, FilterKind::none, false},
          {"edges, Kalman filter", false, 12, CornerMethod::edges, FilterKind::kalman, false},
          {"edges, One Euro filter", false, 12, CornerMethod::edges, FilterKind::oneEuro, false},
          {"OpenCV's saddle points", false, 12, CornerMethod::subPix, FilterKind::none, false},
          {"OpenCV's saddle points, half the resolution", true, 12, CornerMethod::subPix, FilterKind::none, false},
          {"whole-pixel contours", false, 12, CornerMethod::contour, FilterKind::none, false},
          {"estimatePoseBoard", false, 12, CornerMethod::subPix, FilterKind::none, true},
          {"estimatePoseBoard, half the resolution", true, 12, CornerMethod::subPix, FilterKind::none, true}};
}

constexpr WordTable<CornerMethod, 3> kCornerMethodWords{
    {{"contour", CornerMethod::contour}, {"saddle", CornerMethod::subPix}, {"edges", CornerMethod::edges}}};
const char* nameOf(CornerMethod method) { return wordIn(kCornerMethodWords, method); }

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// One setting over all frames.
class TrackingRun {
 public:
  TrackingRun(const TruthViews& views, const TrackingSetting& setting) : views_(views), setting_(setting) {}

  Result<json> measured(Progress& progress) {
    auto model =
        setting_.half ? scaledTo(views_.camera, views_.camera.width / 2, views_.camera.height / 2) : Result<CameraModel>(views_.camera);
    if (!model) return passOn(model.error());
    CameraTrackingOptions options;
    options.mostMarkers = setting_.markers;
    options.corners = setting_.corners;
    options.halfSearch = !setting_.half;
    if (setting_.corners != CornerMethod::edges) options.largestRms_px = 3.0;  // else what is worse would not be shown
    auto tracker = CameraTracker::make(*model, views_.bodies, options);
    if (!tracker) return passOn(tracker.error());
    int sequence = -1;
    for (const TruthFrame& frame : views_.frames) {
      if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
      if (frame.sequence != sequence) {
        tracker->forget();
        filter_.reset();
      }
      sequence = frame.sequence;
      const GreyImage smaller = setting_.half ? halved(frame.image) : GreyImage{};
      const ImageView<const std::uint8_t> image = setting_.half ? viewOf(smaller) : viewOf(frame.image);
      const double begin_s = threadTime_s();
      const auto pose = setting_.plain ? plainBoardPoses(*model, {views_.bodies[0]}, image).front() : shown(*tracker, image, frame.time_s);
      times_us_.push_back(1e6 * (threadTime_s() - begin_s));
      if (pose) compare(*pose, frame);
    }
    return row();
  }

 private:
  static std::optional<Transform<frame::Camera, frame::Tool>> shown(CameraTracker& tracker, ImageView<const std::uint8_t> image,
                                                                    double time_s) {
    const BodySight body = tracker.track(image, time_s).bodies[0];
    if (body.state != TrackingState::live) return {};
    return body.bodyToCamera;
  }
  void compare(const Transform<frame::Camera, frame::Tool>& pose, const TruthFrame& frame) {
    const auto& faceToTool = views_.bodies[0].probeToTool;
    Transform<frame::Camera, frame::Probe> found = pose * faceToTool;
    if (setting_.filter != FilterKind::none) {
      filter_.add(frame.time_s, renamed<frame::Tracker, frame::Probe>(found));
      if (!filter_.empty()) found = renamed<frame::Camera, frame::Probe>(filter_.at(frame.time_s));
    }
    const Transform<frame::Camera, frame::Probe> truth = frame.poses[0] * faceToTool;
    place_mm_.push_back(glm::distance(glm::dvec3(found.matrix[3]), glm::dvec3(truth.matrix[3])));
    const glm::dmat3 turn = glm::transpose(glm::dmat3(truth.matrix)) * glm::dmat3(found.matrix);
    const glm::dvec3 axis{turn[1][2] - turn[2][1], turn[2][0] - turn[0][2], turn[0][1] - turn[1][0]};
    turn_deg_.push_back(std::atan2(glm::length(axis), turn[0][0] + turn[1][1] + turn[2][2] - 1.0) * 180.0 / std::numbers::pi);
  }
  [[nodiscard]] json row() const {
    return {{"name", setting_.name},
            {"resolution", setting_.half ? "half" : "full"},
            {"markers", setting_.markers},
            {"corners", nameOf(setting_.corners)},
            {"filter", wordOf(setting_.filter)},
            {"peer", setting_.plain},
            {"median_us", medianOf(times_us_)},
            {"p95_us", shareOf(times_us_, 0.95, kNone)},
            {"face_mm", shareOf(place_mm_, 0.5, kNone)},
            {"face_p95_mm", shareOf(place_mm_, 0.95, kNone)},
            {"turn_deg", shareOf(turn_deg_, 0.5, kNone)},
            {"turn_p95_deg", shareOf(turn_deg_, 0.95, kNone)},
            {"shown", static_cast<double>(place_mm_.size()) / static_cast<double>(views_.frames.size())},
            {"flipped", std::count_if(turn_deg_.begin(), turn_deg_.end(), [](double each) { return each > 10.0; })}};
  }

  const TruthViews& views_;
  const TrackingSetting& setting_;
  PoseFilter filter_{PoseFilterOptions{.kind = setting_.filter, .predict = false}};
  std::vector<double> times_us_, place_mm_, turn_deg_;
};

}  // namespace

Result<json> benchTracking(const TrackingBenchOptions& options, Progress& progress) {
  const auto views = readViews(options, progress);
  if (!views) return passOn(views.error());
  json report = {{"machine", machineName()}, {"frames", views->frames.size()}, {"results", json::array()}};
  const auto settings = trackingSettings();
  for (std::size_t n = 0; n < settings.size(); ++n) {
    progress.report(say<"Following the probe">(), static_cast<double>(n) / static_cast<double>(settings.size()));
    auto row = TrackingRun(*views, settings[n]).measured(progress);
    if (!row) return passOn(row.error());
    report["results"].push_back(*std::move(row));
  }
  return report;
}

}  // namespace ew
