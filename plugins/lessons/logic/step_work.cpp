#include "logic/step_work.h"

#include <algorithm>
#include <cmath>

#include "ew/assessment/plane_error.h"
#include "ew/core/numbers.h"
#include "ew/imaging/display.h"
#include "logic/sweep_cover.h"

namespace ew::lessons {

double scoreOf(double errors) {
  constexpr double kAtTolerance = 0.7, kNothing = 3.0;
  if (!(errors < kNothing)) return 0.0;
  if (errors <= 1.0) return 1.0 - (1.0 - kAtTolerance) * std::max(0.0, errors);
  return kAtTolerance * (kNothing - errors) / (kNothing - 1.0);
}

std::optional<double> settingOf(const ScanState& state, const std::string& setting) {
  if (setting == "depth_mm") return resolvedDepth_mm(state.probe, state.knobs);
  if (setting == "gain_db") return state.knobs.gain_db;
  if (setting == "dynamic_range_db")
    return state.knobs.dynamicRange_db > 0.0 ? state.knobs.dynamicRange_db : state.scene.recordedDynamicRange_db;
  if (setting == "focus_mm") return state.knobs.focus_mm > 0.0 ? state.knobs.focus_mm : 0.5 * resolvedDepth_mm(state.probe, state.knobs);
  return std::nullopt;
}

int labelAt(const sdk::Scanned& scanned, const glm::dvec3& at_mm) {
  if (!scanned.labels) return 0;
  const glm::ivec3 dims = scanned.placedLabels.dims;
  const glm::dvec3 voxel = (inverse(scanned.placedLabels.voxelToWorld()) * Point<frame::World>{at_mm}).at;
  const glm::ivec3 nearest(glm::round(voxel));
  for (int axis = 0; axis < 3; ++axis)
    if (nearest[axis] < 0 || nearest[axis] >= dims[axis]) return 0;
  const auto at = (static_cast<std::size_t>(nearest.z) * static_cast<std::size_t>(dims.y) + static_cast<std::size_t>(nearest.y)) *
                      static_cast<std::size_t>(dims.x) +
                  static_cast<std::size_t>(nearest.x);
  return scanned.labels->echo[at];
}

std::optional<double> distanceToLabel_mm(const sdk::Scanned& scanned, const glm::dvec3& at_mm, int label, double reach_mm) {
  if (!scanned.labels) return std::nullopt;
  std::optional<double> nearest;
  const double step_mm = std::max(
      0.25, 0.5 * std::min({scanned.placedLabels.spacing_mm.x, scanned.placedLabels.spacing_mm.y, scanned.placedLabels.spacing_mm.z}));
  const int steps = static_cast<int>(std::ceil(reach_mm / step_mm));
  for (int k = -steps; k <= steps; ++k)
    for (int j = -steps; j <= steps; ++j)
      for (int i = -steps; i <= steps; ++i) {
        const glm::dvec3 off_mm = step_mm * glm::dvec3(i, j, k);
        const double length_mm = glm::length(off_mm);
        if (length_mm > reach_mm || (nearest && length_mm >= *nearest)) continue;
        if (labelAt(scanned, at_mm + off_mm) == label) nearest = length_mm;
      }
  return nearest;
}

StepWork::~StepWork() = default;
std::optional<Message> StepWork::missing(const Handed&) const { return std::nullopt; }

namespace {

std::string rounded(double value, int decimals = 0) {
  return textOf(std::round(value * std::pow(10.0, decimals)) / std::pow(10.0, decimals));
}

Message noImage() { return say<"There is no image yet; put the probe on the body.">(); }

class ReadWork final : public StepWork {
 public:
  void judge(const Handed&, StepOutcome& outcome) const override { outcome.score = 1.0; }
};

class WatchWork final : public StepWork {
 public:
  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override {
    if (handed.watched) return std::nullopt;
    return say<"The expert's scan has not been shown to its end yet.">();
  }
  void judge(const Handed& handed, StepOutcome& outcome) const override { outcome.score = handed.watched ? 1.0 : 0.0; }
};

class PlaneWork final : public StepWork {
 public:
  PlaneWork(const PlaneTask& task, ExpectedPlane target, std::shared_ptr<const CaseTruth> truth)
      : target_(std::move(target)), truth_(std::move(truth)), tolerance_(toleranceOf(target_)) {
    tolerance_.position_mm = task.positionTolerance_mm.value_or(tolerance_.position_mm);
    tolerance_.angle_deg = task.angleTolerance_deg.value_or(tolerance_.angle_deg);
  }

