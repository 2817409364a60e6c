#include "ew/trackers/camera_tracking.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <set>

#include "camera_corners.h"
#include "camera_markers.h"
#include "camera_pose.h"
#include "ew/core/contract.h"
#include "marker_dictionary.h"

namespace ew {
namespace {

constexpr double kForgetAfter_s = 0.2;       // a hand turns a probe by ten degrees in that time
constexpr double kCertain = 60.0;            // evidence from which on the other pose of a flat view is out of the question
constexpr double kCertainRatio = 1.6;        // ... and how many times it has to fit worse
constexpr double kFastest_radPerS = 3.0;     // that a probe is turned
constexpr double kHarmlessAngle_rad = 0.03;  // two poses that near do not make a flip
constexpr double kMisread_rad = 0.6;         // that one marker alone turned a probe beyond what a hand does: it was read as another one

/// What is kept of a body from one image to the next.
struct BodyMemory {
  glm::dmat4 bodyToCamera{1.0};
  double seen_s = -1e9;  ///< last live
  glm::dvec2 face_px{0.0};
  glm::dvec2 velocity_pxPerS{0.0};
  bool hasVelocity = false;
};

/// A flat square with corners in order, by half a millimetre.
bool isFlatSquare(const Marker& marker) {
  const auto& c = marker.corners_mm;
  const double side = glm::distance(c[0], c[1]), slack = std::max(0.5, 0.02 * side);
  if (!(side > 1.0 && side < 2000.0)) return false;
  for (std::size_t n = 1; n < 4; ++n)
    if (!(std::abs(glm::distance(c[n], c[(n + 1) % 4]) - side) < slack)) return false;
  return std::abs(glm::distance(c[0], c[2]) - std::sqrt(2.0) * side) < slack && glm::distance(c[0] + c[2], c[1] + c[3]) < 2.0 * slack;
}

/// Whether the squares inside of measured corners are those of the marker. The detector reads small markers from an image of half the
/// size, and a thumb over one can leave what another one looks like: a pose from that is sure and wrong.
bool showsSquares(ImageView<const std::uint8_t> grey, const std::array<glm::dvec2, 4>& corners_px, const MarkerSquares& squares) {
  const auto& c = corners_px;
  // Projective: p = (c0 + u a + v b) / (1 + u g + v h), from the unit square.
  const glm::dvec2 d1 = c[1] - c[2], d2 = c[3] - c[2], s = c[0] - c[1] + c[2] - c[3];
  const double across = d1.x * d2.y - d2.x * d1.y;
  if (std::abs(across) < 1.0) return false;
  const double g = (s.x * d2.y - d2.x * s.y) / across, h = (d1.x * s.y - s.x * d1.y) / across;
  std::vector<double> greys;
  double sums[2] = {0.0, 0.0};
  int counts[2] = {0, 0};
  for (int row = 0; row < squares.side; ++row)
    for (int column = 0; column < squares.side; ++column) {
      const double u = (column + 0.5) / squares.side, v = (row + 0.5) / squares.side;
      const glm::dvec2 at = (c[0] + u * (c[1] - c[0] + g * c[1]) + v * (c[3] - c[0] + h * c[3])) / (1.0 + u * g + v * h);
      const int x = static_cast<int>(std::lround(at.x)), y = static_cast<int>(std::lround(at.y));
      if (x < 0 || y < 0 || x >= grey.width || y >= grey.height) return false;
      greys.push_back(grey.at(x, y));
      const int isBlack = squares.isBlack[greys.size() - 1];
      sums[isBlack] += greys.back();
      ++counts[isBlack];
    }
  const double middle = 0.5 * (sums[0] / std::max(1, counts[0]) + sums[1] / std::max(1, counts[1]));
  int wrong = 0;
  for (std::size_t n = 0; n < greys.size(); ++n) wrong += (greys[n] < middle) != (squares.isBlack[n] == 1) ? 1 : 0;
  // Two markers of a set differ in many more.
  return wrong * 16 <= static_cast<int>(greys.size());
}

struct TrackedBody {
  MarkerBody body;
  cv::Ptr<cv::aruco::Dictionary> dictionary;
  std::map<int, const Marker*> byId;
  std::map<int, MarkerSquares> squares;
  glm::dvec3 face_mm{0.0};  ///< where errors count: the transducer face, or a board's middle
  BodyMemory memory;
};

}  // namespace

struct CameraTracker::State {
  CameraModel model;
  CameraTrackingOptions options;
  std::vector<TrackedBody> bodies;
  std::vector<std::string> dictionaries;  ///< in use
  double searched_s = -1e9;
  double focal_px = 0.0;
  std::array<float, 256> light{};
  MarkerBleed bleed;
  double bleed_s = -1e9;  ///< when it was found last

