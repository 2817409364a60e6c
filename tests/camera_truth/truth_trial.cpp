#include "camera_truth/truth_trial.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <stdexcept>

namespace ew::camera_truth {
namespace {

constexpr double kFlip_rad = 10.0 * std::numbers::pi / 180.0;

double processorTime_s() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void add(TrialErrors& errors, const TruthError& error) {
  errors.place_mm.push_back(error.place_mm);
  errors.turn_deg.push_back(error.turn_rad * 180.0 / std::numbers::pi);
  errors.flipped += error.turn_rad > kFlip_rad ? 1 : 0;
}

/// A thumb over an edge of one of the markers in sight.
PaperShot::Cover thumbOn(const MarkerBody& body, const glm::dmat4& bodyToCamera, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const Marker& marker = body.markers[random() % body.markers.size()];
  const std::size_t side = random() % 4;
  const glm::dvec3 at = 0.5 * (marker.corners_mm[side] + marker.corners_mm[(side + 1) % 4]);
  glm::dvec3 place = glm::dvec3(bodyToCamera * glm::dvec4(at, 1.0));
  place *= 1.0 - 25.0 / place.z;
  return {place, std::uniform_real_distribution<double>(4.0, 14.0)(random)};
}

void compareCorners(const CameraSight& sight, const std::vector<MarkerBody>& bodies, const CameraModel& model,
                    const std::vector<glm::dmat4>& truth, TrialResult& result) {
  for (const MarkerSight& seen : sight.markers) {
    const MarkerBody& body = bodies[static_cast<std::size_t>(seen.body)];
    if (!seen.used) continue;
    for (const Marker& marker : body.markers) {
      if (marker.id != seen.id) continue;
      const auto& c = seen.corners_px;
      const glm::dvec2 middle = 0.25 * (c[0] + c[1] + c[2] + c[3]);
      for (std::size_t n = 0; n < 4; ++n) {
        const glm::dmat4& pose = truth[static_cast<std::size_t>(seen.body)];
        const glm::dvec2 at = pixelOf(model, glm::dvec3(pose * glm::dvec4(marker.corners_mm[n], 1.0)));
        result.corners_px.push_back(glm::distance(at, c[n]));
        result.outwards_px.push_back(glm::dot(c[n] - at, glm::normalize(at - middle)));
      }
    }
  }
}

struct Trial {
  const TrialOptions& options;
  CameraModel model = webcam();
  std::vector<MarkerBody> bodies{boxBody()};
  TrialResult result = {};

