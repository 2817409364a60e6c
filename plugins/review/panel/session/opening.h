#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "ew/bridge/mannequin.h"
#include "ew/library/case.h"
#include "ew/scanning/subject.h"
#include "logic/scan_shelf.h"
#include "panel/session/review_scan.h"

namespace ew::review {

/// What one job opens, from choices to all that is shown.
struct Opening {
  std::array<std::optional<ScanChoice>, 2> choices;
  std::shared_ptr<const ScanShelf> shelf;
  std::map<std::filesystem::path, std::pair<Case, CaseContents>> contents;  ///< known already, and what was read
  std::filesystem::path mannequinFile;
  std::shared_ptr<const bridge::Mannequin> mannequin;
  std::array<std::shared_ptr<const ReviewScan>, 2> opened;
  std::optional<LessonStep> step;  ///< that metrics are of
  std::optional<Error> problem;    ///< why there is nothing to compare with

  /// On a worker. @error as openScan, caseOf, loadCase, readContents, loadMannequin; cancelled
  [[nodiscard]] Result<void> run(Progress& progress);

 private:
  using Contents = std::map<std::filesystem::path, std::pair<Case, CaseContents>>;
  [[nodiscard]] Result<void> open(Side side, Contents& used, Progress& progress);
  [[nodiscard]] Result<void> readCase(const std::filesystem::path& folder, Contents& used, Progress& progress) const;
  [[nodiscard]] Result<void> look(Side side, ReviewScan& made, Progress& progress) const;
  [[nodiscard]] Result<void> measure(const Case& home, const CaseContents& held, ReviewScan& made, Progress& progress) const;
  [[nodiscard]] Result<void> readMannequin(const Case& home, Progress& progress);
};

}  // namespace ew::review
