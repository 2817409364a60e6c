#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/assessment/case_ground.h"
#include "ew/core/figure.h"
#include "ew/library/attempt.h"
#include "ew/library/lesson.h"
#include "ew/library/step_answer.h"
#include "ew/scanning/state.h"

namespace ew {

/// What was measured with calipers in the image that is shown.
struct MeasurementSubmission {
  std::string kind;  ///< of the caliper: "distance", "ellipse" ...
  std::vector<Point<frame::Probe>> points;
  std::vector<Figure> figures;
};

/// What a trainee has handed in when a step ends, beside the scan itself. Only what the step's kind asks for is looked at.
struct Handed {
  std::vector<std::size_t> chosen = {};                  ///< answers, by their place
  std::optional<double> number = {};                     ///< in the step's unit
  std::optional<Point<frame::Probe>> point = {};         ///< that was pointed at, in the image that is shown
  std::vector<MeasurementSubmission> measurements = {};  ///< in the image that is shown; the last one counts
  bool watched = false;                                  ///< the expert's scan to its end
};

/// One figure that is shown while a step runs, and whether it is good enough by now.
struct LiveFigure {
  Message text;
  bool good = false;
};

/// Of the voxels of all structures that a step asks for.
struct VoxelPass {
  std::size_t passed = 0, of = 0;
};

/// The work of one step as it goes on: it sees every image, says how things stand, and judges at the end. No clock, no window. What is
/// handed in becomes an answer, raw data in the world that an attempt keeps: images and answer are all that judging takes, so that it can
/// be done again from the recording.
class StepWork {
 public:
  virtual ~StepWork();
  virtual void see(const ScanState& image) { last_ = image; }
  /// How it stands now; empty when there is nothing to say.
  [[nodiscard]] virtual std::vector<LiveFigure> live() const { return {}; }
  /// Whether a step can be judged with this; else a sentence about what is missing.
  [[nodiscard]] virtual std::optional<Message> missing(const Handed& handed) const;
  /// Of the step's kind; nothing where it asks for nothing, or nothing that fits was handed in.
  [[nodiscard]] virtual StepAnswer answerOf(const Handed& handed) const;
  /// Score, figures and remarks, by what was seen and answered; conclude() gives the verdict. @param answer of another kind: counts as
  /// nothing
  [[nodiscard]] virtual StepResult judge(const StepAnswer& answer) const = 0;
  /// What the images that were seen passed through (OrganCoverage); nothing: it was not looked at.
  [[nodiscard]] virtual std::optional<VoxelPass> passedVoxels() const { return std::nullopt; }

  /// Judges what is handed in now; the outcome keeps result and answer.
  void hand(const Handed& handed, StepOutcome& outcome) const;
  [[nodiscard]] const std::optional<ScanState>& last() const { return last_; }

 private:
  std::optional<ScanState> last_;
};

/// @param ground of the case that the step scans, not null
/// @error badField: the case does not have what the step asks for (ew/library/lesson_links.h says so beforehand)
[[nodiscard]] Result<std::unique_ptr<StepWork>> workOf(const LessonStep& step, std::shared_ptr<const CaseGround> ground);

/// The work of a step of an examination, whose answers are sealed: what is handed in is kept as answer, in a form that the work of the same
/// step can judge once the answers are open (a CalipersAnswer in place of the one measurement that fits). It judges nothing.
[[nodiscard]] std::unique_ptr<StepWork> handedInWork(const LessonStep& step);

/// The verdict of an outcome that was judged: passed from the step's pass level on and within its time; too late is remarked.
/// @param passLevel 0..1
void conclude(const LessonStep& step, double passLevel, StepOutcome& outcome);

/// A knob by the name that lessons give it (kLessonSettings), as it acts: with its default resolved. Empty: no such setting.
[[nodiscard]] std::optional<double> settingOf(const ScanState& state, const std::string& setting);

}  // namespace ew
