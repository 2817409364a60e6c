#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/library/attempt.h"
#include "ew/library/case_truth.h"
#include "ew/library/lesson.h"
#include "ew/scanning/state.h"
#include "ew/sdk/scan.h"

namespace ew::lessons {

/// What a step is judged against: the case's truth, in the world, and what is scanned. Cheap to copy.
struct StepScene {
  std::shared_ptr<const CaseTruth> truth;
  sdk::Scanned scanned;
};

/// What a trainee has handed in when a step ends, beside the scan itself. Only what the step's kind asks for is looked at.
struct Handed {
  std::vector<std::size_t> chosen = {};                 ///< answers, by their place
  std::optional<double> number = {};                    ///< in the step's unit
  std::optional<Point<frame::Probe>> point = {};        ///< that was pointed at, in the image that is shown
  std::vector<sdk::ScanMeasurement> measurements = {};  ///< in the image that is shown; the last one counts
  bool watched = false;                                 ///< the expert's scan to its end
};

/// One figure that is shown while a step runs, and whether it is good enough by now.
struct LiveFigure {
  Message text;
  bool good = false;
};

/// The work of one step as it goes on: it sees every image, says how things stand, and judges at the end. No clock, no window.
class StepWork {
 public:
  virtual ~StepWork();
  virtual void see(const ScanState& image) { last_ = image; }
  /// How it stands now; empty when there is nothing to say.
  [[nodiscard]] virtual std::vector<LiveFigure> live() const { return {}; }
  /// Fills verdict, score, figures, remarks and answer of an outcome, by what was seen and handed in.
  virtual void judge(const Handed& handed, StepOutcome& outcome) const = 0;
  /// Whether judge() has what it needs; else a sentence about what is missing.
  [[nodiscard]] virtual std::optional<Message> missing(const Handed& handed) const;

 protected:
  [[nodiscard]] const std::optional<ScanState>& last() const { return last_; }

 private:
  std::optional<ScanState> last_;
};

/// @error badField: the case does not have what the step asks for (ew/library/lesson_links.h says so beforehand)
[[nodiscard]] Result<std::unique_ptr<StepWork>> workOf(const LessonStep& step, StepScene scene);

/// A knob by the name that lessons give it (kLessonSettings), as it acts: with its default resolved. Empty: no such setting.
[[nodiscard]] std::optional<double> settingOf(const ScanState& state, const std::string& setting);

}  // namespace ew::lessons
