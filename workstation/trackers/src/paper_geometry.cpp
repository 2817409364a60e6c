#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "ew/core/contract.h"
#include "ew/trackers/paper_body.h"

namespace ew {
namespace {

/// Origin at the beginning of an edge, x along it, y into the panel, z out of the printed side.
glm::dmat4 edgeToPanel(const PaperPanel& panel, PaperEdge edge) {
  const auto outline = outlineOf(panel);
  const auto n = static_cast<std::size_t>(edge);
  const glm::dvec2 along = glm::normalize(outline[(n + 1) % 4] - outline[n]);
  glm::dmat4 m(1.0);
  m[0] = {along.x, along.y, 0.0, 0.0};
  m[1] = {-along.y, along.x, 0.0, 0.0};
  m[3] = {outline[n].x, outline[n].y, 0.0, 1.0};
  return m;
}

double lengthOf(const PaperPanel& panel, PaperEdge edge) {
  const auto outline = outlineOf(panel);
  const auto n = static_cast<std::size_t>(edge);
  return glm::distance(outline[n], outline[(n + 1) % 4]);
}

glm::dmat4 childToParent(const PaperPanel& child, const PaperPanel& parent, double fold_rad) {
  const glm::dvec3 x(1.0, 0.0, 0.0), z(0.0, 0.0, 1.0);
  // Both edges go counter-clockwise around their panels, so they run against each other along the fold.
  const double shift_mm = 0.5 * (lengthOf(parent, child.onEdge) + lengthOf(child, child.edge));
  const glm::dmat4 facing = glm::rotate(glm::translate(glm::dmat4(1.0), {shift_mm, 0.0, 0.0}), std::numbers::pi, z);
  return edgeToPanel(parent, child.onEdge) * glm::rotate(glm::dmat4(1.0), fold_rad, x) * facing *
         glm::inverse(edgeToPanel(child, child.edge));
}

}  // namespace

std::array<glm::dvec2, 4> outlineOf(const PaperPanel& panel) {
  const double inset = 0.5 * (panel.width_mm - panel.end_mm);
  return {glm::dvec2(0.0, 0.0), glm::dvec2(panel.width_mm, 0.0), glm::dvec2(panel.width_mm - inset, panel.height_mm),
          glm::dvec2(inset, panel.height_mm)};
}

std::array<glm::dvec2, 4> cornersOf(const PaperMarker& marker) {
  const double half = 0.5 * marker.side_mm, c = std::cos(marker.turned_rad), s = std::sin(marker.turned_rad);
  const auto at = [&](double x, double y) { return marker.centre_mm + half * glm::dvec2(c * x - s * y, s * x + c * y); };
  return {at(-1.0, 1.0), at(1.0, 1.0), at(1.0, -1.0), at(-1.0, -1.0)};
}

std::array<glm::dvec2, 4> tabOf(const PaperPanel& panel, PaperEdge edge, double depth_mm) {
  const glm::dmat4 toPanel = edgeToPanel(panel, edge);
  const double length = lengthOf(panel, edge);
  // Flat ends, so that tabs of neighbours which lean towards each other do not meet in the net.
  const double inset = std::min(2.5 * depth_mm, 0.33 * length);
  const auto at = [&](double along, double out) { return glm::dvec2(toPanel * glm::dvec4(along, -out, 0.0, 1.0)); };
  return {at(0.0, 0.0), at(inset, depth_mm), at(length - inset, depth_mm), at(length, 0.0)};
}

std::vector<glm::dmat4> panelPoses(const PaperBody& body, double folding) {
  std::vector<glm::dmat4> poses;
  poses.reserve(body.panels.size());
  for (const PaperPanel& panel : body.panels) {
    if (panel.on < 0) {
      poses.emplace_back(1.0);
      continue;
    }
    const auto parent = static_cast<std::size_t>(panel.on);
    EW_EXPECTS(parent < poses.size());
    poses.push_back(poses[parent] * childToParent(panel, body.panels[parent], folding * panel.fold_rad));
  }
  return poses;
}

MarkerBody foldedBody(const PaperBody& body, double factor) {
  EW_EXPECTS(body.kind != PaperKind::calibration);
  MarkerBody made;
  made.id = body.id;
  made.name = body.name.english;
  made.isBoard = body.kind == PaperKind::board;
  made.dictionary = body.dictionary;
  const auto poses = panelPoses(body, 1.0);
  glm::dvec3 sum(0.0);
  for (std::size_t n = 0; n < body.panels.size(); ++n)
    for (const PaperMarker& each : body.panels[n].markers) {
      Marker marker{.id = each.id};
      const auto corners = cornersOf(each);
      for (std::size_t c = 0; c < 4; ++c) {
        marker.corners_mm[c] = glm::dvec3(poses[n] * glm::dvec4(corners[c], 0.0, 1.0));
        sum += marker.corners_mm[c];
      }
      made.markers.push_back(marker);
    }
  const glm::dvec3 centre = made.markers.empty() ? glm::dvec3(0.0) : sum / (4.0 * static_cast<double>(made.markers.size()));
  for (Marker& marker : made.markers)
    for (glm::dvec3& corner : marker.corners_mm) corner -= centre;
  if (body.face) {
    const auto panel = static_cast<std::size_t>(body.face->panel);
    const auto outline = outlineOf(body.panels[panel]);
    const glm::dvec2 middle = 0.25 * (outline[0] + outline[1] + outline[2] + outline[3]);
    const double c = std::cos(body.face->turned_rad), s = std::sin(body.face->turned_rad);
    glm::dmat4 probeToPanel(1.0);  // lateral along the panel, axial out of it
    probeToPanel[0] = {c, s, 0.0, 0.0};
    probeToPanel[1] = {0.0, 0.0, 1.0, 0.0};
    probeToPanel[2] = {s, -c, 0.0, 0.0};
    probeToPanel[3] = {middle.x, middle.y, body.face->away_mm, 1.0};
    made.probeToTool.matrix = poses[panel] * probeToPanel;
    made.probeToTool.matrix[3] -= glm::dvec4(centre, 0.0);
    made.faceIsExact = body.face->isExact;
  }
  return scaled(std::move(made), factor);
}

MarkerBody scaled(MarkerBody body, double factor) {
  EW_EXPECTS(factor > 0.0);
  for (Marker& marker : body.markers)
    for (glm::dvec3& corner : marker.corners_mm) corner *= factor;
  body.probeToTool.matrix[3] = glm::dvec4(factor * glm::dvec3(body.probeToTool.matrix[3]), 1.0);
  return body;
}

CalibrationBoard printedBoard(const PaperBody& body, double factor) {
  EW_EXPECTS(body.chess.has_value() && factor > 0.0);
  CalibrationBoard board = *body.chess;
  board.id = body.id;
  board.dictionary = body.dictionary;
  board.square_mm *= factor;
  board.marker_mm *= factor;
  return board;
}

}  // namespace ew
