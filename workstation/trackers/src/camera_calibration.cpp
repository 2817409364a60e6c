#include "ew/trackers/camera_calibration.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <opencv2/calib3d.hpp>

#include "camera_charuco.h"
#include "ew/core/figures.h"
#include "ew/core/order_statistics.h"

namespace ew {
namespace {

constexpr std::size_t kFewestViews = 8, kFewestCorners = 8;
constexpr double kTipped_rad = 0.2, kFewestTipped = 0.3;  // below, a distance cannot be told from a size, and the fit does not notice
constexpr std::size_t kViewsForSixthOrder = 15;           // fewer do not reach the edges often enough to tell k3 from k2

struct ViewPoints {
  std::vector<std::vector<cv::Point3f>> corners_mm;
  std::vector<std::vector<cv::Point2f>> corners_px;
};

void addView(ViewPoints& points, const CharucoView& view, const CharucoBoard& board) {
  auto& mm = points.corners_mm.emplace_back();
  auto& px = points.corners_px.emplace_back();
  for (std::size_t n = 0; n < view.ids.size(); ++n) {
    mm.emplace_back(charucoCorner(board, view.ids[n]));
    px.emplace_back(static_cast<float>(view.corners_px[n].x), static_cast<float>(view.corners_px[n].y));
  }
}

struct CameraFit {
  CameraModel model;
  std::vector<double> residuals_px;
  double focalSpread_px = 0.0;
  double tipped = 0.0;  ///< share of the views in which the board is tipped by more than kTipped_rad against the mean of them
};

double tippedShare(const std::vector<cv::Mat>& turns) {
  std::vector<cv::Vec3d> normals;
  cv::Vec3d mean(0, 0, 0);
  for (const cv::Mat& each : turns) {
    cv::Matx33d turn;
    cv::Rodrigues(each, turn);
    normals.emplace_back(turn(0, 2), turn(1, 2), turn(2, 2));
    mean += normals.back();
  }
  mean = cv::normalize(mean);
  const auto tipped =
      std::count_if(normals.begin(), normals.end(), [&](const cv::Vec3d& n) { return n.dot(mean) < std::cos(kTipped_rad); });
  return static_cast<double>(tipped) / static_cast<double>(normals.size());
}

CameraFit fitted(const ViewPoints& points, int width, int height) {
  cv::Mat camera, lens, inside, outside, perView;
  std::vector<cv::Mat> turns, places;
  int flags = 0;
  if (points.corners_mm.size() < kViewsForSixthOrder) flags |= cv::CALIB_FIX_K3;
  CameraFit found;
  CameraModel& model = found.model;
  model.rms_px = cv::calibrateCamera(points.corners_mm, points.corners_px, cv::Size(width, height), camera, lens, turns, places, inside,
                                     outside, perView, flags, cv::TermCriteria(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 60, 1e-9));
  model.width = width;
  model.height = height;
  model.fx = camera.at<double>(0, 0);
  model.fy = camera.at<double>(1, 1);
  model.cx = camera.at<double>(0, 2);
  model.cy = camera.at<double>(1, 2);
  for (std::size_t n = 0; n < 5; ++n) model.distortion[n] = lens.at<double>(static_cast<int>(n));
  model.views = static_cast<int>(points.corners_mm.size());
  for (int n = 0; n < static_cast<int>(perView.total()); ++n) found.residuals_px.push_back(perView.at<double>(n));
  found.tipped = tippedShare(turns);
  found.focalSpread_px = std::max(inside.at<double>(0), inside.at<double>(1));
  return found;
}

/// Root mean square of a view that the model was not found from.
double residualOf(const CameraModel& model, const CharucoView& view, const CharucoBoard& board) {
  ViewPoints one;
  addView(one, view, board);
  const cv::Mat camera = (cv::Mat_<double>(3, 3) << model.fx, 0.0, model.cx, 0.0, model.fy, model.cy, 0.0, 0.0, 1.0);
  const cv::Mat lens(1, 5, CV_64F, const_cast<double*>(model.distortion.data()));
  cv::Mat turn, place;
  cv::solvePnP(one.corners_mm[0], one.corners_px[0], camera, lens, turn, place);
  std::vector<cv::Point2f> again;
  cv::projectPoints(one.corners_mm[0], turn, place, camera, lens, again);
  double squares = 0.0;
  for (std::size_t n = 0; n < again.size(); ++n) {
    const cv::Point2d off(again[n] - one.corners_px[0][n]);
    squares += off.dot(off);
  }
  return std::sqrt(squares / static_cast<double>(again.size()));
}

std::string timeNow() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm utc{};
  gmtime_r(&now, &utc);
  char text[32];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return text;
}

Message hundredths(double value) { return fixedNumeral(value, 2); }

void judge(CameraCalibration& found, bool isTipped) {
  using Quality = CameraCalibration::Quality;
  const double unsure = found.focalSpread_px / found.model.fx;
  const double worst = std::max(found.model.rms_px, found.heldOut_px);
  found.quality = !isTipped                       ? Quality::bad
                  : worst < 0.5 && unsure < 0.004 ? Quality::good
                  : worst < 1.0 && unsure < 0.01  ? Quality::usable
                                                  : Quality::bad;
  switch (found.quality) {
    case Quality::good:
      found.verdict = say<"The calibration is good: the corners of the board lie where they should to %1 pixel.">(hundredths(worst));
      return;
    case Quality::usable:
      found.verdict =
          say<"The calibration can be used: the corners lie where they should to %1 pixel. Below half a pixel it would be good; more "
              "images with the board tipped and in the corners of the image help.">(hundredths(worst));
      return;
    case Quality::bad:
      break;
  }
  found.verdict = worst < 1.0 ? say<"The images do not tell the distance from the size; take more with the board tipped to all sides and "
                                    "at other distances.">()
                              : say<"The calibration cannot be used: the corners lie %1 pixel off. Glue the board to something flat, hold "
                                    "it still, check its sizes, "
                                    "and take the images again.">(hundredths(worst));
}

struct Calibrating {
  const std::vector<CharucoView>& views;
  const CharucoBoard& board;
  int width, height;