  [[nodiscard]] std::vector<SearchRegion> regions(double time_s, const cv::Mat& grey, bool& whole);
  [[nodiscard]] std::optional<SearchRegion> regionOf(const TrackedBody& each, double time_s) const;
  [[nodiscard]] std::vector<MarkerSight> find(const cv::Mat& grey, const std::vector<SearchRegion>& where) const;
  [[nodiscard]] std::optional<MarkerCorners> measured(const cv::Mat& grey, const MarkerSight& found) const;
  void trackBody(const cv::Mat& image, std::size_t index, std::vector<MarkerSight*> found, CameraSight& sight, double time_s);
  void learnBleed(const BodySight& sight, const BodyEstimate& estimate, double time_s);
  void judge(BodySight& sight, const BodyEstimate& estimate, const BodyMemory& memory, double time_s) const;
  void chooseOfTwo(BodySight& sight, const BodyEstimate& estimate, const BodyMemory& memory, double since_s) const;
  void remember(TrackedBody& each, BodySight& sight, const std::vector<MarkerSight>& markers, int body, double time_s) const;
};

std::optional<SearchRegion> CameraTracker::State::regionOf(const TrackedBody& each, double time_s) const {
  const double since_s = time_s - each.memory.seen_s;
  if (!(since_s >= 0.0 && since_s < kForgetAfter_s)) return {};
  glm::dvec2 low(1e9), high(-1e9);
  double smallest_px = 1e9;
  for (const Marker& marker : each.body.markers) {
    std::array<glm::dvec2, 4> at;
    for (std::size_t n = 0; n < 4; ++n) {
      const glm::dvec3 p = glm::dvec3(each.memory.bodyToCamera * glm::dvec4(marker.corners_mm[n], 1.0));
      if (p.z < 20.0) return {};
      at[n] = pixelOf(model, p);
      low = glm::min(low, at[n]);
      high = glm::max(high, at[n]);
    }
    const glm::dvec3 outward = glm::dmat3(each.memory.bodyToCamera) * outwardOf(marker);
    const glm::dvec3 middle = glm::dvec3(each.memory.bodyToCamera * glm::dvec4(middleOf(marker), 1.0));
    if (glm::dot(outward, middle) < -0.35 * glm::length(middle)) smallest_px = std::min(smallest_px, glm::distance(at[0], at[1]));
  }
  const glm::dvec2 moved = each.memory.hasVelocity ? each.memory.velocity_pxPerS * since_s : glm::dvec2(0.0);
  const double margin = 24.0 + 0.12 * std::max(high.x - low.x, high.y - low.y) + 0.6 * glm::length(moved);
  low += moved - margin;
  high += moved + margin;
  low = glm::clamp(low, glm::dvec2(0.0), glm::dvec2(model.width, model.height));
  high = glm::clamp(high, glm::dvec2(0.0), glm::dvec2(model.width, model.height));
  const cv::Rect at(static_cast<int>(low.x), static_cast<int>(low.y), static_cast<int>(high.x - low.x), static_cast<int>(high.y - low.y));
  // Half the size is enough where a module of the smallest marker in sight keeps almost three pixels.
  return SearchRegion{at, smallest_px > 44.0 && smallest_px < 1e8 ? 2 : 1};
}

/// Around every body that was seen just now; the whole image where one was not, and from time to time.
std::vector<SearchRegion> CameraTracker::State::regions(double time_s, const cv::Mat& grey, bool& whole) {
  std::vector<SearchRegion> found;
  if (options.followsRegions && time_s - searched_s < options.searchEvery_s) {
    for (const TrackedBody& each : bodies)
      if (const auto region = regionOf(each, time_s)) found.push_back(*region);
  }
  whole = found.size() < bodies.size();
  if (!whole) {
    // Of overlapping regions the pixels they share would be searched twice.
    for (std::size_t a = 0; a < found.size(); ++a)
      for (std::size_t b = a + 1; b < found.size();) {
        const cv::Rect both = found[a].at | found[b].at;
        if (both.area() < found[a].at.area() + found[b].at.area()) {
          found[a] = {both, std::min(found[a].step, found[b].step)};
          found.erase(found.begin() + static_cast<std::ptrdiff_t>(b));
        } else {
          ++b;
        }
      }
    return found;
  }
  searched_s = time_s;
  found.push_back({cv::Rect(0, 0, grey.cols, grey.rows), options.halfSearch ? 2 : 1});
  return found;
}

std::vector<MarkerSight> CameraTracker::State::find(const cv::Mat& grey, const std::vector<SearchRegion>& where) const {
  std::vector<MarkerSight> sights;
  std::set<std::pair<int, int>> known;
  for (const std::string& name : dictionaries)
    for (const SearchRegion& region : where)
      for (const MarkerDetection& found : findMarkers(grey, region, markerDictionary(name), options.smallestMarker_px))
        for (std::size_t b = 0; b < bodies.size(); ++b) {
          const int body = static_cast<int>(b);
          if (bodies[b].body.dictionary != name || !bodies[b].byId.contains(found.id) || !known.emplace(body, found.id).second) continue;
          MarkerSight sight;
          sight.id = found.id;
          sight.body = body;
          sight.corners_px = found.corners_px;
          sights.push_back(sight);
        }
  return sights;
}

std::optional<MarkerCorners> CameraTracker::State::measured(const cv::Mat& grey, const MarkerSight& found) const {
  switch (options.corners) {
    case CornerMethod::contour:
      return cornersAsGiven(model, found.corners_px);
    case CornerMethod::subPix: {
      std::vector<cv::Point2f> corners;
      for (const auto& at : found.corners_px) corners.emplace_back(static_cast<float>(at.x), static_cast<float>(at.y));
      cv::cornerSubPix(grey, corners, cv::Size(4, 4), cv::Size(-1, -1),
                       cv::TermCriteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 0.01));
      std::array<glm::dvec2, 4> at;
      for (std::size_t n = 0; n < 4; ++n) at[n] = {corners[n].x, corners[n].y};
      return cornersAsGiven(model, at);
    }
    case CornerMethod::edges:
      break;
  }
  const int cells = bodies[static_cast<std::size_t>(found.body)].dictionary->markerSize + 2;
  return cornersByEdges({grey.data, grey.cols, grey.rows, static_cast<std::ptrdiff_t>(grey.step)}, model, found.corners_px, cells, light);
}

