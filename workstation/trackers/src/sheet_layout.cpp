#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <optional>
#include <set>

#include "ew/trackers/marker_sheet.h"
#include "marker_dictionary.h"
#include "sheet_space.h"

namespace ew {
namespace {

constexpr double kMargin_mm = 8.0;  // what home printers leave white
constexpr double kScale_mm = 100.0;

using PageQuad = std::array<glm::dvec2, 4>;

/// A net on its page: panels and tabs by the page's coordinates.
struct NetPlacement {
  std::vector<glm::dmat4> poses;
  glm::dvec2 at{0.0};  ///< of the net's origin on the page
  [[nodiscard]] glm::dvec2 onPage(std::size_t panel, const glm::dvec2& p) const {
    const glm::dvec2 net(poses[panel] * glm::dvec4(p, 0.0, 1.0));
    return {at.x + net.x, at.y - net.y};
  }
  [[nodiscard]] PageQuad onPage(std::size_t panel, const PageQuad& quad) const {
    PageQuad made{};
    for (std::size_t n = 0; n < 4; ++n) made[n] = onPage(panel, quad[n]);
    return made;
  }
};

std::vector<PageQuad> piecesOf(const PaperBody& body, const NetPlacement& net) {
  std::vector<PageQuad> pieces;
  for (std::size_t n = 0; n < body.panels.size(); ++n) pieces.push_back(net.onPage(n, outlineOf(body.panels[n])));
  for (const PaperSeam& seam : body.seams) {
    const auto n = static_cast<std::size_t>(seam.panel);
    if (seam.tab_mm > 0.0) pieces.push_back(net.onPage(n, tabOf(body.panels[n], seam.edge, seam.tab_mm)));
  }
  return pieces;
}

void addLines(const PaperBody& body, const NetPlacement& net, SheetPage& page) {
  std::set<std::pair<std::size_t, PaperEdge>> folded;
  for (std::size_t n = 0; n < body.panels.size(); ++n)
    if (body.panels[n].on >= 0) {
      folded.insert({n, body.panels[n].edge});
      folded.insert({static_cast<std::size_t>(body.panels[n].on), body.panels[n].onEdge});
    }
  const auto add = [&](SheetLine::Kind kind, std::size_t n, const glm::dvec2& from, const glm::dvec2& to) {
    page.lines.push_back({kind, net.onPage(n, from), net.onPage(n, to)});
  };
  std::set<std::pair<std::size_t, PaperEdge>> tabbed;
  for (const PaperSeam& seam : body.seams) {
    if (!(seam.tab_mm > 0.0)) continue;
    const auto n = static_cast<std::size_t>(seam.panel);
    tabbed.insert({n, seam.edge});
    const PageQuad tab = tabOf(body.panels[n], seam.edge, seam.tab_mm);
    for (std::size_t side = 0; side < 3; ++side) add(SheetLine::Kind::cut, n, tab[side], tab[side + 1]);
  }
  for (std::size_t n = 0; n < body.panels.size(); ++n) {
    const PaperPanel& panel = body.panels[n];
    const PageQuad outline = outlineOf(panel);
    for (std::size_t side = 0; side < 4; ++side) {
      const std::pair key{n, static_cast<PaperEdge>(side)};
      const bool isFold = folded.contains(key);
      if (isFold && (panel.on < 0 || key.second != panel.edge)) continue;  // drawn once, by the panel that hangs there
      add(isFold || tabbed.contains(key) ? SheetLine::Kind::fold : SheetLine::Kind::cut, n, outline[side], outline[(side + 1) % 4]);
    }
    constexpr int kSides = 60;
    for (int k = 0; k < kSides && panel.hole_mm.x > 0.0; ++k) {
      const auto at = [&](int step) {
        const double angle = 2.0 * std::numbers::pi * step / kSides;
        return glm::dvec2(0.5 * panel.width_mm, 0.5 * panel.height_mm) + 0.5 * panel.hole_mm * glm::dvec2(std::cos(angle), std::sin(angle));
      };
      add(SheetLine::Kind::shape, n, at(k), at(k + 1));
    }
  }
}

void addMarkers(const PaperBody& body, const NetPlacement& net, SheetPage& page) {
  for (std::size_t n = 0; n < body.panels.size(); ++n)
    for (const PaperMarker& marker : body.panels[n].markers) page.markers.push_back({marker.id, net.onPage(n, cornersOf(marker))});
  if (!body.chess) return;
  const double square = body.chess->square_mm, border = 0.5 * (square - body.chess->marker_mm);
  CalibrationBoard board = *body.chess;
  board.dictionary = body.dictionary;
  for (const ChessSquare& each : chessSquares(board)) {
    const double inset = each.marker < 0 ? 0.0 : border;
    const glm::dvec2 low(each.column * square + inset, (board.rows - 1 - each.row) * square + inset);
    const double side = square - 2.0 * inset;
    const PageQuad quad = net.onPage(0, PageQuad{low + glm::dvec2(0.0, side), low + glm::dvec2(side), low + glm::dvec2(side, 0.0), low});
    if (each.marker < 0)
      page.blackSquares.push_back(quad);
    else
      page.markers.push_back({each.marker, quad});
  }
}

void addNotes(const PaperBody& body, const NetPlacement& net, std::string_view language, SheetPage& page) {
  for (std::size_t n = 0; n < body.panels.size(); ++n) {
    const PaperPanel& panel = body.panels[n];
    if (panel.note.in(language).empty()) continue;
    const double y = panel.hole_mm.y > 0.0 ? 0.25 * (panel.height_mm - panel.hole_mm.y) : 0.72 * panel.height_mm;
    const double wide = panel.width_mm + (panel.end_mm - panel.width_mm) * y / panel.height_mm;
    const glm::dvec2 box(0.85 * wide, 7.0);
    page.texts.push_back({.paragraphs = {verbatim(panel.note.in(language))},
                          .at = net.onPage(n, glm::dvec2(0.5 * panel.width_mm, y)) - 0.5 * box,
                          .box_mm = box,
                          .isMiddle = true});
  }
}

std::vector<Message> stepsOf(const PaperBody& body) {
  const Message print = say<"1. Print at 100 % (actual size, not fitted to the page) on stiff white paper.">();
  const Message measure =
      say<"2. Measure both scales: each is 100 mm long. If not, print again at 100 %, or tell EchoWeave the length you measured.">();
  switch (body.kind) {
    case PaperKind::board:
      return {print, measure, say<"3. Cut along the solid lines and glue it flat onto stiff card.">(),
              say<"4. Fix it beside the mannequin where the camera sees both. From then on neither may move against the other.">()};
    case PaperKind::calibration:
      return {print, measure, say<"3. Glue the whole sheet flat onto stiff card, without waves.">(),
              say<"4. Show it to the camera from all sides and at several distances; the wizard says where it is missing.">()};
    case PaperKind::held:
      break;
  }
  const Message fold = say<"3. Cut along the solid lines, fold the dashed lines away from the print, and glue the tabs inside.">();
  if (body.face && !body.face->isExact)
    return {print, measure, fold,
            say<"4. Cut the dotted ovals to the shape of your probe and push the sleeve onto it so that it cannot move. The wizard then "
                "finds the "
                "probe's face.">()};
  return {print, measure, fold,
          say<"4. Hold it by its nose like a probe: the small end is the face that touches the skin. The marker side is printed on it.">()};
}

/// Two scales and the block of text, each where there is still room.
bool addWords(const PaperBody& body, SheetSpace& space, std::string_view language, SheetPage& page) {
  const glm::dvec2 acrossBox(kScale_mm + 4.0, 8.0), alongBox(10.0, kScale_mm + 4.0);
  const auto along = space.take(alongBox);
  const auto across = space.take(acrossBox);
  if (!along || !across) return false;
  const glm::dvec2 a = *across + glm::dvec2(2.0, 6.5), d = *along + glm::dvec2(7.5, 2.0);
  page.scales = {SheetLine{SheetLine::Kind::scale, a, a + glm::dvec2(kScale_mm, 0.0)},
                 SheetLine{SheetLine::Kind::scale, d, d + glm::dvec2(0.0, kScale_mm)}};
  constexpr double kFewest_mm2 = 3300.0;  // half-size letters of the longest steps in German still fit
  const auto room = space.largest(38.0, 20.0);
  if (!room || room->size.x * room->size.y < kFewest_mm2) return false;
  const glm::dvec2 at = room->at, size = glm::min(room->size, glm::dvec2(200.0, 90.0));
  constexpr double kTitle_mm = 8.0;
  page.texts.push_back({.paragraphs = {say<"%1, version %2">(body.name.in(language), body.version)},
                        .at = at,
                        .box_mm = {size.x, kTitle_mm},
                        .letters_mm = 5.5,
                        .isBold = true});
  page.texts.push_back({.paragraphs = stepsOf(body), .at = at + glm::dvec2(0.0, kTitle_mm), .box_mm = size - glm::dvec2(0.0, kTitle_mm)});
  return true;
}

std::optional<SheetPage> layOutOn(const PaperBody& body, const glm::dvec2& size_mm, std::string_view language) {
  NetPlacement net{panelPoses(body, 0.0), glm::dvec2(0.0)};
  glm::dvec2 low(std::numeric_limits<double>::infinity()), high(-std::numeric_limits<double>::infinity());
  for (const PageQuad& piece : piecesOf(body, net))
    for (const glm::dvec2& p : piece) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  const glm::dvec2 room = size_mm - 2.0 * kMargin_mm;
  if (high.x - low.x > room.x || high.y - low.y > room.y) return std::nullopt;
  net.at = kMargin_mm - low;
  SheetPage page;
  page.body = body.id;
  page.size_mm = size_mm;
  page.netAt = net.at;
  page.dictionary = body.dictionary;
  SheetSpace space(glm::dvec2(kMargin_mm), room);
  for (const PageQuad& piece : piecesOf(body, net)) space.occupy(piece, 2.0);
  if (!addWords(body, space, language, page)) return std::nullopt;
  if (!body.chess) addLines(body, net, page);  // a chess board ends with its squares
  addMarkers(body, net, page);
  addNotes(body, net, language, page);
  return page;
}

}  // namespace

Result<SheetPage> layOut(const PaperBody& body, PaperSize paper, std::string_view language) {
  const glm::dvec2 upright = sizeOf(paper);
  for (const glm::dvec2& size : {upright, glm::dvec2(upright.y, upright.x)})
    if (auto page = layOutOn(body, size, language)) return *page;
  return failure(ErrorCode::tooLarge,
                 say<"The marker body %1 does not fit on a sheet of %2 together with its scales and its instructions; make it smaller.">(
                     body.id, verbatim(paper == PaperSize::a4 ? "A4" : "Letter")),
                 {{"body", body.id}});
}

Result<double> printedFactor(double measured_mm) {
  if (std::isfinite(measured_mm) && measured_mm >= 90.0 && measured_mm <= 110.0) return measured_mm / kScale_mm;
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", measured_mm);
  return failure(ErrorCode::badField,
                 say<"The scale of 100 mm cannot measure %1 mm; measure again, or print again at 100 % (actual size).">(numeral(text)),
                 {{"field", "measured_scale_mm"}, {"found", text}, {"expected", "90 to 110"}});
}

}  // namespace ew
