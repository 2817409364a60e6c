#include "logic/step_work.h"

#include <algorithm>
#include <cmath>

#include "ew/assessment/judging.h"
#include "ew/assessment/organ_coverage.h"
#include "ew/assessment/plane_error.h"
#include "ew/core/numbers.h"
#include "ew/imaging/display.h"

namespace ew::lessons {

std::optional<double> settingOf(const ScanState& state, const std::string& setting) {
  if (setting == "depth_mm") return resolvedDepth_mm(state.probe, state.knobs);
  if (setting == "gain_db") return state.knobs.gain_db;
  if (setting == "dynamic_range_db")
    return state.knobs.dynamicRange_db > 0.0 ? state.knobs.dynamicRange_db : state.scene.recordedDynamicRange_db;
  if (setting == "focus_mm") return state.knobs.focus_mm > 0.0 ? state.knobs.focus_mm : 0.5 * resolvedDepth_mm(state.probe, state.knobs);
  return std::nullopt;
}

StepWork::~StepWork() = default;
std::optional<Message> StepWork::missing(const Handed&) const { return std::nullopt; }

namespace {

std::string rounded(double value, int decimals = 0) {
  return textOf(std::round(value * std::pow(10.0, decimals)) / std::pow(10.0, decimals));
}

/// What stands in an outcome of a judgement.
void take(Judgement judgement, StepOutcome& outcome) {
  outcome.score = judgement.score;
  outcome.figures = std::move(judgement.figures);
  outcome.remarks = std::move(judgement.remarks);
}

Fan fanOf(const ScanState& image) { return {image.probe, resolvedDepth_mm(image.probe, image.knobs)}; }

/// The voxels of a structure where they lie in the world.
std::shared_ptr<const OrganVoxels> voxelsOf(const sdk::Scanned& scanned, int label) {
  if (!scanned.labels) return std::make_shared<const OrganVoxels>();
  Volume placed = *scanned.labels;
  placed.grid = scanned.placedLabels;
  return std::make_shared<const OrganVoxels>(placed, label);
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
    if (last()) take(judgePlane(targetNow(), tolerance_, last()->pose), outcome);
  }

 private:
  [[nodiscard]] std::optional<PlaneError> errorNow() const {
    if (!last() || last()->pose.status != PoseStatus::ok) return std::nullopt;
    return planeError(targetNow(), last()->pose.probeToWorld);
  }
  [[nodiscard]] PlaneTarget targetNow() const { return targetOf(target_, *truth_, resolvedDepth_mm(last()->probe, last()->knobs)); }

  ExpectedPlane target_;
  std::shared_ptr<const CaseTruth> truth_;
  PlaneTolerance tolerance_;
};

class SweepWork final : public StepWork {
 public:
  SweepWork(const SweepTask& task, const sdk::Scanned& scanned, int label) : task_(task), cover_(voxelsOf(scanned, label)) {}

  void see(const ScanState& image) override {
    StepWork::see(image);
    cover_.add(fanOf(image), image.pose, image.gaps_mm);
  }
  [[nodiscard]] std::vector<LiveFigure> live() const override {
    const double share = cover_.share();
    return {{say<"Seen so far: %1 %">(rounded(100.0 * share)), share >= task_.share}};
  }
  void judge(const Handed&, StepOutcome& outcome) const override { take(judgeSweep(cover_.share(), task_.share), outcome); }

 private:
  SweepTask task_;
  OrganCoverage cover_;
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
        if (structure.name == name) one.cover.emplace(voxelsOf(scene.scanned, structure.label));
      sought_.push_back(std::move(one));
    }
  }

  void see(const ScanState& image) override {
    if (!begin_s_) begin_s_ = image.time_s;
    end_s_ = image.time_s;
    for (Sought& one : sought_) {
      if (one.cover) one.cover->add(fanOf(image), image.pose, image.gaps_mm);
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
    std::optional<OrganCoverage> cover;
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
    if (const ExpectedPoint* point = named(scene.truth->points, task.target)) return std::make_unique<PointWork>(*point);
    const ExpectedStructure* structure = named(scene.truth->structures, task.target);
    if (structure == nullptr || !scene.scanned.labels) return notThere(task.target);
    return std::make_unique<PointWork>(scene.scanned, structure->label);
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
