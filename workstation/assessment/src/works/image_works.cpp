#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/figure.h"
#include "works/step_works.h"

namespace ew {
namespace {

/// Which figure of a caliper is compared with an expected value of a kind.
std::vector<std::string> figuresFor(const std::string& kind) {
  if (kind == "circumference") return {"circumference"};
  if (kind == "area") return {"area"};
  if (kind == "angle") return {"angle"};
  if (kind == "volume") return {"volume"};
  return {"length", "long_axis"};
}

class MeasureWork final : public StepWork {
 public:
  MeasureWork(const ReferenceMeasurement& expected, double tolerance) : expected_(expected), tolerance_(tolerance) {}

  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override {
    if (fittingIn(handed.measurements) != nullptr) return std::nullopt;
    return say<"Nothing that fits is measured in this image yet; freeze the image and set the calipers.">();
  }
  [[nodiscard]] StepAnswer answerOf(const Handed& handed) const override {
    const MeasurementSubmission* found = fittingIn(handed.measurements);
    return found != nullptr && last() ? answerBy(inWorld(*found, *last())) : StepAnswer();
  }
  [[nodiscard]] StepResult judge(const StepAnswer& given) const override {
    const auto answer = measurementIn(given);
    if (!answer || answer->unit != expected_.unit) return {};
    return judgeMeasurement(expected_, answer->value, answer->points_mm, tolerance_);
  }

 private:
  [[nodiscard]] std::optional<MeasurementAnswer> measurementIn(const StepAnswer& given) const {
    if (const auto* answer = std::get_if<MeasurementAnswer>(&given)) return *answer;
    // Of an examination, which keeps all that was measured: nobody knew there which would fit.
    const auto* calipers = std::get_if<CalipersAnswer>(&given);
    const CaliperReading* found = calipers != nullptr ? fittingIn(calipers->measurements) : nullptr;
    return found != nullptr ? std::optional(answerBy(*found)) : std::nullopt;
  }
  /// Points of other calipers than two ends are not compared: they mean something else in each kind. @param reading that fits
  [[nodiscard]] MeasurementAnswer answerBy(const CaliperReading& reading) const {
    MeasurementAnswer answer{*valueIn(reading.figures), expected_.unit, reading.caliper, {}};
    if (reading.caliper == "distance") answer.points_mm = reading.points_mm;
    return answer;
  }
  /// The last measurement that has such a figure, in that unit; null: none has.
  template <class Measurement>
  [[nodiscard]] const Measurement* fittingIn(const std::vector<Measurement>& all) const {
    const auto found = std::find_if(all.rbegin(), all.rend(), [this](const Measurement& one) { return valueIn(one.figures).has_value(); });
    return found == all.rend() ? nullptr : &*found;
  }
  /// Of the first figure that is compared, in the unit of what is expected.
  [[nodiscard]] std::optional<double> valueIn(const std::vector<Figure>& figures) const {
    const auto names = figuresFor(expected_.kind);
    for (const Figure& figure : figures) {
      if (std::find(names.begin(), names.end(), figure.name) == names.end()) continue;
      if (figure.unit == expected_.unit) return figure.value;
      if (figure.unit == "mm2" && expected_.unit == "cm2") return 0.01 * figure.value;
    }
    return std::nullopt;
  }

  ReferenceMeasurement expected_;
  double tolerance_;
};

class PointWork final : public StepWork {
 public:
  explicit PointWork(ReferencePoint point) : point_(std::move(point)) {}
  explicit PointWork(std::shared_ptr<const OrganVoxels> organ) : organ_(std::move(organ)) {}

  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override {
    if (handed.point && last()) return std::nullopt;
    return say<"Nothing was pointed at yet; freeze the image and click it there.">();
  }
  [[nodiscard]] StepAnswer answerOf(const Handed& handed) const override {
    if (!handed.point || !last()) return {};
    return PointAnswer{(last()->pose.probeToWorld * *handed.point).at};
  }
  [[nodiscard]] StepResult judge(const StepAnswer& given) const override {
    constexpr double kMargin_mm = 3.0;  // as far as a hand misses a border that it sees
    const auto* answer = std::get_if<PointAnswer>(&given);
    if (answer == nullptr) return {};
    return point_ ? judgePointing(*point_, answer->at_mm) : judgePointing(*organ_, answer->at_mm, kMargin_mm);
  }

 private:
  std::optional<ReferencePoint> point_;
  std::shared_ptr<const OrganVoxels> organ_;
};

}  // namespace

Work measureWork(const ReferenceMeasurement& expected, double tolerance) { return std::make_unique<MeasureWork>(expected, tolerance); }

Work pointWork(const ReferencePoint& point) { return std::make_unique<PointWork>(point); }

Work pointWork(std::shared_ptr<const OrganVoxels> organ) { return std::make_unique<PointWork>(std::move(organ)); }

}  // namespace ew
