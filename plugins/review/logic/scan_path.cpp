#include "logic/scan_path.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "ew/imaging/display.h"
#include "ew/scanning/contact.h"
#include "logic/review_tracks.h"

namespace ew::review {
namespace {

constexpr double kPi = 3.14159265358979323846;

glm::dvec3 faceOf(const Pose& pose) { return carried(pose.probeToWorld, glm::dvec3(0.0)); }

double turnBetween_deg(const Pose& a, const Pose& b) {
  const glm::dmat3 turn = glm::transpose(glm::dmat3(a.probeToWorld.matrix)) * glm::dmat3(b.probeToWorld.matrix);
  return std::acos(std::clamp(0.5 * (turn[0][0] + turn[1][1] + turn[2][2] - 1.0), -1.0, 1.0)) * 180.0 / kPi;
}

PlaneVisit planeOf(const ScanState& state, double begin_s, double end_s, bool isFrozen) {
  return {state.pose.probeToWorld, state.probe, resolvedDepth_mm(state.probe, state.knobs), begin_s, end_s, isFrozen};
}

}  // namespace

SkinPath skinPathOf(const ScanLog& log, const Part& part, double least_mm, double longestGap_s) {
  SkinPath path;
  std::optional<PathPoint> last;  // of the line that goes on, kept or not
  const auto end = [&] {
    if (last && !path.empty() && path.back().back().time_s < last->time_s) path.back().push_back(*last);
    last.reset();
  };
  for (std::size_t n = 0; n < log.frameCount(); ++n) {
    const double time_s = log.frameTime_s(n);
    if (time_s < part.begin_s || time_s > part.end_s) continue;
    const ScanState state = log.frame(n);
    const bool touches = state.pose.status == PoseStatus::ok && (state.gaps_mm.empty() || contactShare(state.gaps_mm) > 0.0);
    if (!touches || (last && time_s - last->time_s > longestGap_s)) end();
    if (!touches) continue;
    const PathPoint here{faceOf(state.pose), time_s};
    if (!last)
      path.push_back({here});
    else if (glm::distance(path.back().back().at_mm, here.at_mm) >= least_mm)
      path.back().push_back(here);
    last = here;
  }
  end();
  return path;
}

std::vector<PlaneVisit> planeVisitsOf(const ScanLog& log, const Part& part, const VisitOptions& options) {
  std::vector<PlaneVisit> planes;
  std::optional<ScanState> rest;
  double since_s = 0.0, until_s = 0.0;
  bool wasFrozen = false;
  const std::vector<TrackSpan> freezes = freezesOf(log, part);
  const auto end = [&] {
    if (rest && (wasFrozen || until_s - since_s >= options.least_s)) planes.push_back(planeOf(*rest, since_s, until_s, wasFrozen));
    rest.reset();
    wasFrozen = false;
  };
  for (std::size_t n = 0; n < log.frameCount(); ++n) {
    const double time_s = log.frameTime_s(n);
    if (time_s < part.begin_s || time_s > part.end_s) continue;
    const ScanState state = log.frame(n);
    const bool stays = rest && state.pose.status == PoseStatus::ok &&
                       glm::distance(faceOf(rest->pose), faceOf(state.pose)) <= options.reach_mm &&
                       turnBetween_deg(rest->pose, state.pose) <= options.reach_deg;
    if (rest && !stays) end();
    if (state.pose.status != PoseStatus::ok) continue;
    if (!rest) {
      rest = state;
      since_s = time_s;
    }
    // Frozen, no frames are made: the image stays until the next one.
    until_s = std::min(part.end_s, n + 1 < log.frameCount() ? log.frameTime_s(n + 1) : log.end_s());
    const auto isFrozen = [&](const TrackSpan& freeze) { return freeze.begin_s < until_s && freeze.end_s > time_s; };
    wasFrozen = wasFrozen || std::any_of(freezes.begin(), freezes.end(), isFrozen);
  }
  end();
  return planes;
}

}  // namespace ew::review
