#include <algorithm>
#include <array>

#include "ew/core/foreign_json.h"
#include "works/step_works.h"

namespace ew {
namespace {

using nlohmann::json;

/// Which figure of a caliper is compared with an expected value of a kind.
std::vector<std::string> figuresFor(const std::string& kind) {
  if (kind == "circumference") return {"circumference"};
  if (kind == "area") return {"area"};
  if (kind == "angle") return {"angle"};
  if (kind == "volume") return {"volume"};
  return {"length", "long_axis"};
}

json pointJson(const glm::dvec3& p_mm) { return {p_mm.x, p_mm.y, p_mm.z}; }

std::optional<glm::dvec3> pointOf(const json& value) {
  if (!value.is_array() || value.size() != 3) return std::nullopt;
  for (const json& each : value)
    if (!each.is_number()) return std::nullopt;
  return glm::dvec3(value[0].get<double>(), value[1].get<double>(), value[2].get<double>());
}

class MeasureWork final : public StepWork {
 public:
  MeasureWork(const ExpectedMeasurement& expected, double tolerance) : expected_(expected), tolerance_(tolerance) {}

  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override {
    if (fitting(handed)) return std::nullopt;
    return say<"Nothing that fits is measured in this image yet; freeze the image and set the calipers.">();
  }
  [[nodiscard]] json answerOf(const Handed& handed) const override {
    const auto found = fitting(handed);
    if (!found || !last()) return nullptr;
    json answer = {{"value", found->value}, {"unit", expected_.unit}, {"caliper", found->kind}};
    for (const auto& point : found->points) answer["points_mm"].push_back(pointJson((last()->pose.probeToWorld * point).at));
    return answer;
  }
  void judge(const json& given, StepOutcome& outcome) const override {
    const json answer = memberOf(given, "measurements").is_array() ? fittingAmong(given["measurements"]) : given;
    const json& value = memberOf(answer, "value");
    if (!value.is_number() || memberOf(answer, "unit") != json(expected_.unit)) return;
    std::vector<glm::dvec3> points_mm;
    for (const json& each : memberOf(answer, "points_mm"))
      if (const auto point = pointOf(each)) points_mm.push_back(*point);
    take(judgeMeasurement(expected_, value.get<double>(), points_mm, tolerance_), outcome);
  }

 private:
  struct Fitting {
    double value = 0.0;
    std::string kind;
    std::vector<Point<frame::Probe>> points;
  };
  /// The same of an examination, which keeps all that was measured: nobody knew there which would fit.
  [[nodiscard]] json fittingAmong(const json& all) const {
    Handed handed;
    for (const json& each : all) {
      HandedMeasurement& made = handed.measurements.emplace_back();
      if (memberOf(each, "caliper").is_string()) made.kind = each["caliper"].get<std::string>();
      for (const json& figure : memberOf(each, "figures"))
        if (memberOf(figure, "name").is_string() && memberOf(figure, "unit").is_string() && memberOf(figure, "value").is_number())
          made.figures.push_back({figure["name"].get<std::string>(), figure["value"].get<double>(), figure["unit"].get<std::string>()});
      for (const json& point : memberOf(each, "points_mm"))
        if (const auto at_mm = pointOf(point)) made.points.push_back(Point<frame::Probe>{*at_mm});  // in the world already
    }
    const auto found = fitting(handed);
    if (!found) return nullptr;
    json answer = {{"value", found->value}, {"unit", expected_.unit}, {"caliper", found->kind}};
    for (const auto& point : found->points) answer["points_mm"].push_back(pointJson(point.at));
    return answer;
  }
  /// The last measurement that has such a figure, in that unit. Points of other calipers than two ends are not compared: they mean
  /// something else in each kind.
  [[nodiscard]] std::optional<Fitting> fitting(const Handed& handed) const {
    const auto names = figuresFor(expected_.kind);
    for (auto one = handed.measurements.rbegin(); one != handed.measurements.rend(); ++one)
      for (const auto& figure : one->figures) {
        if (std::find(names.begin(), names.end(), figure.name) == names.end()) continue;
        const double factor = figure.unit == expected_.unit ? 1.0 : figure.unit == "mm2" && expected_.unit == "cm2" ? 0.01 : 0.0;
        if (factor == 0.0) continue;
        return Fitting{factor * figure.value, one->kind, one->kind == "distance" ? one->points : std::vector<Point<frame::Probe>>{}};
      }
    return std::nullopt;
  }

  ExpectedMeasurement expected_;
  double tolerance_;
};

class PointWork final : public StepWork {
 public:
  explicit PointWork(ExpectedPoint point) : point_(std::move(point)) {}
  explicit PointWork(std::shared_ptr<const OrganVoxels> organ) : organ_(std::move(organ)) {}

  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override {
    if (handed.point && last()) return std::nullopt;
    return say<"Nothing was pointed at yet; freeze the image and click it there.">();
  }
  [[nodiscard]] json answerOf(const Handed& handed) const override {
    if (!handed.point || !last()) return nullptr;
    return {{"at_mm", pointJson((last()->pose.probeToWorld * *handed.point).at)}};
  }
  void judge(const json& answer, StepOutcome& outcome) const override {
    constexpr double kMargin_mm = 3.0;  // as far as a hand misses a border that it sees
    const auto at_mm = pointIn(answer);
    if (at_mm) take(point_ ? judgePointing(*point_, *at_mm) : judgePointing(*organ_, *at_mm, kMargin_mm), outcome);
  }

 private:
  std::optional<ExpectedPoint> point_;
  std::shared_ptr<const OrganVoxels> organ_;
};

}  // namespace

std::optional<glm::dvec3> pointIn(const json& answer) { return pointOf(memberOf(answer, "at_mm")); }

Work measureWork(const ExpectedMeasurement& expected, double tolerance) { return std::make_unique<MeasureWork>(expected, tolerance); }

Work pointWork(const ExpectedPoint& point) { return std::make_unique<PointWork>(point); }

Work pointWork(std::shared_ptr<const OrganVoxels> organ) { return std::make_unique<PointWork>(std::move(organ)); }

}  // namespace ew