  void frame(CameraTracker& tracker, PaperCamera& camera, const TruthMotion& motion, double time_s, std::uint64_t seed, bool isCovered);
  void take(const CameraSight& sight, const std::vector<glm::dmat4>& truth);
};

void Trial::frame(CameraTracker& tracker, PaperCamera& camera, const TruthMotion& motion, double time_s, std::uint64_t seed,
                  bool isCovered) {
  const auto posesAt = [&](double t_s) {
    auto poses = motion.at(t_s);
    poses.resize(bodies.size());
    return poses;
  };
  PaperShot shot;
  for (int n = 0; n < options.subFrames; ++n)
    shot.poses.push_back(posesAt(time_s + options.exposure_s * ((n + 0.5) / options.subFrames - 0.5)));
  const auto truth = posesAt(time_s);
  shot.unevenLight = options.unevenLight;
  shot.lightAngle_rad = static_cast<double>(seed % 628) * 0.01;
  shot.seed = seed;
  if (isCovered) shot.cover = thumbOn(bodies[0], truth[0], seed / 64);
  const GreyImage image = camera.image(shot);
  const double begin_s = processorTime_s();
  const CameraSight sight = tracker.track(viewOf(image), time_s);
  result.track_ms.push_back(1e3 * (processorTime_s() - begin_s));
  ++result.frames;
  compareCorners(sight, bodies, model, truth, result);
  take(sight, truth);
  if (options.plainEvery > 0 && result.frames % options.plainEvery == 0) {
    ++result.plainFrames;
    if (const auto plain = plainBoardPoses(model, {bodies[0]}, viewOf(image)).front())
      add(result.plain, errorOf(plain->matrix, truth[0], glm::dvec3(bodies[0].probeToTool.matrix[3])));
  }
}

void Trial::take(const CameraSight& sight, const std::vector<glm::dmat4>& truth) {
  const glm::dvec3 face(bodies[0].probeToTool.matrix[3]);
  const BodySight& probe = sight.bodies[0];
  switch (probe.state) {
    case TrackingState::live:
      ++result.live;
      break;
    case TrackingState::outOfRange:
      ++result.outOfRange;
      break;
    case TrackingState::invalid:
      ++result.invalid;
      break;
    default:
      ++result.outOfView;
      break;
  }
  result.ambiguous += probe.ambiguous ? 1 : 0;
  if (probe.state == TrackingState::live) add(result.toCamera, errorOf(probe.bodyToCamera.matrix, truth[0], face));
  if (bodies.size() < 2 || sight.bodies[1].state != TrackingState::live) return;
  const glm::dmat4 board = sight.bodies[1].bodyToCamera.matrix;
  add(result.boardToCamera, errorOf(board, truth[1], glm::dvec3(0.0)));
  if (probe.state == TrackingState::live)
    add(result.toBoard, errorOf(glm::inverse(board) * probe.bodyToCamera.matrix, glm::inverse(truth[1]) * truth[0], face));
}

}  // namespace

TrialResult runTrial(const TrialOptions& options) {
  Trial trial{options};
  if (options.board) trial.bodies.push_back(boardBody());
  auto tracker = CameraTracker::make(trial.model, trial.bodies, options.tracking);
  if (!tracker) throw std::runtime_error(tracker.error().sentence());
  PaperCamera camera(trial.model, trial.bodies, options.paper);
  for (int s = 0; s < options.sequences; ++s) {
    const std::uint64_t seed = options.seed * 1000003u + static_cast<std::uint64_t>(s);
    const TruthMotion motion(trial.model, trial.bodies, options.motion, seed);
    const bool isCovered = static_cast<double>((seed * 7919u) % 1000u) < 1000.0 * options.covered;
    tracker->forget();
    for (int f = 0; f < options.framesEach; ++f)
      trial.frame(*tracker, camera, motion, f / options.frames_hz, seed * 64u + static_cast<std::uint64_t>(f) % 64u, isCovered);
  }
  return std::move(trial.result);
}

std::string textOf(const TrialResult& r) {
  std::string text;
  char line[400];
  const auto put = [&](const char* name, const std::vector<double>& values, const char* unit) {
    if (values.empty()) return;
    std::snprintf(line, sizeof line, "%-26s median %8.4f  95 %% %8.4f  99 %% %8.4f  worst %8.4f %s\n", name, percentile(values, 0.5),
                  percentile(values, 0.95), percentile(values, 0.99), percentile(values, 1.0), unit);
    text += line;
  };
  std::snprintf(line, sizeof line,
                "frames %d: live %d, out of range %d (ambiguous %d), out of view %d, invalid %d; FLIPPED %d (relative %d)\n", r.frames,
                r.live, r.outOfRange, r.ambiguous, r.outOfView, r.invalid, r.toCamera.flipped + r.boardToCamera.flipped, r.toBoard.flipped);
  text += line;
  put("to the camera", r.toCamera.place_mm, "mm");
  put("to the camera", r.toCamera.turn_deg, "degrees");
  put("to the board", r.toBoard.place_mm, "mm");
  put("to the board", r.toBoard.turn_deg, "degrees");
  put("board to the camera", r.boardToCamera.place_mm, "mm");
  put("board to the camera", r.boardToCamera.turn_deg, "degrees");
  put("corners", r.corners_px, "px");
  double bias = 0.0;
  for (const double each : r.outwards_px) bias += each / static_cast<double>(r.outwards_px.size());
  std::snprintf(line, sizeof line, "corners lie outwards by %.4f px on average (%zu)\n", bias, r.outwards_px.size());
  text += line;
  put("time", r.track_ms, "ms");
  if (r.plainFrames > 0) {
    std::snprintf(line, sizeof line, "estimatePoseBoard: %zu poses in %d frames, FLIPPED %d\n", r.plain.place_mm.size(), r.plainFrames,
                  r.plain.flipped);
    text += line;
    put("estimatePoseBoard", r.plain.place_mm, "mm");
    put("estimatePoseBoard", r.plain.turn_deg, "degrees");
  }
  return text;
}

}  // namespace ew::camera_truth
