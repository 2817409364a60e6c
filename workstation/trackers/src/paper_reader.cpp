#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numbers>
#include <utility>

#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"
#include "ew/trackers/paper_body.h"
#include "marker_dictionary.h"
#include "paper_check.h"

namespace ew {
namespace {

constexpr int kPaperFormat = 1;
constexpr double kLongest_mm = 1000.0;
constexpr double kDegree = std::numbers::pi / 180.0;

constexpr std::array<std::pair<std::string_view, PaperKind>, 3> kPaperKinds = {
    {{"held", PaperKind::held}, {"board", PaperKind::board}, {"calibration", PaperKind::calibration}}};
constexpr std::array<std::pair<std::string_view, PaperEdge>, 4> kPaperEdges = {
    {{"bottom", PaperEdge::bottom}, {"right", PaperEdge::right}, {"top", PaperEdge::top}, {"left", PaperEdge::left}}};

glm::dvec2 pairIn(const JsonFields& fields, std::string_view key, double lowest) {
  const auto two = fields.numbers(key, 2, 2, lowest, kLongest_mm);
  return two.size() == 2 ? glm::dvec2(two[0], two[1]) : glm::dvec2(0.0);
}

int panelNamed(const JsonFields& fields, std::string_view key, const std::vector<PaperPanel>& panels) {
  const std::string id = fields.text(key);
  const auto found = std::find_if(panels.begin(), panels.end(), [&](const PaperPanel& panel) { return panel.id == id; });
  if (found != panels.end()) return static_cast<int>(found - panels.begin());
  if (fields.good()) fields.refuse(key, say<"the id of a panel that stands before it">());
  return 0;
}

PaperMarker markerIn(const JsonFields& fields, int most) {
  fields.only({"id", "centre_mm", "side_mm", "turned_deg"});
  PaperMarker marker;
  marker.id = static_cast<int>(fields.whole("id", 0, most));
  marker.centre_mm = pairIn(fields, "centre_mm", 0.0);
  marker.side_mm = fields.number("side_mm", 5.0, 300.0);
  marker.turned_rad = kDegree * fields.number("turned_deg", -180.0, 180.0, 0.0);
  return marker;
}

/// {"first": 30, "columns": 3, "rows": 4, "pitch_mm": 54, "side_mm": 44}: in the middle of the panel, row by row from the top.
void addGrid(const JsonFields& fields, PaperPanel& panel, int most) {
  fields.only({"first", "columns", "rows", "pitch_mm", "side_mm"});
  const auto columns = static_cast<int>(fields.whole("columns", 1, 20)), rows = static_cast<int>(fields.whole("rows", 1, 20));
  const double pitch_mm = fields.number("pitch_mm", 5.0, 300.0);
  const double side_mm = fields.number("side_mm", 5.0, 300.0);
  const auto first = static_cast<int>(fields.whole("first", 0, most - columns * rows + 1));
  if (!fields.good()) return;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double x = 0.5 * panel.width_mm + (column - 0.5 * (columns - 1)) * pitch_mm;
      const double y = 0.5 * panel.height_mm - (row - 0.5 * (rows - 1)) * pitch_mm;
      panel.markers.push_back({.id = first + row * columns + column, .centre_mm = {x, y}, .side_mm = side_mm});
    }
}

PaperPanel panelIn(const JsonFields& fields, const PaperBody& body) {
  fields.only({"id", "width_mm", "height_mm", "end_mm", "on", "on_edge", "edge", "fold_deg", "hole_mm", "note", "markers", "grid"});
  PaperPanel panel;
  panel.id = fields.text("id", {}, 1, 40);
  if (std::any_of(body.panels.begin(), body.panels.end(), [&](const PaperPanel& other) { return other.id == panel.id; }))
    fields.refuse("id", say<"an id that no other panel has">());
  panel.width_mm = fields.number("width_mm", 4.0, kLongest_mm);
  panel.height_mm = fields.number("height_mm", 4.0, kLongest_mm);
  panel.end_mm = fields.number("end_mm", 4.0, kLongest_mm, panel.width_mm);
  if (!body.panels.empty()) {
    panel.on = panelNamed(fields, "on", body.panels);
    panel.onEdge = fields.word("on_edge", kPaperEdges);
    panel.edge = fields.word("edge", kPaperEdges);
    panel.fold_rad = kDegree * fields.number("fold_deg", -175.0, 175.0);
  } else if (fields.has("on")) {
    fields.refuse("on", say<"nothing: the first panel hangs on none">());
  }
  if (fields.has("hole_mm")) panel.hole_mm = pairIn(fields, "hole_mm", 1.0);
  panel.note = wordsIn(fields, "note", 80, false);
  const int most = markersOf(body.dictionary) - 1;
  for (const JsonFields& each : fields.objects("markers", 0, 200)) panel.markers.push_back(markerIn(each, most));
  if (fields.has("grid")) addGrid(fields.object("grid"), panel, most);
  return panel;
}

PaperSeam seamIn(const JsonFields& fields, const std::vector<PaperPanel>& panels) {
  fields.only({"panel", "edge", "meets", "meets_edge", "tab_mm"});
  PaperSeam seam;
  seam.panel = panelNamed(fields, "panel", panels);
  seam.edge = fields.word("edge", kPaperEdges);
  seam.meets = panelNamed(fields, "meets", panels);
  seam.meetsEdge = fields.word("meets_edge", kPaperEdges);
  seam.tab_mm = fields.number("tab_mm", 0.0, 40.0, 0.0);
  return seam;
}

PaperFace faceIn(const JsonFields& fields, const std::vector<PaperPanel>& panels) {
  fields.only({"panel", "turned_deg", "away_mm", "exact"});
  return {.panel = panelNamed(fields, "panel", panels),
          .turned_rad = kDegree * fields.number("turned_deg", -180.0, 180.0, 0.0),
          .away_mm = fields.number("away_mm", 0.0, 500.0, 0.0),
          .isExact = fields.flag("exact", true)};
}

/// One panel of the size of all squares stands for the board, so that layout and checks are the same as for any other body.
void readChess(const JsonFields& fields, PaperBody& body) {
  fields.only({"columns", "rows", "square_mm", "marker_mm"});
  CalibrationBoard board{.id = body.id, .dictionary = body.dictionary};
  board.columns = static_cast<int>(fields.whole("columns", 3, 30));
  board.rows = static_cast<int>(fields.whole("rows", 3, 30));
  board.square_mm = fields.number("square_mm", 5.0, 200.0);
  board.marker_mm = fields.number("marker_mm", 3.0, 0.9 * std::max(board.square_mm, 5.0));
  if (fields.good() && board.columns * board.rows / 2 > markersOf(body.dictionary))
    fields.refuse("columns", say<"so few squares that the dictionary has a marker for each white one">());
  body.chess = board;
  PaperPanel panel;
  panel.id = "board";
  panel.width_mm = panel.end_mm = board.columns * board.square_mm;
  panel.height_mm = board.rows * board.square_mm;
  body.panels = {panel};
}

void readNet(const JsonFields& document, PaperBody& body) {
  for (const JsonFields& each : document.objects("panels", 1, 60)) body.panels.push_back(panelIn(each, body));
  for (const JsonFields& each : document.objects("seams", 0, 200)) body.seams.push_back(seamIn(each, body.panels));
  if (body.kind == PaperKind::held) body.face = faceIn(document.object("face"), body.panels);
  if (document.good()) checkPaper(body, document);
}

}  // namespace

