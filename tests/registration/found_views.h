#pragma once

#include <fstream>
#include <iomanip>
#include <optional>
#include <string>
#include <vector>

#include "graphs.h"

/// What matching found between views of a virtual patient, and where they truly belong: made by pressed_views_test, kept beside the tests
/// so that the graph is tried on real errors in a moment.
namespace ew::registration::test {

struct FoundViews {
  std::vector<Transform<frame::World, frame::View>> truth;  ///< to the resting patient
  std::vector<glm::dvec3> middle_mm;
  std::vector<GraphEdge> edges;  ///< pairs called aligned
};

inline bool write(const FoundViews& views, const std::string& file) {
  std::ofstream out(file);
  out << std::setprecision(9) << views.truth.size() << ' ' << views.edges.size() << '\n';
  const auto put = [&](const glm::dmat4& m) {
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) out << m[c][r] << ' ';
  };
  for (std::size_t n = 0; n < views.truth.size(); ++n) {
    put(views.truth[n].matrix);
    out << views.middle_mm[n].x << ' ' << views.middle_mm[n].y << ' ' << views.middle_mm[n].z << '\n';
  }
  out << std::setprecision(9);
  for (const GraphEdge& edge : views.edges) {
    out << edge.fixed << ' ' << edge.moving << ' ';
    put(edge.fixedToMoving.matrix);
    out << edge.centre_mm.x << ' ' << edge.centre_mm.y << ' ' << edge.centre_mm.z;
    for (int r = 0; r < 6; ++r)
      for (int c = r; c < 6; ++c) out << ' ' << (edge.covariance ? (*edge.covariance)[static_cast<std::size_t>(6 * r + c)] : 0.0);
    out << '\n';
  }
  return out.good();
}

inline std::optional<FoundViews> readFoundViews(const std::string& file) {
  std::ifstream in(file);
  std::size_t nodes = 0, edges = 0;
  if (!(in >> nodes >> edges)) return std::nullopt;
  const auto get = [&] {
    glm::dmat4 m(1.0);
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) in >> m[c][r];
    return m;
  };
  FoundViews views;
  for (std::size_t n = 0; n < nodes; ++n) {
    views.truth.push_back({get()});
    glm::dvec3 p(0.0);
    in >> p.x >> p.y >> p.z;
    views.middle_mm.push_back(p);
  }
  for (std::size_t e = 0; e < edges; ++e) {
    GraphEdge edge;
    in >> edge.fixed >> edge.moving;
    edge.fixedToMoving.matrix = get();
    in >> edge.centre_mm.x >> edge.centre_mm.y >> edge.centre_mm.z;
    PoseCovariance covariance{};
    for (std::size_t r = 0; r < 6; ++r)
      for (std::size_t c = r; c < 6; ++c) {
        in >> covariance[6 * r + c];
        covariance[6 * c + r] = covariance[6 * r + c];
      }
    edge.covariance = covariance;
    views.edges.push_back(edge);
  }
  if (!in) return std::nullopt;
  return views;
}

/// The graph of these views with two pairs put 35 mm and 60 mm wrong, nothing known of where any of them lies.
struct SpoiledGraph {
  std::vector<GraphNode> nodes;
  std::vector<GraphEdge> edges;
  std::vector<std::size_t> spoiled;  ///< indices of edges, rising
};
inline SpoiledGraph spoiledGraph(const FoundViews& views, std::uint64_t seed) {
  SpoiledGraph graph;
  for (std::size_t n = 0; n < views.truth.size(); ++n) {
    graph.nodes.emplace_back();
    graph.nodes.back().name = std::string(1, static_cast<char>('a' + n));
  }
  graph.nodes.front().toWorld = views.truth.front();
  graph.edges = views.edges;
  // Not where the pairs that are left could not tell: every end keeps three others.
  Draw draw(seed);
  std::size_t first = 0, second = 0;
  const auto keepsThree = [&](std::size_t node) {
    int others = 0;
    for (std::size_t e = 0; e < graph.edges.size(); ++e)
      others += e != first && e != second && (graph.edges[e].fixed == node || graph.edges[e].moving == node) ? 1 : 0;
    return others >= 3;
  };
  bool tells = false;
  for (int tries = 0; tries < 1000 && !tells; ++tries) {
    first = draw.engine()() % graph.edges.size();
    second = (first + 1 + draw.engine()() % (graph.edges.size() - 1)) % graph.edges.size();
    tells = true;
    for (const std::size_t e : {first, second}) tells = tells && keepsThree(graph.edges[e].fixed) && keepsThree(graph.edges[e].moving);
  }
  const auto spoil = [&](std::size_t e, double shift_mm, double turnBy_deg) {
    const glm::dvec3 along = glm::normalize(draw.vector(1.0));
    const glm::dvec3 about = glm::normalize(draw.vector(1.0));
    GraphEdge& edge = graph.edges[e];
    edge.fixedToMoving = edge.fixedToMoving * moved<frame::Fixed>(edge.centre_mm, shift_mm * along, glm::radians(turnBy_deg) * about);
  };
  spoil(first, 35.0, 20.0);
  spoil(second, 60.0, 28.0);
  graph.spoiled = {std::min(first, second), std::max(first, second)};
  return graph;
}

/// How many views lie in one part with view `gauge`, and the worst of them at the middle of what it covers, `gauge` being where it truly
/// is.
struct PlacedViews {
  int count = 0;
  PoseError worst;
};
inline PlacedViews placedWith(std::size_t gauge, const GraphResult& found, const FoundViews& views) {
  PlacedViews placed;
  const auto back = views.truth[gauge] * inverse(found.toWorld[gauge]);
  for (std::size_t n = 0; n < found.toWorld.size(); ++n) {
    if (found.part[n] != found.part[gauge]) continue;
    ++placed.count;
    const auto pose = back * found.toWorld[n];
    placed.worst.mm =
        std::max(placed.worst.mm, glm::length(carried(pose, views.middle_mm[n]) - carried(views.truth[n], views.middle_mm[n])));
    placed.worst.deg = std::max(placed.worst.deg, rotation_deg(pose, views.truth[n]));
  }
  return placed;
}

}  // namespace ew::registration::test