  [[nodiscard]] std::vector<LiveFigure> live() const override {
    const auto error = errorNow();
    if (!error) return {};
    return {{say<"Angle to the plane %1°">(rounded(error->angle_deg)), error->angle_deg <= tolerance_.angle_deg},
            {say<"Distance from the plane %1 mm">(rounded(error->distance_mm)), error->distance_mm <= tolerance_.position_mm}};
  }
  [[nodiscard]] std::optional<Message> missing(const Handed&) const override {
    if (last()) return std::nullopt;
    return noImage();
  }
  void judge(const Handed&, StepOutcome& outcome) const override {
    const auto error = errorNow();
    if (!error) return;
    outcome.figures = {
        {"angle", error->angle_deg, "deg"}, {"distance", error->distance_mm, "mm"}, {"in_picture", error->inPicture_mm, "mm"}};
    outcome.score = scoreOf(shareOfTolerance(*error, tolerance_));
    const auto remark = [&](bool good, Message text) { outcome.remarks.push_back({good, std::move(text)}); };
    if (error->angle_deg <= tolerance_.angle_deg)
      remark(true, say<"The direction of the plane is right (%1° off).">(rounded(error->angle_deg)));
    else
      remark(false, say<"The plane is tilted or rotated by %1° against the one asked for; at most %2° are allowed.">(
                        rounded(error->angle_deg), rounded(tolerance_.angle_deg)));
    if (error->distance_mm <= tolerance_.position_mm)
      remark(true, say<"The plane passes through the right place (%1 mm off).">(rounded(error->distance_mm)));
    else
      remark(false, say<"The plane passes %1 mm beside what it should show; at most %2 mm are allowed.">(rounded(error->distance_mm),
                                                                                                         rounded(tolerance_.position_mm)));
    if (error->inPicture_mm > kInPictureFactor * tolerance_.position_mm)
      remark(false, say<"What it should show lies %1 mm from where it belongs in the image.">(rounded(error->inPicture_mm)));
    if (error->isMirrored) remark(false, say<"The marker points the other way: left and right are exchanged in the image.">());
  }

 private:
  [[nodiscard]] std::optional<PlaneError> errorNow() const {
    if (!last() || last()->pose.status != PoseStatus::ok) return std::nullopt;
    return planeError(targetOf(target_, *truth_, resolvedDepth_mm(last()->probe, last()->knobs)), last()->pose.probeToWorld);
  }

  ExpectedPlane target_;
  std::shared_ptr<const CaseTruth> truth_;
  PlaneTolerance tolerance_;
};

class SweepWork final : public StepWork {
 public:
  SweepWork(const SweepTask& task, const sdk::Scanned& scanned, int label) : task_(task), cover_(scanned, label) {}

  void see(const ScanState& image) override {
    StepWork::see(image);
    cover_.add(image);
  }
  [[nodiscard]] std::vector<LiveFigure> live() const override {
    const double share = cover_.share();
    return {{say<"Seen so far: %1 %">(rounded(100.0 * share)), share >= task_.share}};
  }
  void judge(const Handed&, StepOutcome& outcome) const override {
    const double share = cover_.share();
    outcome.figures = {{"share", 100.0 * share, "%"}};
    outcome.score = share >= task_.share ? 0.7 + 0.3 * (task_.share < 1.0 ? (share - task_.share) / (1.0 - task_.share) : 1.0)
                                         : 0.7 * share / task_.share;
    const bool good = share >= task_.share;
    outcome.remarks.push_back(
        {good, good ? say<"Images passed through %1 % of it.">(rounded(100.0 * share))
                    : say<"Images passed through %1 % of it; %2 % are asked for. Sweep on until it is gone at both ends.">(
                          rounded(100.0 * share), rounded(100.0 * task_.share))});
  }