Result<PaperBody> readPaperBody(const std::filesystem::path& file) {
  const Message where = say<"the marker body %1">(file.string());
  const auto read = readJsonFile(file, where);
  if (!read) return passOn(read.error());
  JsonReading reading(where, {"note", "source", "$schema"});
  const JsonFields document(*read, reading);
  requireFormat(document, kPaperFormat);
  document.only({"format", "name", "version", "kind", "dictionary", "panels", "seams", "face", "chess_board"});
  PaperBody body;
  body.id = file.stem().string();
  body.name = wordsIn(document, "name", 80);
  body.version = static_cast<int>(document.whole("version", 1, 100000));
  body.kind = document.word("kind", kPaperKinds);
  body.dictionary = document.text("dictionary");
  if (document.good() && markersOf(body.dictionary) == 0) document.refuse("dictionary", dictionariesText());
  if (document.good() && body.kind == PaperKind::calibration)
    readChess(document.object("chess_board"), body);
  else if (document.good())
    readNet(document, body);
  if (reading.problem()) return passOn(*reading.problem());
  return body;
}

Result<std::vector<PaperBody>> readPaperBodies(const std::vector<std::filesystem::path>& folders) {
  std::map<std::string, PaperBody> byId;
  for (const auto& folder : folders) {
    std::error_code none;
    if (!std::filesystem::is_directory(folder, none)) continue;
    auto read = readEvery<PaperBody>(folder, say<"marker bodies">(), readPaperBody);
    if (!read) return passOn(read.error());
    for (PaperBody& body : *read) byId[body.id] = std::move(body);
  }
  std::map<std::pair<std::string, int>, std::string> owner;  // of a marker
  std::vector<PaperBody> bodies;
  for (auto& [id, body] : byId) {
    for (const PaperPanel& panel : body.panels)
      for (const PaperMarker& marker : panel.markers) {
        const auto [had, isNew] = owner.try_emplace({body.dictionary, marker.id}, id);
        if (!isNew)
          return failure(
              ErrorCode::badField,
              say<"The marker bodies %1 and %2 both use marker %3; give one of them markers of its own.">(had->second, id, marker.id),
              {{"field", "markers"}, {"found", std::to_string(marker.id)}});
      }
    bodies.push_back(std::move(body));
  }
  return bodies;
}

}  // namespace ew
