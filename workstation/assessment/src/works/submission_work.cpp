#include <variant>

#include "works/step_works.h"

namespace ew {
namespace {

/// A step of an examination: it is seen and kept, and nobody here knows what is right. Answers have the form that judging takes.
class SubmissionWork final : public StepWork {
 public:
  explicit SubmissionWork(LessonTask task) : task_(std::move(task)) {}

  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override {
    if (const auto* answer = std::get_if<AnswerTask>(&task_)) {
      if (answer->options.empty()) return handed.number ? std::nullopt : std::optional(say<"No number was entered yet.">());
      return handed.chosen.empty() ? std::optional(say<"No answer was chosen yet.">()) : std::nullopt;
    }
    if (!last()) return noImage();
    if (std::holds_alternative<PointTask>(task_) && !handed.point) return say<"Nothing was pointed at yet; click it in the image.">();
    if (std::holds_alternative<MeasureTask>(task_) && handed.measurements.empty())
      return say<"Nothing is measured in this image yet; freeze the image and set the calipers.">();
    return std::nullopt;
  }

  [[nodiscard]] StepAnswer answerOf(const Handed& handed) const override {
    if (const auto* answer = std::get_if<AnswerTask>(&task_)) {
      if (!answer->options.empty()) return OptionsAnswer{handed.chosen};
      return handed.number ? NumberAnswer{*handed.number} : StepAnswer();
    }
    if (!last()) return {};
    if (std::holds_alternative<PointTask>(task_))
      return handed.point ? PointAnswer{(last()->pose.probeToWorld * *handed.point).at} : StepAnswer();
    if (!std::holds_alternative<MeasureTask>(task_) || handed.measurements.empty()) return {};
    CalipersAnswer measured;
    for (const MeasurementSubmission& each : handed.measurements) measured.measurements.push_back(inWorld(each, *last()));
    return measured;
  }

  [[nodiscard]] StepResult judge(const StepAnswer&) const override { return {}; }

 private:
  LessonTask task_;
};

}  // namespace

std::unique_ptr<StepWork> handedInWork(const LessonStep& step) {
  if (std::holds_alternative<ReadingTask>(step.task)) return readWork();
  return std::make_unique<SubmissionWork>(step.task);
}

}  // namespace ew
