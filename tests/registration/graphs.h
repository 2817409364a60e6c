#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <random>
#include <string>
#include <vector>

#include "ew/registration/pose_graph.h"

namespace ew::registration::test {

inline PoseCovariance isotropic(double sigma_mm, double sigma_rad) {
  PoseCovariance covariance{};
  for (std::size_t k = 0; k < 6; ++k) covariance[7 * k] = k < 3 ? sigma_mm * sigma_mm : sigma_rad * sigma_rad;
  return covariance;
}

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double normal(double sigma) { return sigma * normal_(engine_); }
  double even(double lowest, double highest) { return std::uniform_real_distribution<double>(lowest, highest)(engine_); }
  glm::dvec3 vector(double sigma) {
    const double x = normal(sigma);
    const double y = normal(sigma);
    return {x, y, normal(sigma)};
  }
  std::mt19937_64& engine() { return engine_; }

 private:
  std::mt19937_64 engine_;
  std::normal_distribution<double> normal_{0.0, 1.0};
};

/// p -> R (p - about) + about + shift, R the turn by a vector (axis times angle).
template <class Frame>
Transform<Frame, Frame> moved(const glm::dvec3& about, const glm::dvec3& shift_mm, const glm::dvec3& rotation_rad) {
  const double angle = glm::length(rotation_rad);
  const glm::dmat4 turn = angle > 0.0 ? glm::rotate(glm::dmat4(1.0), angle, rotation_rad / angle) : glm::dmat4(1.0);
  return {glm::translate(glm::dmat4(1.0), about + shift_mm) * turn * glm::translate(glm::dmat4(1.0), -about)};
}

/// Subvolumes with known poses, names a, b, c …
struct KnownGraph {
  std::vector<Transform<frame::World, frame::View>> truth;  ///< node to world
  std::vector<GraphNode> nodes;
  std::vector<GraphEdge> edges;

  explicit KnownGraph(std::size_t count, std::uint64_t seed) : draw(seed) {
    for (std::size_t i = 0; i < count; ++i) {
      const glm::dvec3 place(30.0 * static_cast<double>(i), draw.even(-20, 20), draw.even(-20, 20));
      truth.push_back(renamed<frame::World, frame::View>(moved<frame::World>(glm::dvec3(0.0), place, draw.vector(0.5))));
      nodes.emplace_back();
      nodes.back().name = count <= 26 ? std::string(1, static_cast<char>('a' + i)) : "n" + std::to_string(i);
    }
    nodes.front().toWorld = truth.front();  // the others start at the origin: nothing is known of them
  }
  /// A pair as it would be found, with errors drawn from its covariance.
  GraphEdge& join(std::size_t fixed, std::size_t moving, double sigma_mm = 0.0, double sigma_deg = 0.0) {
    const double sigma_rad = glm::radians(sigma_deg);
    const glm::dvec3 centre = draw.vector(20.0);
    const glm::dvec3 shift = draw.vector(sigma_mm);
    const auto error = moved<frame::Fixed>(centre, shift, draw.vector(sigma_rad));
    edges.push_back({.fixed = fixed,
                     .moving = moving,
                     .fixedToMoving = renamed<frame::Moving, frame::Fixed>(inverse(truth[moving]) * truth[fixed]) * error,
                     .covariance = isotropic(std::max(sigma_mm, 0.05), std::max(sigma_rad, 0.001)),
                     .centre_mm = centre});
    return edges.back();
  }
  /// Spoils a pair: another place found for it.
  void spoil(std::size_t edge, double shift_mm, double rotation_deg) {
    const glm::dvec3 along = glm::normalize(draw.vector(1.0));
    const glm::dvec3 about = glm::normalize(draw.vector(1.0));
    edges[edge].fixedToMoving =
        edges[edge].fixedToMoving * moved<frame::Fixed>(edges[edge].centre_mm, shift_mm * along, glm::radians(rotation_deg) * about);
  }

  Draw draw;
};

template <class To, class From>
double rotation_deg(const Transform<To, From>& a, const Transform<To, From>& b) {
  const glm::dmat3 between = glm::transpose(glm::dmat3(a.matrix)) * glm::dmat3(b.matrix);
  const glm::dvec3 axial(between[1][2] - between[2][1], between[2][0] - between[0][2], between[0][1] - between[1][0]);
  return glm::degrees(std::atan2(0.5 * glm::length(axial), 0.5 * (between[0][0] + between[1][1] + between[2][2] - 1.0)));
}

struct PoseError {
  double mm = 0.0;
  double deg = 0.0;
};

/// Worst over the nodes, at the place `middle` of each subvolume.
inline PoseError worstError(const std::vector<Transform<frame::World, frame::View>>& found,
                            const std::vector<Transform<frame::World, frame::View>>& truth, const glm::dvec3& middle = glm::dvec3(0.0)) {
  PoseError worst;
  for (std::size_t i = 0; i < found.size(); ++i) {
    worst.mm = std::max(worst.mm, glm::length(carried(found[i], middle) - carried(truth[i], middle)));
    worst.deg = std::max(worst.deg, rotation_deg(found[i], truth[i]));
  }
  return worst;
}

}  // namespace ew::registration::test