  [[nodiscard]] CameraFit from(const std::vector<bool>& isLeftOut) const {
    ViewPoints points;
    for (std::size_t n = 0; n < views.size(); ++n)
      if (!isLeftOut[n]) addView(points, views[n], board);
    return fitted(points, width, height);
  }
  [[nodiscard]] double heldOut(const std::vector<bool>& isLeftOut) const {
    std::vector<bool> without = isLeftOut;
    std::vector<std::size_t> held;
    std::size_t kept = 0;
    for (std::size_t n = 0; n < views.size(); ++n) {
      if (isLeftOut[n] || kept++ % 4 != 3) continue;
      without[n] = true;
      held.push_back(n);
    }
    if (kept < kFewestViews + held.size() || held.empty()) return 0.0;
    const CameraModel model = from(without).model;
    double squares = 0.0;
    for (const std::size_t n : held) squares += std::pow(residualOf(model, views[n], board), 2);
    return std::sqrt(squares / static_cast<double>(held.size()));
  }
};

}  // namespace

Result<CameraCalibration> calibrateCamera(const std::vector<CharucoView>& views, const CharucoBoard& board, int width, int height,
                                          Progress& progress) {
  if (charucoOf(board) == nullptr) return passOn(impossibleCharuco());
  const int corners = (board.columns - 1) * (board.rows - 1);
  std::size_t usable = 0;
  std::vector<bool> leftOut;
  for (const CharucoView& view : views) {
    const bool isKnown = view.ids.size() == view.corners_px.size() &&
                         std::all_of(view.ids.begin(), view.ids.end(), [&](int id) { return id >= 0 && id < corners; });
    leftOut.push_back(!isKnown || view.ids.size() < kFewestCorners);
    usable += leftOut.back() ? 0u : 1u;
  }
  const auto tooFew = [&] {
    return failure(ErrorCode::badField,
                   say<"There are %1 images of the board that can be used and at least %2 are needed; take more.">(usable, kFewestViews));
  };
  if (usable < kFewestViews) return tooFew();
  const Calibrating calibrating{views, board, width, height};
  const std::vector<bool> unusable = leftOut;
  try {
    progress.report(say<"Finding the camera's model">(), 0.0);
    CameraFit fit = calibrating.from(leftOut);
    // An image in which the board moved or a corner was misread is far off the others.
    for (int round = 0; round < 2; ++round) {
      if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The calibration was stopped.">());
      const double limit_px = std::max(0.25, 3.0 * upperMedianOf(fit.residuals_px));
      bool changed = false;
      for (std::size_t n = 0, kept = 0; n < views.size(); ++n) {
        if (leftOut[n]) continue;
        if (fit.residuals_px[kept++] <= limit_px || usable <= kFewestViews) continue;
        leftOut[n] = changed = true;
        --usable;
      }
      if (!changed) break;
      fit = calibrating.from(leftOut);
    }
    progress.report(say<"Checking it with images left out">(), 0.6);
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The calibration was stopped.">());
    CameraCalibration found;
    found.model = fit.model;
    found.model.made = timeNow();
    found.focalSpread_px = fit.focalSpread_px;
    found.leftOut = leftOut;
    found.heldOut_px = calibrating.heldOut(leftOut);
    std::size_t kept = 0;
    for (std::size_t n = 0; n < views.size(); ++n)
      found.residuals_px.push_back(!leftOut[n] ? fit.residuals_px[kept++] : unusable[n] ? 0.0 : residualOf(fit.model, views[n], board));
    if (!std::isfinite(found.model.rms_px) || !(found.model.fx > 0.0)) return tooFew();
    judge(found, fit.tipped >= kFewestTipped);
    progress.report(say<"Checking it with images left out">(), 1.0);
    return found;
  } catch (const cv::Exception&) {
    return failure(ErrorCode::badField, say<"No camera explains these images; take others, with the board tipped to all sides.">());
  }
}

}  // namespace ew
