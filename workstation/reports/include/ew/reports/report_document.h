#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "ew/core/message.h"
#include "ew/reports/report_plot.h"

namespace ew {

// A report as what it says, without how it looks: made once, written as a page (html.h) and on paper (report_pdf.h).

/// How something is meant. Writers show it by colour and by a sign or a word, never by colour alone.
enum class ReportTone { plain, soft, good, bad, caution };

/// @param level 2 to 4; the title of the document has level 1
struct ReportHeading {
  int level = 2;
  Message text;
};
struct ReportParagraph {
  Message text;
  ReportTone tone = ReportTone::plain;
};
struct ReportItem {
  Message text;
  ReportTone tone = ReportTone::plain;
};
struct ReportList {
  std::vector<ReportItem> items;
};
struct ReportFact {
  Message name;
  Message value;
  ReportTone tone = ReportTone::plain;
};
struct ReportFacts {
  std::vector<ReportFact> rows;
};
struct ReportColumn {
  Message name;
  bool isNumber = false;  ///< set to the right, in figures of one width
};
struct ReportCell {
  Message text = {};
  ReportTone tone = ReportTone::plain;
  std::string link = {};            ///< a file beside the page (kept relative); empty: none
  std::vector<Message> below = {};  ///< more to it, softer, a line each
};
/// The first cell of a row names it.
struct ReportTable {
  Message caption;  ///< may be empty
  std::vector<ReportColumn> columns;
  std::vector<std::vector<ReportCell>> rows;  ///< each as long as `columns`
};
/// An image file (PNG or JPEG). One that cannot be shown is said so in its place.
struct ReportImage {
  std::filesystem::path file = {};
  Message caption = {};
  std::string bytes = {};  ///< what the file would hold; empty: it is read
  bool isSmall = false;    ///< two stand side by side where there is room
};
using ReportBlock = std::variant<ReportHeading, ReportParagraph, ReportList, ReportFacts, ReportTable, ReportPlot, ReportImage>;

struct ReportDocument {
  Message title = {};
  Message subtitle = {};                                    ///< under the title; may be empty
  std::vector<std::pair<Message, std::string>> links = {};  ///< to other pages of the same folder, by their file names
  std::vector<ReportBlock> blocks = {};
  std::optional<std::chrono::sys_seconds> at = {};  ///< of the newest thing that it tells of: the date of a file; nothing: none
};

/// Words of a report in somebody's language.
using ReportWords = std::function<std::string(const Message&)>;

struct ReportOptions {
  bool names = false;           ///< of trainees, raters and reviewers; false: codes (pseudonym.h)
  std::string language = "en";  ///< of the words of data files and of cases, and of the page
  ReportWords words = {};       ///< empty: Message::english
  bool images = true;           ///< that were stored, and paths from recordings: without them nothing but scores is read

  [[nodiscard]] std::string say(const Message& message) const { return words ? words(message) : message.english(); }
};

/// What every report carries.
[[nodiscard]] Message simulationSentence();
/// What scores and metrics are worth, and what not.
[[nodiscard]] Message validitySentence();

/// "82 %". @param share 0..1
[[nodiscard]] Message percentText(double share);
/// A score beside the level that it has to reach, 0..1: "70 %", but "69.8 %" where it would seem to reach what it does not.
[[nodiscard]] Message scoreText(double score, double passLevel);
/// A figure with its unit and as many decimals as it deserves: "4.23 mm", "12.5 °", "310 ml".
[[nodiscard]] Message figureText(double value, std::string_view unit);
/// "3 min 05 s" or "12.5 s". @param seconds >= 0
[[nodiscard]] Message durationText(double seconds);

}  // namespace ew
