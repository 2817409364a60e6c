#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ew/core/message.h"
#include "ew/core/result.h"
#include "ew/paper/paper_size.h"
#include "ew/trackers/paper_body.h"

namespace ew {

/// Places on a page: mm from its upper left corner, y down, as the page is read.
struct SheetLine {
  enum class Kind {
    cut,    ///< solid
    fold,   ///< dashed
    shape,  ///< dotted: to cut to the shape of a probe
    scale,  ///< of the scale of 100 mm
  };
  Kind kind = Kind::cut;
  glm::dvec2 from{0.0};
  glm::dvec2 to{0.0};
  bool operator==(const SheetLine&) const = default;
};

struct SheetMarker {
  int id = 0;
  std::array<glm::dvec2, 4> corners{};  ///< as Marker::corners_mm
  bool operator==(const SheetMarker&) const = default;
};

struct SheetText {
  std::vector<Message> paragraphs;
  glm::dvec2 at{0.0};       ///< upper left corner of its box
  glm::dvec2 box_mm{0.0};   ///< lines are broken to its width
  double letters_mm = 4.0;  ///< size of the font; smaller when the box asks for it, never below half
  bool isBold = false;
  bool isMiddle = false;  ///< in the middle of its box
};

/// One page: a body's net with what to do with it and a scale of 100 mm in both directions.
struct SheetPage {
  std::string body;         ///< its id
  glm::dvec2 size_mm{0.0};  ///< as it is read: upright or lying
  glm::dvec2 netAt{0.0};    ///< where the origin of the first panel lies
  std::string dictionary;   ///< of the markers
  std::vector<SheetLine> lines;
  std::vector<SheetMarker> markers;
  std::vector<std::array<glm::dvec2, 4>> blackSquares;  ///< of a chess board
  std::vector<SheetText> texts;
  std::array<SheetLine, 2> scales{};  ///< across and along, 100 mm each
};

/// Lays a body out. @param paper that every printer's margin of 8 mm is kept free of
/// @error tooLarge: the net, the scales and what has to be read do not fit
/// @param language as writeMarkerSheet
[[nodiscard]] Result<SheetPage> layOut(const PaperBody& body, PaperSize paper, std::string_view language = "en");

/// What a message is printed as: english() or the window's translation.
using SheetWords = std::function<std::string(const Message&)>;

/// One page for each body as PDF, exact in its squares and lines. Replaces a file that is there.
/// @param language of the names and notes that stand in the bodies' files: "en", "de"
/// @error tooLarge (as layOut, and texts that do not fit), notWritable
[[nodiscard]] Result<void> writeMarkerSheet(std::span<const PaperBody> bodies, PaperSize paper, const std::filesystem::path& file,
                                            const SheetWords& words = {}, std::string_view language = "en");

/// What the lengths of a body are to be multiplied by. @param measured_mm what the printed scale of 100 mm measures
/// @error badField below 90 or above 110 mm: then the printer fits pages to its paper, and the sheet is to be printed again at 100 %
[[nodiscard]] Result<double> printedFactor(double measured_mm);

/// What the scale measured on this user's last print, mm: FOLDER/printed.json, FOLDER being `trackers` in the user's library; 100 without
/// it.
/// @error badHeader (not JSON), badField, newerFormat
[[nodiscard]] Result<double> readPrintedScale(const std::filesystem::path& folder);
/// @error as printedFactor; notWritable
[[nodiscard]] Result<void> keepPrintedScale(const std::filesystem::path& folder, double measured_mm);

}  // namespace ew