/// Whether an estimate may be shown. A wrong "yes" jumps the image; a wrong "no" costs a frame.
void CameraTracker::State::judge(BodySight& sight, const BodyEstimate& estimate, const BodyMemory& memory, double time_s) const {
  sight.bodyToCamera.matrix = estimate.best.bodyToCamera;
  sight.markers = estimate.markers;
  sight.rms_px = estimate.best.rms_px;
  sight.spread_mm = estimate.spread_mm;
  sight.spread_rad = estimate.spread_rad;
  sight.state = TrackingState::live;
  if (estimate.best.rms_px > options.largestRms_px) sight.state = TrackingState::invalid;
  if (estimate.spread_mm > options.largestSpread_mm || estimate.spread_rad > options.largestSpread_rad)
    sight.state = TrackingState::outOfRange;
  const double since_s = time_s - memory.seen_s;
  if (estimate.other) chooseOfTwo(sight, estimate, memory, since_s);
  // A thumb can leave what another marker looks like, to the last square. Alone it has nobody to contradict it but the image before.
  if (sight.state == TrackingState::live && estimate.markers == 1 && since_s < kForgetAfter_s &&
      angleBetween(memory.bodyToCamera, sight.bodyToCamera.matrix) > kFastest_radPerS * since_s + kMisread_rad)
    sight.state = TrackingState::outOfRange;
}

/// Of the two poses that explain a flat view, the one that the image tells, or the image before.
void CameraTracker::State::chooseOfTwo(BodySight& sight, const BodyEstimate& estimate, const BodyMemory& memory, double since_s) const {
  sight.flipRatio = estimate.other->rms_px / std::max(0.02, estimate.best.rms_px);
  if (estimate.otherAngle_rad < kHarmlessAngle_rad) return;
  if (estimate.evidence > kCertain && sight.flipRatio > kCertainRatio) return;
  // The image does not tell. The pose before does, where it is fresh, lies at one of the two, and the two are far apart: they meet and
  // part where a face is seen straight on, and there nobody knows any more which one goes on.
  sight.ambiguous = true;
  // Nor does anybody where a fast hand could have gone from one to the other meanwhile.
  if (since_s * kFastest_radPerS < 0.35 * estimate.otherAngle_rad) {
    const double toBest = angleBetween(memory.bodyToCamera, estimate.best.bodyToCamera);
    const double toOther = angleBetween(memory.bodyToCamera, estimate.other->bodyToCamera);
    if (toBest < 0.25 * estimate.otherAngle_rad && toOther > 0.75 * estimate.otherAngle_rad) return;
    if (toOther < 0.25 * estimate.otherAngle_rad && toBest > 0.75 * estimate.otherAngle_rad && sight.flipRatio < 2.0 &&
        estimate.other->rms_px < options.largestRms_px) {
      sight.bodyToCamera.matrix = estimate.other->bodyToCamera;
      sight.rms_px = estimate.other->rms_px;
      return;
    }
  }
  if (sight.state == TrackingState::live) sight.state = TrackingState::outOfRange;
}

