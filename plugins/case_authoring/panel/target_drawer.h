#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "ew/sdk/host.h"
#include "ew/sdk/overlays.h"
#include "ew/sdk/scan.h"

namespace ew::case_authoring {

class Painting;

/// Draws the targets of the open case: into the scan the chosen one where the image plane meets it, into the body all of them. Nothing is
/// drawn while it is hidden.
class TargetDrawer {
 public:
  explicit TargetDrawer(sdk::Host& host);

  void setShown(bool shown);
  /// @param chosen number of the target; one that is none chooses nothing
  void setTargets(const Case& shown, std::size_t chosen);
  /// Labels that are being painted are drawn in place of those of the case; null: nothing is painted.
  void setPainting(const Painting* painting);
  /// Draws into the image of this state, which also is where an outline that is being traced lies.
  void see(const ScanState& image);

 private:
  void drawBody();
  void showOrgan();
  [[nodiscard]] int chosenLabel() const;
  [[nodiscard]] std::vector<sdk::OverlayLine<frame::Probe>> outlines(const ScanState& image) const;

  sdk::Host& host_;
  bool isShown_ = false;
  Case case_;
  std::size_t chosen_ = 0;
  const Painting* painting_ = nullptr;
  std::shared_ptr<sdk::ScanOverlay> overScan_;
  std::shared_ptr<sdk::BodyOverlay> overBody_;
  sdk::Ticket inBody_;
  int shownOrgan_ = 0;
};

/// The part of an image plane that a probe sees: half its width, and how far down, mm.
[[nodiscard]] glm::dvec2 seenSize_mm(const ScanState& image);
/// The label of a structure: its own, or of its organ in the tissues of what is scanned; 0: none.
[[nodiscard]] int labelIn(const CaseTarget& target, const std::optional<ScanState>& image);

}  // namespace ew::case_authoring
