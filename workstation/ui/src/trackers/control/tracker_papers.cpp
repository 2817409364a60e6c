#include "trackers/control/tracker_papers.h"

#include <QLocale>
#include <algorithm>

#include "ew/library/folders.h"
#include "ew/trackers/marker_sheet.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

constexpr double kPrintedScale_mm = 100.0;

std::filesystem::path scaleFolder() { return libraryFolder() / "trackers"; }

}  // namespace

void TrackerPapers::read() {
  std::vector<std::filesystem::path> folders;
  if (const auto resources = resourceFolder()) folders.push_back(*resources / "marker_bodies");
  folders.push_back(libraryFolder() / "trackers" / "bodies");
  auto found = readPaperBodies(folders);
  problem_ = found ? Message() : found.error().message;
  all_ = found ? std::move(*found) : std::vector<PaperBody>{};
  if (found && all_.empty()) problem_ = say<"No paper body is installed; install EchoWeave again.">();
}

double TrackerPapers::measuredScale_mm() const { return readPrintedScale(scaleFolder()).value_or(kPrintedScale_mm); }

Result<void> TrackerPapers::keepMeasuredScale(double mm) { return keepPrintedScale(scaleFolder(), mm); }

std::vector<MarkerBody> TrackerPapers::bodies() const {
  std::vector<MarkerBody> made;
  const double factor = printedFactor(measuredScale_mm()).value_or(1.0);
  for (const PaperBody& each : all_)
    if (each.kind != PaperKind::calibration) made.push_back(foldedBody(each, factor));
  return made;
}

MarkerBody TrackerPapers::bodyCalled(const std::string& body) const {
  for (MarkerBody& each : bodies())
    if (each.id == body) return each;
  return {};
}

CharucoBoard TrackerPapers::charucoBoard() const {
  const auto paper = std::find_if(all_.begin(), all_.end(), [](const PaperBody& each) { return each.kind == PaperKind::calibration; });
  if (paper == all_.end()) return {};
  const CalibrationBoard printed = printedBoard(*paper, printedFactor(measuredScale_mm()).value_or(1.0));
  return {printed.columns, printed.rows, printed.square_mm, printed.marker_mm, printed.dictionary};
}

Result<void> TrackerPapers::writeSheet(const std::filesystem::path& file, const std::string& body, bool isLetter) const {
  std::vector<PaperBody> wanted;
  for (const PaperBody& each : all_)
    if (each.id == body || each.kind != PaperKind::held) wanted.push_back(each);
  return writeMarkerSheet(
      wanted, isLetter ? PaperSize::letter : PaperSize::a4, file, [](const Message& text) { return words(text).toStdString(); },
      QLocale().language() == QLocale::German ? "de" : "en");
}

}  // namespace ew::ui