 private:
  SweepTask task_;
  SweepCover cover_;
};

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
    if (figureOf(handed)) return std::nullopt;
    return say<"Nothing that fits is measured in this image yet; freeze the image and set the calipers.">();
  }
  void judge(const Handed& handed, StepOutcome& outcome) const override {
    const auto value = figureOf(handed);
    if (!value) return;
    const double error = *value - expected_.value;
    outcome.figures = {{"value", *value, expected_.unit}, {"error", error, expected_.unit}};
    outcome.answer = {{"value", *value}, {"unit", expected_.unit}};
    outcome.score = scoreOf(std::abs(error) / tolerance_);
    if (std::abs(error) <= tolerance_)
      outcome.remarks.push_back(
          {true, say<"%1 %2 were measured; it is %3 %2.">(rounded(*value, 1), expected_.unit, rounded(expected_.value, 1))});
    else
      outcome.remarks.push_back({false, say<"%1 %2 were measured, and it is %3 %2; at most %4 %2 more or less are allowed.">(
                                            rounded(*value, 1), expected_.unit, rounded(expected_.value, 1), rounded(tolerance_, 1))});
  }

 private:
  /// Of the last measurement that has such a figure in that unit.
  [[nodiscard]] std::optional<double> figureOf(const Handed& handed) const {
    const auto names = figuresFor(expected_.kind);
    for (auto one = handed.measurements.rbegin(); one != handed.measurements.rend(); ++one)
      for (const auto& figure : one->figures)
        if (std::find(names.begin(), names.end(), figure.name) != names.end()) {
          if (figure.unit == expected_.unit) return figure.value;
          if (figure.unit == "mm2" && expected_.unit == "cm2") return figure.value / 100.0;
          if (figure.unit == "cm" && expected_.unit == "mm") return figure.value * 10.0;
        }
    return std::nullopt;
  }

  ExpectedMeasurement expected_;
  double tolerance_;
};

class PointWork final : public StepWork {
 public:
  PointWork(StepScene scene, std::optional<ExpectedPoint> point, int label)
      : scene_(std::move(scene)), point_(std::move(point)), label_(label) {}

  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override {
    if (handed.point && last()) return std::nullopt;
    return say<"Nothing was pointed at yet; click it in the image.">();
  }
  void judge(const Handed& handed, StepOutcome& outcome) const override {
    if (!handed.point || !last()) return;
    const glm::dvec3 at_mm = (last()->pose.probeToWorld * *handed.point).at;
    outcome.answer = {{"at_mm", {at_mm.x, at_mm.y, at_mm.z}}};
    constexpr double kNear_mm = 3.0;  // as far as a hand misses a border that it sees
    constexpr double kReach_mm = 15.0;
    const double tolerance_mm = point_ ? point_->tolerance_mm : kNear_mm;
    const auto off_mm =
        point_ ? std::optional(glm::distance(at_mm, point_->at_mm)) : distanceToLabel_mm(scene_.scanned, at_mm, label_, kReach_mm);
    if (off_mm) outcome.figures = {{"distance", *off_mm, "mm"}};
    outcome.score = off_mm ? scoreOf(*off_mm / tolerance_mm) : 0.0;
    if (off_mm && *off_mm <= tolerance_mm)
      outcome.remarks.push_back({true, say<"That is it.">()});
    else if (off_mm)
      outcome.remarks.push_back({false, say<"That is %1 mm beside it.">(rounded(*off_mm))});
    else
      outcome.remarks.push_back({false, say<"That is something else.">()});
  }

 private:
  StepScene scene_;
  std::optional<ExpectedPoint> point_;
  int label_;
};

class SettingsWork final : public StepWork {
 public:
  explicit SettingsWork(SettingsTask task) : task_(std::move(task)) {}

  [[nodiscard]] std::vector<LiveFigure> live() const override {
    std::vector<LiveFigure> figures;
    if (!last()) return figures;
    if (!task_.probes.empty()) figures.push_back({say<"Transducer">(), hasProbe()});
    for (const SettingBand& band : task_.bands) figures.push_back({nameOf(band.setting), isWithin(band)});
    return figures;
  }
  [[nodiscard]] std::optional<Message> missing(const Handed&) const override {
    if (last()) return std::nullopt;
    return noImage();
  }
  void judge(const Handed&, StepOutcome& outcome) const override {
    if (!last()) return;
    int right = 0, all = 0;
    const auto count = [&](bool good, Message goodText, Message badText) {
      ++all;
      right += good ? 1 : 0;
      outcome.remarks.push_back({good, good ? std::move(goodText) : std::move(badText)});
    };
    if (!task_.probes.empty())
      count(hasProbe(), say<"The transducer suits the examination.">(), say<"Another transducer suits this examination better.">());
    for (const SettingBand& band : task_.bands) {
      const double value = settingOf(*last(), band.setting).value_or(0.0);
      outcome.figures.push_back({band.setting, value, band.setting.ends_with("_mm") ? "mm" : "dB"});
      count(isWithin(band), say<"%1 is right.">(nameOf(band.setting)),
            value < band.lowest ? say<"%1 is too low.">(nameOf(band.setting)) : say<"%1 is too high.">(nameOf(band.setting)));
    }
    outcome.score = all > 0 ? static_cast<double>(right) / all : 1.0;
  }

