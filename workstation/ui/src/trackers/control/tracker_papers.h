#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "ew/core/result.h"
#include "ew/trackers/camera_calibration.h"
#include "ew/trackers/paper_body.h"

namespace ew::ui {

/// The paper that cameras look for: bodies and boards, how large the printer made them, and the sheets to print. All calls from one thread.
class TrackerPapers {
 public:
  /// Reads what is installed and what the user's library adds; after a failure there are none, and problem() says why.
  void read();
  [[nodiscard]] const std::vector<PaperBody>& all() const { return all_; }
  [[nodiscard]] const Message& problem() const { return problem_; }

  /// Of the printed line of 100 mm; 100 where nobody measured it.
  [[nodiscard]] double measuredScale_mm() const;
  /// @error as keepPrintedScale
  [[nodiscard]] Result<void> keepMeasuredScale(double mm);

  /// Bodies and boards that can be tracked, as large as they were printed.
  [[nodiscard]] std::vector<MarkerBody> bodies() const;
  /// Without an id where there is none of that name.
  [[nodiscard]] MarkerBody bodyCalled(const std::string& body) const;
  /// The chess board that a lens is measured with, as large as it was printed; a default one where there is none.
  [[nodiscard]] CharucoBoard charucoBoard() const;
  /// The body to hold, the board for the mannequin and the chess board. @error as writeMarkerSheet
  [[nodiscard]] Result<void> writeSheet(const std::filesystem::path& file, const std::string& body, bool isLetter) const;

 private:
  std::vector<PaperBody> all_;
  Message problem_;
};

}  // namespace ew::ui