/// What the corners of a body tell of the bleed. Paper that is not as flat as it should be speaks too, so it is never believed to be known
/// better than to a thirtieth of an edge's spread.
void CameraTracker::State::learnBleed(const BodySight& sight, const BodyEstimate& estimate, double time_s) {
  constexpr double kSurest = 0.03, kDrift_perRootS = 0.01;
  if (sight.state != TrackingState::live || sight.ambiguous || estimate.markers < 2) return;
  const double since_s = std::clamp(time_s - bleed_s, 0.0, 100.0);
  bleed = estimate.bleed;
  bleed.deviation = std::max(kSurest, std::hypot(bleed.deviation, kDrift_perRootS * std::sqrt(since_s)));
  bleed.deviation = std::min(bleed.deviation, MarkerBleed{}.deviation);
  bleed_s = time_s;
}

/// Motion in the image, and the body as it was seen last.
void CameraTracker::State::remember(TrackedBody& each, BodySight& sight, const std::vector<MarkerSight>& markers, int body,
                                    double time_s) const {
  BodyMemory& memory = each.memory;
  if (sight.state != TrackingState::live) return;
  const glm::dvec2 face_px = pixelOf(model, carried(sight.bodyToCamera, each.face_mm));
  const double since_s = time_s - memory.seen_s;
  memory.hasVelocity = since_s > 1e-4 && since_s < kForgetAfter_s;
  if (memory.hasVelocity) {
    memory.velocity_pxPerS = (face_px - memory.face_px) / since_s;
    sight.speed_pxPerS = glm::length(memory.velocity_pxPerS);
  }
  double top = 1e9, bottom = -1e9;
  for (const MarkerSight& marker : markers) {
    if (marker.body != body || !marker.used) continue;
    for (const auto& at : marker.corners_px) {
      top = std::min(top, at.y);
      bottom = std::max(bottom, at.y);
    }
  }
  // Where nobody said how long an image is read, most sensors take about two thirds of a frame at 30 Hz.
  const double readout_s = options.readout_s > 0.0 ? options.readout_s : 0.022;
  if (bottom > top) sight.skew_px = sight.speed_pxPerS * readout_s * (bottom - top) / model.height;
  memory.bodyToCamera = sight.bodyToCamera.matrix;
  memory.seen_s = time_s;
  memory.face_px = face_px;
}

Result<CameraTracker> CameraTracker::make(const CameraModel& model, std::vector<MarkerBody> bodies, const CameraTrackingOptions& options) {
  auto state = std::make_unique<State>();
  state->model = model;
  state->options = options;
  state->focal_px = 0.5 * (model.fx + model.fy);
  state->light = lightOfGreys(options.gamma);
  if (!(model.width > 0 && model.height > 0 && model.fx > 0.0 && model.fy > 0.0))
    return failure(ErrorCode::badField, say<"The camera model has no size or focal length; calibrate the camera again.">());
  std::set<std::pair<std::string, int>> taken;
  for (MarkerBody& body : bodies) {
    TrackedBody tracked;
    tracked.dictionary = markerDictionary(body.dictionary);
    if (tracked.dictionary == nullptr)
      return failure(ErrorCode::badField,
                     say<"The marker body %1 uses markers of the kind %2, which this program does not know.">(body.name, body.dictionary));
    for (const Marker& marker : body.markers) {
      if (marker.id < 0 || marker.id >= tracked.dictionary->bytesList.rows || !isFlatSquare(marker))
        return failure(
            ErrorCode::badField,
            say<"Marker %1 of the body %2 is no flat square of its kind; correct its corners or its number.">(marker.id, body.name));
      if (!taken.emplace(body.dictionary, marker.id).second)
        return failure(ErrorCode::badField,
                       say<"Marker %1 is used twice, the second time by %2; a marker can be on one body only.">(marker.id, body.name));
      tracked.squares[marker.id] = squaresOf(body.dictionary, marker.id);
      tracked.face_mm += middleOf(marker) / static_cast<double>(body.markers.size());
    }
    if (!body.isBoard) tracked.face_mm = glm::dvec3(body.probeToTool.matrix[3]);
    if (std::find(state->dictionaries.begin(), state->dictionaries.end(), body.dictionary) == state->dictionaries.end())
      state->dictionaries.push_back(body.dictionary);
    tracked.body = std::move(body);
    state->bodies.push_back(std::move(tracked));
  }
  for (TrackedBody& each : state->bodies)
    for (const Marker& marker : each.body.markers) each.byId[marker.id] = &marker;
  return CameraTracker(std::move(state));
}

