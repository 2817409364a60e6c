#pragma once

#include <functional>
#include <memory>
#include <string>

#include "ew/sdk/case_parts.h"
#include "ew/sdk/host.h"
#include "ew/sdk/overlays.h"
#include "ew/sdk/scan.h"
#include "sweep_plan.h"

namespace guided_sweep {

/// What is written over the views, in the user's language.
struct Words {
  std::string start = "Start", end = "End";
  std::string here = "Target";
  std::string ahead = "Target, %1 mm out of the image";  ///< %1 whole millimetres
};

/// The plan of the open case, the drawings that show it, and the hold on the probe. Without Qt.
class Guide {
 public:
  Guide(ew::sdk::Host& host, Words words);

  [[nodiscard]] const SweepPlan& plan() const { return plan_; }
  /// Each is one undoable step of the case, called `what`. @error as CaseParts::edit, badUsage (nothing is scanned)
  [[nodiscard]] ew::Result<void> takeStart(const std::string& what);
  [[nodiscard]] ew::Result<void> takeEnd(const std::string& what);
  [[nodiscard]] ew::Result<void> setDuration(double duration_s, const std::string& what);
  /// Moves the probe along the plan, and gives it back at its end. Nothing happens without a whole plan.
  void run();
  void giveBack();
  [[nodiscard]] bool isRunning() const { return hold_ != nullptr; }

  std::function<void()> onChanged;  ///< the plan, or whether the probe is held

 private:
  [[nodiscard]] ew::Result<void> edit(SweepPlan plan, const std::string& what, const std::string& mergeKey);
  [[nodiscard]] ew::Result<ew::Pose> poseNow() const;
  void readPlan();
  void follow(const ew::Pose& pose);
  void drawPlan();
  void tellChanged() {
    if (onChanged) onChanged();
  }

  ew::sdk::Host& host_;
  Words words_;
  SweepPlan plan_;
  std::vector<ew::Point<ew::frame::World>> travelled_;  ///< by the face, while the probe is held
  double end_s_ = 0.0;
  std::shared_ptr<ew::sdk::ScanOverlay> overScan_;
  std::shared_ptr<ew::sdk::BodyOverlay> overBody_;
  ew::sdk::Ticket section_, edits_, opened_, events_, hold_;
};

}  // namespace guided_sweep
