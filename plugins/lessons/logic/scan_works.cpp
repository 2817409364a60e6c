#include "logic/step_works.h"

#include <algorithm>
#include <cmath>

#include "ew/assessment/plane_error.h"
#include "ew/imaging/display.h"

namespace ew::lessons {
namespace {

Fan fanOf(const ScanState& image) { return {image.probe, resolvedDepth_mm(image.probe, image.knobs)}; }

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

}  // namespace

Work planeWork(const PlaneTask& task, const ExpectedPlane& target, std::shared_ptr<const CaseTruth> truth) {
  return std::make_unique<PlaneWork>(task, target, std::move(truth));
}

Work sweepWork(const SweepTask& task, const sdk::Scanned& scanned, int label) { return std::make_unique<SweepWork>(task, scanned, label); }

Work freeWork(const FreeTask& task, const StepScene& scene) { return std::make_unique<FreeWork>(task, scene); }

}  // namespace ew::lessons
