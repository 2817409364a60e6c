#include <algorithm>
#include <cmath>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "camera_charuco.h"
#include "camera_corners.h"
#include "camera_markers.h"
#include "ew/core/contract.h"
#include "ew/core/order_statistics.h"
#include "ew/trackers/camera_calibration.h"

namespace ew {
namespace {

constexpr std::size_t kFewestSeenCorners = 8;
constexpr int kWantedViews = 14;
constexpr int kMostViews = 40;
constexpr double kShownTipped_rad = 0.26;  // 15 degrees
constexpr double kSharpest_px = 2.0;       // spread of edges above which corners are washed out
constexpr double kStill_pxPerS = 25.0;     // and a rolling shutter shears the board

cv::Mat imageOf(ImageView<const std::uint8_t> grey) {
  return {grey.height, grey.width, CV_8UC1, const_cast<std::uint8_t*>(grey.data), static_cast<std::size_t>(grey.stride)};
}

struct BoardDetection {
  CharucoView view;
  std::vector<std::vector<cv::Point2f>> markers;
};

BoardDetection foundBoard(ImageView<const std::uint8_t> grey, const CharucoBoard& board) {
  BoardDetection found;
  const auto made = charucoOf(board);
  if (made == nullptr) return found;
  std::vector<int> ids;
  try {
    const cv::Mat image = imageOf(grey);
    cv::aruco::detectMarkers(image, made->dictionary, found.markers, ids);
    if (ids.empty()) return found;
    std::vector<cv::Point2f> corners;
    std::vector<int> cornerIds;
    cv::aruco::interpolateCornersCharuco(found.markers, ids, image, made, corners, cornerIds);
    for (std::size_t n = 0; n < cornerIds.size(); ++n) {
      found.view.ids.push_back(cornerIds[n]);
      found.view.corners_px.emplace_back(corners[n].x, corners[n].y);
    }
  } catch (const cv::Exception&) {
    return {};  // too little of the board is seen
  }
  return found;
}

/// What an image adds to others: where the board is, how large, how tipped.
struct ViewShape {
  glm::dvec2 middle{0.0};  ///< in parts of the image
  double size = 0.0;       ///< square root of the share of the image that the board takes
  double aside_rad = 0.0;  ///< tipped about the image's upright axis
  double upDown_rad = 0.0;
};

double apart(const ViewShape& a, const ViewShape& b) {
  return std::sqrt(std::pow(glm::distance(a.middle, b.middle) / 0.2, 2) + std::pow((a.size - b.size) / 0.12, 2) +
                   std::pow((a.aside_rad - b.aside_rad) / 0.25, 2) + std::pow((a.upDown_rad - b.upDown_rad) / 0.25, 2));
}

std::optional<ViewShape> shapeOf(const CharucoView& view, const CharucoBoard& board, int width, int height) {
  std::vector<cv::Point3d> corners_mm;
  std::vector<cv::Point2d> rays;
  const CameraModel guess = assumedCamera(width, height);
  for (std::size_t n = 0; n < view.ids.size(); ++n) {
    corners_mm.push_back(charucoCorner(board, view.ids[n]));
    const glm::dvec2 ray = rayThrough(guess, view.corners_px[n]);
    rays.emplace_back(ray.x, ray.y);
  }
  std::vector<cv::Vec3d> turns, places;
  try {
    if (cv::solvePnPGeneric(corners_mm, rays, cv::Matx33d::eye(), cv::noArray(), turns, places, false, cv::SOLVEPNP_IPPE) < 1) return {};
  } catch (const cv::Exception&) {
    return {};  // corners on a line
  }
  cv::Matx33d turn;
  cv::Rodrigues(turns.front(), turn);
  // The board's normal against the line of sight to its middle.
  cv::Vec3d away(turn(0, 2), turn(1, 2), turn(2, 2));
  if (away.dot(places.front()) < 0.0) away = -away;
  ViewShape shape;
  shape.aside_rad = std::atan2(away[0], away[2]);
  shape.upDown_rad = std::atan2(away[1], away[2]);
  glm::dvec2 low(1e9), high(-1e9);
  for (const auto& at : view.corners_px) {
    low = glm::min(low, at);
    high = glm::max(high, at);
  }
  shape.middle = 0.5 * (low + high) / glm::dvec2(width, height);
  const double seen = static_cast<double>(view.ids.size()) / ((board.columns - 1) * (board.rows - 1));
  shape.size = std::sqrt((high.x - low.x) * (high.y - low.y) / (static_cast<double>(width) * height) / std::max(0.2, seen));
  return shape;
}

/// Spread of the edges of the largest markers.
double edgeSpread(ImageView<const std::uint8_t> grey, const BoardDetection& found, int cells) {
  const CameraModel guess = assumedCamera(grey.width, grey.height);
  static const auto light = lightOfGreys(2.2);
  std::vector<double> spreads;
  for (std::size_t m = 0; m < std::min<std::size_t>(8, found.markers.size()); ++m) {
    std::array<glm::dvec2, 4> about;
    for (std::size_t n = 0; n < 4; ++n) about[n] = {found.markers[m][n].x, found.markers[m][n].y};
    if (const auto corners = cornersByEdges(grey, guess, about, cells, light))
      spreads.push_back(*std::max_element(corners->edgeSpread_px.begin(), corners->edgeSpread_px.end()));
  }
  if (spreads.empty()) return 9.0;  // not one side is a line: washed out altogether
  return upperMedianOf(spreads);
}

}  // namespace

cv::Ptr<cv::aruco::CharucoBoard> charucoOf(const CharucoBoard& board) {
  const auto dictionary = markerDictionary(board.dictionary);
  const bool isPossible = board.columns >= 3 && board.rows >= 3 && board.columns <= 40 && board.rows <= 40 && board.marker_mm > 1.0 &&
                          board.square_mm > board.marker_mm && board.square_mm < 1000.0;
  if (dictionary == nullptr || !isPossible || board.columns * board.rows / 2 > dictionary->bytesList.rows) return nullptr;
  return cv::aruco::CharucoBoard::create(board.columns, board.rows, static_cast<float>(board.square_mm),
                                         static_cast<float>(board.marker_mm), dictionary);
}

cv::Point3d charucoCorner(const CharucoBoard& board, int id) {
  const int inRow = board.columns - 1, column = id % inRow, row = id / inRow;
  return {(1 + column) * board.square_mm, (1 + row) * board.square_mm, 0.0};
}

Error impossibleCharuco() {
  return {
      ErrorCode::badField,
      say<"This chess board cannot be: it needs three to forty squares each way, markers smaller than its squares, and a kind of markers "
          "that has enough of them.">(),
      {}};
}

CharucoView findCharuco(ImageView<const std::uint8_t> grey, const CharucoBoard& board) { return foundBoard(grey, board).view; }

struct CalibrationCollector::State {
  CharucoBoard board;
  int width = 0, height = 0;
  std::vector<CharucoView> views;
  std::vector<ViewShape> shapes;
  CharucoView last;
  double last_s = -1e9;

