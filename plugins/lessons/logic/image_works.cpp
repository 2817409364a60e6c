#include "logic/step_works.h"

#include <algorithm>

namespace ew::lessons {
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
  MeasureWork(const ExpectedMeasurement& expected, double tolerance) : expected_(expected), tolerance_(tolerance) {}

  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override {
    if (fitting(handed)) return std::nullopt;
    return say<"Nothing that fits is measured in this image yet; freeze the image and set the calipers.">();
  }
  void judge(const Handed& handed, StepOutcome& outcome) const override {
    const auto found = fitting(handed);
    if (!found || !last()) return;
    std::vector<glm::dvec3> points_mm;
    for (const auto& point : found->points) points_mm.push_back((last()->pose.probeToWorld * point).at);
    take(judgeMeasurement(expected_, found->value, points_mm, tolerance_), outcome);
    outcome.answer = {{"value", found->value}, {"unit", expected_.unit}};
  }

 private:
  struct Fitting {
    double value = 0.0;
    std::vector<Point<frame::Probe>> points;
  };
  /// The last measurement that has such a figure, in that unit. Points of other calipers than two ends are not compared: they mean
  /// something else in each kind.
  [[nodiscard]] std::optional<Fitting> fitting(const Handed& handed) const {
    const auto names = figuresFor(expected_.kind);
    for (auto one = handed.measurements.rbegin(); one != handed.measurements.rend(); ++one)
      for (const auto& figure : one->figures) {
        if (std::find(names.begin(), names.end(), figure.name) == names.end()) continue;
        const double factor = figure.unit == expected_.unit ? 1.0 : figure.unit == "mm2" && expected_.unit == "cm2" ? 0.01 : 0.0;
        if (factor == 0.0) continue;
        return Fitting{factor * figure.value, one->kind == "distance" ? one->points : std::vector<Point<frame::Probe>>{}};
      }
    return std::nullopt;
  }

  ExpectedMeasurement expected_;
  double tolerance_;
};

class PointWork final : public StepWork {
 public:
  explicit PointWork(ExpectedPoint point) : point_(std::move(point)) {}
  PointWork(const sdk::Scanned& scanned, int label) : organ_(voxelsOf(scanned, label)) {}

  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override {
    if (handed.point && last()) return std::nullopt;
    return say<"Nothing was pointed at yet; click it in the image.">();
  }
  void judge(const Handed& handed, StepOutcome& outcome) const override {
    if (!handed.point || !last()) return;
    constexpr double kMargin_mm = 3.0;  // as far as a hand misses a border that it sees
    const glm::dvec3 at_mm = (last()->pose.probeToWorld * *handed.point).at;
    take(point_ ? judgePointing(*point_, at_mm) : judgePointing(*organ_, at_mm, kMargin_mm), outcome);
    outcome.answer = {{"at_mm", {at_mm.x, at_mm.y, at_mm.z}}};
  }

 private:
  std::optional<ExpectedPoint> point_;
  std::shared_ptr<const OrganVoxels> organ_;
};

}  // namespace

Work measureWork(const ExpectedMeasurement& expected, double tolerance) { return std::make_unique<MeasureWork>(expected, tolerance); }

Work pointWork(const ExpectedPoint& point) { return std::make_unique<PointWork>(point); }

Work pointWork(const sdk::Scanned& scanned, int label) { return std::make_unique<PointWork>(scanned, label); }

}  // namespace ew::lessons