 private:
  static Message nameOf(const std::string& setting) {
    if (setting == "depth_mm") return say<"Depth">();
    if (setting == "gain_db") return say<"Gain">();
    if (setting == "dynamic_range_db") return say<"Dynamic range">();
    return say<"Focus">();
  }
  [[nodiscard]] bool hasProbe() const {
    return std::find(task_.probes.begin(), task_.probes.end(), last()->probe.id) != task_.probes.end();
  }
  [[nodiscard]] bool isWithin(const SettingBand& band) const {
    const auto value = settingOf(*last(), band.setting);
    return value && *value >= band.lowest && *value <= band.highest;
  }
  SettingsTask task_;
};

class AnswerWork final : public StepWork {
 public:
  explicit AnswerWork(AnswerTask task) : task_(std::move(task)) {}

  [[nodiscard]] std::optional<Message> missing(const Handed& handed) const override {
    if (task_.options.empty() ? handed.number.has_value() : !handed.chosen.empty()) return std::nullopt;
    return task_.options.empty() ? say<"No number was entered yet.">() : say<"No answer was chosen yet.">();
  }
  void judge(const Handed& handed, StepOutcome& outcome) const override {
    if (task_.options.empty()) return judgeNumber(handed, outcome);
    // Every right answer counts, and every wrong one takes one away: choosing all earns nothing.
    int right = 0, wrong = 0, all = 0;
    for (std::size_t n = 0; n < task_.options.size(); ++n) {
      const AnswerOption& option = task_.options[n];
      const bool chosen = std::find(handed.chosen.begin(), handed.chosen.end(), n) != handed.chosen.end();
      all += option.right ? 1 : 0;
      right += option.right && chosen ? 1 : 0;
      wrong += !option.right && chosen ? 1 : 0;
      if (chosen && !option.why.empty()) outcome.remarks.push_back({option.right, verbatim(option.why)});
      if (!chosen && option.right) outcome.remarks.push_back({false, say<"Right would have been: %1">(verbatim(option.text))});
    }
    outcome.answer = {{"chosen", handed.chosen}};
    outcome.score = all > 0 ? std::max(0.0, static_cast<double>(right - wrong) / all) : 0.0;
  }

 private:
  void judgeNumber(const Handed& handed, StepOutcome& outcome) const {
    if (!handed.number || !task_.number) return;
    const double error = *handed.number - *task_.number;
    outcome.answer = {{"number", *handed.number}};
    outcome.figures = {{"error", error, task_.unit}};
    const bool good = std::abs(error) <= task_.tolerance;
    outcome.score = good ? 1.0 : 0.0;
    outcome.remarks.push_back({good, good ? say<"That is right.">() : say<"It is %1 %2.">(rounded(*task_.number, 2), task_.unit)});
  }
  AnswerTask task_;
};

class FreeWork final : public StepWork {
 public:
  FreeWork(const FreeTask& task, const StepScene& scene) : truth_(scene.truth), shortest_s_(task.shortest_s) {
    for (const std::string& name : task.targets) {
      Sought one{name, std::nullopt, std::nullopt, 3.0};
      for (const ExpectedPlane& plane : scene.truth->planes)
        if (plane.name == name) one.plane = plane;
      for (const ExpectedStructure& structure : scene.truth->structures)
        if (structure.name == name) one.cover.emplace(scene.scanned, structure.label);
      sought_.push_back(std::move(one));
    }
  }

