#include <variant>

#include "works/step_works.h"

namespace ew {
namespace {

using nlohmann::json;

/// A step of an examination: it is seen and kept, and nobody here knows what is right. Answers have the form that judging takes.
class HandedInWork final : public StepWork {
 public:
  explicit HandedInWork(LessonTask task) : task_(std::move(task)) {}

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

  [[nodiscard]] json answerOf(const Handed& handed) const override {
    if (const auto* answer = std::get_if<AnswerTask>(&task_)) {
      if (!answer->options.empty()) return {{"chosen", handed.chosen}};
      return handed.number ? json{{"number", *handed.number}} : json();
    }
    if (!last()) return nullptr;
    const auto inWorld = [this](const Point<frame::Probe>& point) {
      const glm::dvec3 at_mm = (last()->pose.probeToWorld * point).at;
      return json{at_mm.x, at_mm.y, at_mm.z};
    };
    if (std::holds_alternative<PointTask>(task_)) return handed.point ? json{{"at_mm", inWorld(*handed.point)}} : json();
    if (!std::holds_alternative<MeasureTask>(task_)) return nullptr;
    json measured = json::array();
    for (const HandedMeasurement& each : handed.measurements) {
      json one = {{"caliper", each.kind}, {"figures", json::array()}, {"points_mm", json::array()}};
      for (const auto& figure : each.figures)
        one["figures"].push_back({{"name", figure.name}, {"value", figure.value}, {"unit", figure.unit}});
      for (const auto& point : each.points) one["points_mm"].push_back(inWorld(point));
      measured.push_back(std::move(one));
    }
    return measured.empty() ? json() : json{{"measurements", measured}};
  }

  void judge(const json&, StepOutcome&) const override {}

 private:
  LessonTask task_;
};

}  // namespace

std::unique_ptr<StepWork> handedInWork(const LessonStep& step) {
  if (std::holds_alternative<ReadTask>(step.task)) return readWork();
  return std::make_unique<HandedInWork>(step.task);
}

}  // namespace ew
