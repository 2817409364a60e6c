#include <algorithm>
#include <cmath>

#include "alignment_words.h"
#include "ew/tracking/alignment.h"
#include "rigid_fit.h"

namespace ew {
namespace {

struct MeanTool {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
};

MeanTool meanOf(std::span<const ToolReading* const> readings) {
  MeanTool mean;
  Eigen::Matrix4d outer = Eigen::Matrix4d::Zero();
  for (const ToolReading* reading : readings) {
    mean.position += eigenOf(glm::dvec3(reading->toolToTracker.matrix[3]));
    const Eigen::Vector4d q = Eigen::Quaterniond(turnOf(reading->toolToTracker.matrix)).normalized().coeffs();
    outer += q * q.transpose();
  }
  mean.position /= static_cast<double>(readings.size());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> solver(outer);
  mean.turn.coeffs() = solver.eigenvectors().col(3);
  return mean;
}

}  // namespace

Result<StillTool> stillTool(std::span<const ToolReading> readings, const StillOptions& options) {
  std::vector<const ToolReading*> live;
  for (const ToolReading& reading : readings)
    if (reading.state == TrackingState::live && checkRigid(reading.toolToTracker)) live.push_back(&reading);
  if (static_cast<int>(live.size()) < std::max(options.fewest, 3))
    return failure(ErrorCode::noValidPose, say<"The tool was seen %1 times only; hold it still where the tracker sees it.">(live.size()),
                   {{"readings", std::to_string(live.size())}});
  const MeanTool mean = meanOf(live);
  double squares = 0.0, turnSquares = 0.0;
  for (const ToolReading* reading : live) {
    squares += (eigenOf(glm::dvec3(reading->toolToTracker.matrix[3])) - mean.position).squaredNorm();
    turnSquares += std::pow(mean.turn.angularDistance(Eigen::Quaterniond(turnOf(reading->toolToTracker.matrix))), 2);
  }
  const auto count = static_cast<double>(live.size());
  StillTool still{{matrixOf(mean.turn.toRotationMatrix(), mean.position)},
                  std::sqrt(squares / (count - 1.0)),
                  std::sqrt(turnSquares / (count - 1.0)),
                  static_cast<int>(live.size())};
  const std::size_t third = live.size() / 3;
  const MeanTool first = meanOf(std::span(live).first(third)), last = meanOf(std::span(live).last(third));
  // Two means of a third of the readings each lie apart by chance as well, at noise of this size by less than four of these.
  const double byChance = 4.0 * std::sqrt(2.0 / static_cast<double>(third));
  const double drift_mm = (first.position - last.position).norm(), drift_rad = first.turn.angularDistance(last.turn);
  const auto within = [&](auto get) {  // noise about a mean that may move: differences from reading to reading
    double sum = 0.0;
    for (std::size_t n = 1; n < live.size(); ++n) sum += std::pow(get(*live[n - 1], *live[n]), 2);
    return std::sqrt(0.5 * sum / (count - 1.0));
  };
  const double noise_mm = within([](const ToolReading& a, const ToolReading& b) {
    return glm::distance(glm::dvec3(a.toolToTracker.matrix[3]), glm::dvec3(b.toolToTracker.matrix[3]));
  });
  const double noise_rad = within([](const ToolReading& a, const ToolReading& b) {
    return Eigen::Quaterniond(turnOf(a.toolToTracker.matrix)).angularDistance(Eigen::Quaterniond(turnOf(b.toolToTracker.matrix)));
  });
  if (drift_mm > options.drift_mm + byChance * noise_mm || drift_rad > options.drift_rad + byChance * noise_rad)
    return failure(ErrorCode::badField, say<"The tool moved by %1 mm meanwhile; hold it still for a second.">(tenths(drift_mm)),
                   {{"drift_mm", std::to_string(drift_mm)}, {"drift_rad", std::to_string(drift_rad)}});
  return still;
}

}  // namespace ew
