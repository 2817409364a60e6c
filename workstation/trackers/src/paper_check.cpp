#include "paper_check.h"

#include <algorithm>
#include <limits>
#include <set>

#include "ew/core/figures.h"

namespace ew {
namespace {

using Quad = std::array<glm::dvec2, 4>;

constexpr double kMeets_mm = 0.2;  // what a careful hand folds and cuts

Message millimetres(double value) { return fixedNumeral(value, 1); }

/// How far p lies inside a convex quad that goes counter-clockwise; negative outside.
double depthInside(const Quad& quad, const glm::dvec2& p) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < 4; ++n) {
    const glm::dvec2 along = glm::normalize(quad[(n + 1) % 4] - quad[n]);
    least = std::min(least, along.x * (p.y - quad[n].y) - along.y * (p.x - quad[n].x));
  }
  return least;
}

/// Whether no line along an edge of either has them on its two sides: convex shapes that do not overlap always have one.
bool overlap(const Quad& a, const Quad& b) {
  const auto separates = [](const Quad& from, const Quad& other) {
    constexpr double kTouch_mm = 0.01;
    for (std::size_t n = 0; n < 4; ++n) {
      const glm::dvec2 along = glm::normalize(from[(n + 1) % 4] - from[n]);
      if (std::all_of(other.begin(), other.end(),
                      [&](const glm::dvec2& p) { return along.x * (p.y - from[n].y) - along.y * (p.x - from[n].x) < kTouch_mm; }))
        return true;
    }
    return false;
  };
  return !separates(a, b) && !separates(b, a);
}

Quad placed(const Quad& quad, const glm::dmat4& pose) {
  Quad made{};
  for (std::size_t n = 0; n < 4; ++n) made[n] = glm::dvec2(pose * glm::dvec4(quad[n], 0.0, 1.0));
  return made;
}

void checkMarkers(const PaperBody& body, const JsonFields& document) {
  std::set<int> ids;
  for (const PaperPanel& panel : body.panels) {
    const Quad outline = outlineOf(panel);
    for (const PaperMarker& marker : panel.markers) {
      const Message found = say<"marker %1 on panel %2">(marker.id, panel.id);
      if (!ids.insert(marker.id).second) document.refuse("panels", found, say<"a marker that stands on one panel only">());
      // A detector needs a white border of about one module, and all of our dictionaries have at least six to eight modules a side.
      const double border_mm = marker.side_mm / 10.0;
      for (const glm::dvec2& corner : cornersOf(marker))
        if (depthInside(outline, corner) < border_mm)
          return document.refuse("panels", found, say<"a marker with at least %1 mm of white paper around it">(millimetres(border_mm)));
      for (const PaperMarker& other : panel.markers)
        if (&other != &marker && glm::distance(other.centre_mm, marker.centre_mm) < 0.5 * (other.side_mm + marker.side_mm) + border_mm)
          return document.refuse("panels", found, say<"a marker with at least %1 mm of white paper around it">(millimetres(border_mm)));
    }
  }
  if (ids.empty()) document.refuse("panels", say<"panels without a marker">(), say<"at least one marker on a panel">());
}

void checkSeams(const PaperBody& body, const JsonFields& document) {
  const auto poses = panelPoses(body, 1.0);
  const auto end = [&](int panel, PaperEdge edge, std::size_t which) {
    const auto p = static_cast<std::size_t>(panel);
    return glm::dvec3(poses[p] * glm::dvec4(outlineOf(body.panels[p])[(static_cast<std::size_t>(edge) + which) % 4], 0.0, 1.0));
  };
  for (const PaperSeam& seam : body.seams) {
    const double apart_mm = std::max(glm::distance(end(seam.panel, seam.edge, 0), end(seam.meets, seam.meetsEdge, 1)),
                                     glm::distance(end(seam.panel, seam.edge, 1), end(seam.meets, seam.meetsEdge, 0)));
    if (apart_mm > kMeets_mm)
      return document.refuse("seams",
                             say<"a seam of %1 and %2 whose edges lie %3 mm apart when it is folded">(
                                 body.panels[static_cast<std::size_t>(seam.panel)].id, body.panels[static_cast<std::size_t>(seam.meets)].id,
                                 millimetres(apart_mm)),
                             say<"one whose edges meet: correct sizes or fold_deg">());
  }
}

void checkOverlaps(const PaperBody& body, const JsonFields& document) {
  const auto poses = panelPoses(body, 0.0);
  std::vector<std::pair<Quad, std::string>> pieces;
  for (std::size_t n = 0; n < body.panels.size(); ++n) pieces.emplace_back(placed(outlineOf(body.panels[n]), poses[n]), body.panels[n].id);
  for (const PaperSeam& seam : body.seams) {
    const auto n = static_cast<std::size_t>(seam.panel);
    if (seam.tab_mm > 0.0) pieces.emplace_back(placed(tabOf(body.panels[n], seam.edge, seam.tab_mm), poses[n]), body.panels[n].id);
  }
  for (std::size_t a = 0; a < pieces.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (overlap(pieces[a].first, pieces[b].first))
        return document.refuse("panels",
                               say<"a net in which %1 and %2, or a glue tab of theirs, overlap">(pieces[b].second, pieces[a].second),
                               say<"one that lies flat on the sheet">());
}

}  // namespace

void checkPaper(const PaperBody& body, const JsonFields& document) {
  checkMarkers(body, document);
  if (document.good()) checkSeams(body, document);
  if (document.good()) checkOverlaps(body, document);
}

}  // namespace ew