  /// Pixels a second that the corners have moved by since the last image, median; nothing known: 0.
  [[nodiscard]] double speed(const CharucoView& view, double time_s) const {
    std::vector<double> moved;
    for (std::size_t n = 0; n < view.ids.size(); ++n) {
      const auto same = std::find(last.ids.begin(), last.ids.end(), view.ids[n]);
      if (same != last.ids.end())
        moved.push_back(glm::distance(view.corners_px[n], last.corners_px[static_cast<std::size_t>(same - last.ids.begin())]));
    }
    const double since_s = time_s - last_s;
    if (moved.empty() || !(since_s > 0.0 && since_s < 0.5)) return 0.0;
    return upperMedianOf(moved) / since_s;
  }
};

Result<CalibrationCollector> CalibrationCollector::make(const CharucoBoard& board, int width, int height) {
  if (charucoOf(board) == nullptr) return passOn(impossibleCharuco());
  auto state = std::make_unique<State>();
  state->board = board;
  state->width = width;
  state->height = height;
  return CalibrationCollector(std::move(state));
}

CalibrationCollector::CalibrationCollector(std::unique_ptr<State> state) : state_(std::move(state)) {}
CalibrationCollector::CalibrationCollector(CalibrationCollector&&) noexcept = default;
CalibrationCollector& CalibrationCollector::operator=(CalibrationCollector&&) noexcept = default;
CalibrationCollector::~CalibrationCollector() = default;

CalibrationCollector::Look CalibrationCollector::look(ImageView<const std::uint8_t> grey, double time_s) {
  State& state = *state_;
  EW_EXPECTS(grey.width == state.width && grey.height == state.height);
  Look look;
  const BoardDetection found = foundBoard(grey, state.board);
  look.view = found.view;
  if (look.view.ids.size() < kFewestSeenCorners) return look;
  const double speed_pxPerS = state.speed(look.view, time_s);
  state.last = look.view;
  state.last_s = time_s;
  look.blur_px = edgeSpread(grey, found, markerDictionary(state.board.dictionary)->markerSize + 2);
  const auto shape = shapeOf(look.view, state.board, state.width, state.height);
  if (!shape) return look;
  if (look.blur_px > kSharpest_px)
    look.verdict = ViewVerdict::blurred;
  else if (speed_pxPerS > kStill_pxPerS)
    look.verdict = ViewVerdict::moving;
  else if (std::any_of(state.shapes.begin(), state.shapes.end(), [&](const auto& each) { return apart(each, *shape) < 1.0; }))
    look.verdict = ViewVerdict::alike;
  else if (static_cast<int>(state.views.size()) >= kMostViews)
    look.verdict = ViewVerdict::full;
  else {
    look.verdict = ViewVerdict::kept;
    state.views.push_back(look.view);
    state.shapes.push_back(*shape);
  }
  return look;
}

const std::vector<CharucoView>& CalibrationCollector::views() const { return state_->views; }

CalibrationCoverage CalibrationCollector::coverage() const {
  const State& state = *state_;
  CalibrationCoverage covered;
  covered.views = static_cast<int>(state.views.size());
  for (const CharucoView& view : state.views)
    for (const auto& at : view.corners_px) {
      const int column =
          std::clamp(static_cast<int>(at.x * CalibrationCoverage::kColumns / state.width), 0, CalibrationCoverage::kColumns - 1);
      const int row = std::clamp(static_cast<int>(at.y * CalibrationCoverage::kRows / state.height), 0, CalibrationCoverage::kRows - 1);
      ++covered.corners[static_cast<std::size_t>(row * CalibrationCoverage::kColumns + column)];
    }
  for (const ViewShape& shape : state.shapes) {
    // The side that is further away is the one it is tipped to.
    if (std::abs(shape.aside_rad) < kShownTipped_rad && std::abs(shape.upDown_rad) < kShownTipped_rad) ++covered.straight;
    if (shape.aside_rad < -kShownTipped_rad) ++covered.left;
    if (shape.aside_rad > kShownTipped_rad) ++covered.right;
    if (shape.upDown_rad < -kShownTipped_rad) ++covered.up;
    if (shape.upDown_rad > kShownTipped_rad) ++covered.down;
    if (shape.size > 0.55) ++covered.near;
    if (shape.size < 0.4) ++covered.far;
  }
  covered.next = [&]() -> Message {
    if (covered.views == 0) return say<"Hold the chess board so that the camera sees all of it, and keep it still.">();
    if (covered.straight < 1) return say<"Hold the board straight towards the camera.">();
    if (covered.near < 2) return say<"Bring the board nearer, until it fills more than half of the image.">();
    if (covered.left < 2) return say<"Tip the board to the left by about thirty degrees.">();
    if (covered.right < 2) return say<"Tip the board to the right by about thirty degrees.">();
    if (covered.up < 2) return say<"Tip the upper edge of the board away from the camera or towards it.">();
    if (covered.down < 2) return say<"Tip the board the other way about its lower edge.">();
    const auto emptiest = std::min_element(covered.corners.begin(), covered.corners.end()) - covered.corners.begin();
    if (covered.corners[static_cast<std::size_t>(emptiest)] < 6) {
      const auto row = emptiest / CalibrationCoverage::kColumns, column = emptiest % CalibrationCoverage::kColumns;
      if (row == 0 && column < 2) return say<"Move the board to the upper left of the image.">();
      if (row == 0) return say<"Move the board to the upper right of the image.">();
      if (row == 2 && column < 2) return say<"Move the board to the lower left of the image.">();
      if (row == 2) return say<"Move the board to the lower right of the image.">();
      if (column < 2) return say<"Move the board to the left of the image.">();
      return say<"Move the board to the right of the image.">();
    }
    if (covered.views < kWantedViews) return say<"Hold the board at other distances and angles.">();
    return say<"That is enough; the camera can be calibrated.">();
  }();
  const bool tips = covered.left >= 2 && covered.right >= 2 && covered.up >= 2 && covered.down >= 2;
  const bool places = *std::min_element(covered.corners.begin(), covered.corners.end()) >= 6;
  covered.enough = covered.views >= kWantedViews && covered.straight >= 1 && covered.near >= 2 && tips && places;
  return covered;
}

}  // namespace ew
