#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/data_file.h"
#include "ew/trackers/marker_body.h"

namespace ew {

/// What a sheet of paper becomes.
enum class PaperKind {
  held,         ///< folded, and held or fixed to a probe
  board,        ///< flat, fixed to the mannequin
  calibration,  ///< a flat chess board with markers in its white squares, for the camera's own calibration
};

/// Of a panel as one looks at its printed side.
enum class PaperEdge { bottom, right, top, left };

struct PaperMarker {
  int id = 0;
  glm::dvec2 centre_mm{0.0};  ///< on its panel
  double side_mm = 0.0;       ///< of the black square
  double turned_rad = 0.0;    ///< counter-clockwise
  bool operator==(const PaperMarker&) const = default;
};

/// A flat piece between folds: a trapezoid, upright and symmetric. Its own coordinates, mm: x to the right, y up, z out of the printed
/// side; the origin lies at the left end of the bottom edge.
struct PaperPanel {
  std::string id;
  double width_mm = 0.0;   ///< of the bottom edge
  double height_mm = 0.0;  ///< from the bottom edge to the top edge
  double end_mm = 0.0;     ///< length of the top edge
  int on = -1;             ///< index of an earlier panel that it hangs on; -1: the first one, which hangs on none
  PaperEdge onEdge = PaperEdge::bottom;
  PaperEdge edge = PaperEdge::top;  ///< its own, along the fold
  double fold_rad = 0.0;            ///< away from the printed side; 0: flat
  glm::dvec2 hole_mm{0.0};          ///< width and height of a dashed oval to cut to the shape of a probe; 0: none
  Words note;                       ///< printed on it; may be empty
  std::vector<PaperMarker> markers;
  bool operator==(const PaperPanel&) const = default;
};

/// Two edges that come to lie on each other when the net is folded.
struct PaperSeam {
  int panel = 0;
  PaperEdge edge = PaperEdge::left;
  int meets = 0;
  PaperEdge meetsEdge = PaperEdge::right;
  double tab_mm = 0.0;  ///< depth of the glue tab at `edge` of `panel`; 0: none
  bool operator==(const PaperSeam&) const = default;
};

/// Which panel is the transducer face, or what it lies in front of.
struct PaperFace {
  int panel = 0;
  double turned_rad = 0.0;  ///< of the lateral direction (to the marker) against the panel's x, counter-clockwise
  double away_mm = 0.0;     ///< the face lies so far in front of the panel
  bool isExact = true;      ///< false: where it lies has to be found by touching, since a probe of its own is inside
  bool operator==(const PaperFace&) const = default;
};

/// A chess board with a marker in each white square.
struct CalibrationBoard {
  std::string id;
  std::string dictionary = "aruco_5x5_100";
  int columns = 0;  ///< squares
  int rows = 0;
  double square_mm = 0.0;
  double marker_mm = 0.0;
  bool operator==(const CalibrationBoard&) const = default;
};

/// A body as it lies on the sheet, from which the net to print and the folded body follow alike.
struct PaperBody {
  std::string id;  ///< file name without ending
  Words name;
  int version = 1;  ///< printed on the sheet: a body of another version has other measures
  PaperKind kind = PaperKind::held;
  std::string dictionary = "apriltag_36h11";
  std::vector<PaperPanel> panels;  ///< of a calibration board: one, without markers
  std::vector<PaperSeam> seams;
  std::optional<PaperFace> face;          ///< of a held body
  std::optional<CalibrationBoard> chess;  ///< of a calibration board
  bool operator==(const PaperBody&) const = default;
};

/// One JSON file of resources/marker_bodies; its format is told in resources/docs/technician/tracker-bodies.md.
/// @error notFound, badHeader (not JSON), newerFormat, badField (name, value found, value expected; also: edges of a seam that do not meet
///        when it is folded, panels or tabs that overlap in the net, markers that leave their panel or lack a white border, an id twice)
[[nodiscard]] Result<PaperBody> readPaperBody(const std::filesystem::path& file);
/// Every body of the folders, by id; of two with one id that of the later folder. A folder that is not there has none.
/// @error as readPaperBody; badField: a marker that two bodies share
[[nodiscard]] Result<std::vector<PaperBody>> readPaperBodies(const std::vector<std::filesystem::path>& folders);

/// The four corners of a panel, counter-clockwise from the left end of the bottom edge, in its own coordinates: edge n goes from corner n
/// to corner n + 1, in the order of PaperEdge.
[[nodiscard]] std::array<glm::dvec2, 4> outlineOf(const PaperPanel& panel);
/// Corners of a marker in the order of Marker::corners_mm, in the panel's coordinates.
[[nodiscard]] std::array<glm::dvec2, 4> cornersOf(const PaperMarker& marker);
/// A glue tab, counter-clockwise, in the coordinates of the panel it hangs on.
[[nodiscard]] std::array<glm::dvec2, 4> tabOf(const PaperPanel& panel, PaperEdge edge, double depth_mm);

/// Where each panel lies in the frame of the first one: `folding` 0 in the flat net (z = 0), 1 folded as the file says.
[[nodiscard]] std::vector<glm::dmat4> panelPoses(const PaperBody& body, double folding);

/// What a camera looks for when it was folded exactly. Its frame has the axes of the first panel and its origin in the mean of all corners
/// of markers. @param body not a calibration board
/// @param factor see scaled()
[[nodiscard]] MarkerBody foldedBody(const PaperBody& body, double factor = 1.0);

/// The chess board as it was printed. @param body a calibration board
[[nodiscard]] CalibrationBoard printedBoard(const PaperBody& body, double factor = 1.0);

}  // namespace ew