CameraTracker::CameraTracker(std::unique_ptr<State> state) : state_(std::move(state)) {}
CameraTracker::CameraTracker(CameraTracker&&) noexcept = default;
CameraTracker& CameraTracker::operator=(CameraTracker&&) noexcept = default;
CameraTracker::~CameraTracker() = default;

CameraSight CameraTracker::track(ImageView<const std::uint8_t> grey, double time_s) {
  EW_EXPECTS(grey.width == state_->model.width && grey.height == state_->model.height);
  const cv::Mat image(grey.height, grey.width, CV_8UC1, const_cast<std::uint8_t*>(grey.data), static_cast<std::size_t>(grey.stride));
  CameraSight sight;
  sight.markers = state_->find(image, state_->regions(time_s, image, sight.searchedWhole));
  sight.bodies.resize(state_->bodies.size());
  std::vector<std::vector<MarkerSight*>> ofBodies(state_->bodies.size());
  for (MarkerSight& marker : sight.markers) ofBodies[static_cast<std::size_t>(marker.body)].push_back(&marker);
  std::vector<std::size_t> order(ofBodies.size());
  std::iota(order.begin(), order.end(), 0u);
  // The body with most markers tells most of the bleed.
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return ofBodies[a].size() > ofBodies[b].size(); });
  for (const std::size_t body : order) state_->trackBody(image, body, ofBodies[body], sight, time_s);
  sight.bleed = state_->bleed.value;
  sight.bleedSpread = state_->bleed.deviation;
  return sight;
}

void CameraTracker::State::trackBody(const cv::Mat& image, std::size_t index, std::vector<MarkerSight*> found, CameraSight& sight,
                                     double time_s) {
  if (found.empty()) return;
  TrackedBody& each = bodies[index];
  BodySight& body = sight.bodies[index];
  const auto size = [](const MarkerSight* marker) { return glm::distance(marker->corners_px[0], marker->corners_px[2]); };
  std::stable_sort(found.begin(), found.end(), [&](const auto* p, const auto* q) { return size(p) > size(q); });
  if (static_cast<int>(found.size()) > options.mostMarkers) found.resize(static_cast<std::size_t>(std::max(1, options.mostMarkers)));
  const ImageView<const std::uint8_t> seenGrey{image.data, image.cols, image.rows, static_cast<std::ptrdiff_t>(image.step)};
  std::vector<MarkerObservation> seen;
  std::vector<MarkerSight*> measuredOf;
  for (MarkerSight* marker : found) {
    const auto corners = measured(image, *marker);
    if (!corners || !showsSquares(seenGrey, corners->corners_px, each.squares.at(marker->id))) continue;
    marker->corners_px = corners->corners_px;
    marker->blur_px = *std::max_element(corners->edgeSpread_px.begin(), corners->edgeSpread_px.end());
    const double least = *std::min_element(corners->edgeSpread_px.begin(), corners->edgeSpread_px.end());
    // An even motion of length L spreads an edge across it by L / sqrt(12); the sides along it keep the sharpness of the lens.
    body.blur_px = std::max(body.blur_px, std::sqrt(12.0 * std::max(0.0, marker->blur_px * marker->blur_px - least * least)));
    seen.push_back({each.byId.at(marker->id), corners->rays, corners->perBleed, corners->spread_px});
    measuredOf.push_back(marker);
  }
  body.state = TrackingState::outOfRange;  // seen, but cut off, covered or blurred
  if (seen.empty()) return;
  std::optional<glm::dmat4> before;
  if (time_s - each.memory.seen_s < kForgetAfter_s) before = each.memory.bodyToCamera;
  const auto estimate = estimateBody(seen, focal_px, each.face_mm, before, bleed);
  body.state = TrackingState::invalid;
  if (!estimate) return;
  for (std::size_t n = 0; n < seen.size(); ++n) {
    measuredOf[n]->residual_px = estimate->residuals_px[n];
    measuredOf[n]->used = estimate->used[n];
  }
  judge(body, *estimate, each.memory, time_s);
  learnBleed(body, *estimate, time_s);
  remember(each, body, sight.markers, static_cast<int>(index), time_s);
}

void CameraTracker::forget() {
  for (TrackedBody& each : state_->bodies) each.memory = {};
  state_->bleed = {};
  state_->searched_s = -1e9;
}

}  // namespace ew