  void see(const ScanState& image) override {
    if (!begin_s_) begin_s_ = image.time_s;
    end_s_ = image.time_s;
    for (Sought& one : sought_) {
      if (one.cover) one.cover->add(image);
      if (!one.plane || image.pose.status != PoseStatus::ok) continue;
      const PlaneTarget target = targetOf(*one.plane, *truth_, resolvedDepth_mm(image.probe, image.knobs));
      one.leastErrors = std::min(one.leastErrors, shareOfTolerance(planeError(target, image.pose.probeToWorld), toleranceOf(*one.plane)));
    }
    StepWork::see(image);
  }
  [[nodiscard]] std::optional<Message> missing(const Handed&) const override {
    const double left_s = shortest_s_ - (begin_s_ ? end_s_ - *begin_s_ : 0.0);
    if (left_s <= 0.0) return std::nullopt;
    return say<"Scan for at least %1 s more.">(rounded(std::ceil(left_s)));
  }
  void judge(const Handed&, StepOutcome& outcome) const override {
    constexpr double kSeen = 0.3;  // of a structure: enough to have looked at it
    int found = 0;
    for (const Sought& one : sought_) {
      const bool good = (one.plane && one.leastErrors <= 1.0) || (one.cover && one.cover->share() >= kSeen);
      found += good ? 1 : 0;
      outcome.remarks.push_back({good, good ? say<"Shown: %1">(verbatim(one.name)) : say<"Not shown: %1">(verbatim(one.name))});
    }
    outcome.score = sought_.empty() ? 1.0 : static_cast<double>(found) / static_cast<double>(sought_.size());
  }

 private:
  struct Sought {
    std::string name;
    std::optional<ExpectedPlane> plane;
    std::optional<SweepCover> cover;
    double leastErrors;
  };
  std::shared_ptr<const CaseTruth> truth_;
  double shortest_s_;
  std::optional<double> begin_s_;
  double end_s_ = 0.0;
  std::vector<Sought> sought_;
};

template <class All>
const typename All::value_type* named(const All& all, const std::string& name) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const auto& one) { return one.name == name; });
  return at == all.end() ? nullptr : &*at;
}

Result<std::unique_ptr<StepWork>> notThere(const std::string& name) {
  return failure(ErrorCode::badField, say<"The case has no '%1'; the lesson asks for something that is not there. Tell its author.">(name));
}

struct MakeWork {
  const LessonStep& step;
  StepScene scene;
  using Made = Result<std::unique_ptr<StepWork>>;

  Made operator()(const ReadTask&) const { return std::make_unique<ReadWork>(); }
  Made operator()(const WatchTask&) const { return std::make_unique<WatchWork>(); }
  Made operator()(const PlaneTask& task) const {
    const ExpectedPlane* plane = named(scene.truth->planes, task.target);
    if (plane == nullptr) return notThere(task.target);
    return std::make_unique<PlaneWork>(task, *plane, scene.truth);
  }
  Made operator()(const SweepTask& task) const {
    const ExpectedStructure* structure = named(scene.truth->structures, task.target);
    if (structure == nullptr || !scene.scanned.labels) return notThere(task.target);
    return std::make_unique<SweepWork>(task, scene.scanned, structure->label);
  }
  Made operator()(const MeasureTask& task) const {
    const ExpectedMeasurement* expected = named(scene.truth->measurements, task.measurement);
    if (expected == nullptr) return notThere(task.measurement);
    const auto tolerance = task.tolerance ? task.tolerance : expected->tolerance;
    if (!tolerance) return notThere(task.measurement);
    return std::make_unique<MeasureWork>(*expected, *tolerance);
  }
  Made operator()(const PointTask& task) const {
    if (const ExpectedPoint* point = named(scene.truth->points, task.target)) return std::make_unique<PointWork>(scene, *point, 0);
    const ExpectedStructure* structure = named(scene.truth->structures, task.target);
    if (structure == nullptr || !scene.scanned.labels) return notThere(task.target);
    return std::make_unique<PointWork>(scene, std::nullopt, structure->label);
  }
  Made operator()(const SettingsTask& task) const { return std::make_unique<SettingsWork>(task); }
  Made operator()(const AnswerTask& task) const { return std::make_unique<AnswerWork>(task); }
  Made operator()(const FreeTask& task) const { return std::make_unique<FreeWork>(task, scene); }
};

}  // namespace

Result<std::unique_ptr<StepWork>> workOf(const LessonStep& step, StepScene scene) {
  return std::visit(MakeWork{step, std::move(scene)}, step.task);
}

}  // namespace ew::lessons
