#include "works/step_works.h"

#include <algorithm>
#include <cmath>

#include "ew/assessment/plane_error.h"
#include "ew/imaging/display.h"

namespace ew {
namespace {

Fan fanOfImage(const ScanState& image) { return {image.probe, resolvedDepth_mm(image.probe, image.knobs)}; }

class PlaneWork final : public StepWork {
 public:
  PlaneWork(const PlaneTask& task, ReferencePlane target, std::shared_ptr<const CaseGround> ground)
      : target_(std::move(target)), ground_(std::move(ground)), tolerance_(toleranceOf(target_)) {
    tolerance_.position_mm = task.positionTolerance_mm.value_or(tolerance_.position_mm);
    tolerance_.angle_deg = task.angleTolerance_deg.value_or(tolerance_.angle_deg);
  }

  [[nodiscard]] std::vector<LiveFigure> live() const override {
    const auto error = errorNow();
    if (!error) return {};
    return {{say<"Angle to the plane %1°">(roundedText(error->angle_deg)), isWithinTolerance(error->angle_deg, 0.0, tolerance_.angle_deg)},
            {say<"Distance from the plane %1 mm">(roundedText(error->distance_mm)),
             isWithinTolerance(error->distance_mm, 0.0, tolerance_.position_mm)}};
  }
  [[nodiscard]] std::optional<Message> missing(const Handed&) const override {
    if (last()) return std::nullopt;
    return noImage();
  }
  [[nodiscard]] StepResult judge(const StepAnswer&) const override {
    return last() ? judgePlane(targetNow(), tolerance_, last()->pose) : StepResult();
  }

 private:
  [[nodiscard]] std::optional<PlaneError> errorNow() const {
    if (!last() || last()->pose.status != PoseStatus::ok) return std::nullopt;
    return planeError(targetNow(), last()->pose.probeToWorld);
  }
  [[nodiscard]] PlaneTarget targetNow() const {
    return targetOf(target_, ground_->truth(), resolvedDepth_mm(last()->probe, last()->knobs));
  }

  ReferencePlane target_;
  std::shared_ptr<const CaseGround> ground_;
  PlaneTolerance tolerance_;
};

class SweepWork final : public StepWork {
 public:
  SweepWork(const SweepTask& task, std::shared_ptr<const OrganVoxels> organ) : task_(task), cover_(std::move(organ)) {}

  void see(const ScanState& image) override {
    StepWork::see(image);
    cover_.add(fanOfImage(image), image.pose, image.gaps_mm);
  }
  [[nodiscard]] std::vector<LiveFigure> live() const override {
    const double share = cover_.share();
    return {{say<"Seen so far: %1 %">(roundedText(100.0 * share)), reachesLevel(share, task_.share)}};
  }
  [[nodiscard]] StepResult judge(const StepAnswer&) const override { return judgeSweep(cover_.share(), task_.share); }

 private:
  SweepTask task_;
  OrganCoverage cover_;
};

class FreeWork final : public StepWork {
 public:
  FreeWork(const FreeTask& task, std::shared_ptr<const CaseGround> ground) : ground_(std::move(ground)), shortest_s_(task.shortest_s) {
    for (const std::string& name : task.targets) {
      Sought one{name, std::nullopt, std::nullopt, std::nullopt};
      for (const ReferencePlane& plane : ground_->truth().planes)
        if (plane.name == name) one.plane = plane;
      for (const ReferenceStructure& structure : ground_->truth().structures) {
        if (structure.name != name) continue;
        isUnambiguous_ = isUnambiguous_ && !one.cover;
        one.cover.emplace(ground_->organ(structure.label));
      }
      sought_.push_back(std::move(one));
    }
  }

  void see(const ScanState& image) override {
    if (!begin_s_) begin_s_ = image.time_s;
    end_s_ = image.time_s;
    for (Sought& one : sought_) {
      if (one.cover) one.cover->add(fanOfImage(image), image.pose, image.gaps_mm);
      if (!one.plane || image.pose.status != PoseStatus::ok) continue;
      const PlaneTarget target = targetOf(*one.plane, ground_->truth(), resolvedDepth_mm(image.probe, image.knobs));
      const PlaneError error = planeError(target, image.pose.probeToWorld);
      const PlaneTolerance tolerance = toleranceOf(*one.plane);
      if (!one.nearest || shareOfTolerance(error, tolerance) < shareOfTolerance(*one.nearest, tolerance)) one.nearest = error;
    }
    StepWork::see(image);
  }
  [[nodiscard]] std::optional<Message> missing(const Handed&) const override {
    const double left_s = shortest_s_ - (begin_s_ ? end_s_ - *begin_s_ : 0.0);
    if (left_s <= 0.0) return std::nullopt;
    return say<"Scan for at least %1 s more.">(roundedText(std::ceil(left_s)));
  }
  [[nodiscard]] StepResult judge(const StepAnswer&) const override {
    StepResult result;
    int found = 0;
    for (const Sought& one : sought_) {
      const bool good = one.isShown();
      found += good ? 1 : 0;
      result.remarks.push_back({good, good ? say<"Shown: %1">(verbatim(one.name)) : one.missed()});
    }
    result.score = sought_.empty() ? 1.0 : static_cast<double>(found) / static_cast<double>(sought_.size());
    return result;
  }
  [[nodiscard]] std::optional<VoxelPass> passedVoxels() const override {
    if (!isUnambiguous_) return std::nullopt;
    VoxelPass voxels;
    for (const Sought& one : sought_) {
      if (!one.cover) continue;
      voxels.passed += one.cover->passed();
      voxels.of += one.cover->of();
    }
    return voxels;
  }

 private:
  struct Sought {
    std::string name;
    std::optional<ReferencePlane> plane;
    std::optional<OrganCoverage> cover;
    std::optional<PlaneError> nearest;  ///< that the probe came to the plane

    static constexpr double kSeen = 0.3;  // of a structure: enough to have looked at it
    [[nodiscard]] bool isShown() const {
      return (plane && nearest && isFound(*nearest, toleranceOf(*plane))) || (cover && reachesLevel(cover->share(), kSeen));
    }
    /// Why it does not count, with the figure that was needed.
    [[nodiscard]] Message missed() const {
      if (cover)
        return say<"Not shown: %1. The images passed through %2 % of it; %3 % are needed.">(
            verbatim(name), roundedText(100.0 * cover->share()), roundedText(100.0 * kSeen));
      if (!plane || !nearest) return say<"Not shown: %1">(verbatim(name));
      const PlaneTolerance tolerance = toleranceOf(*plane);
      if (nearest->angle_deg <= tolerance.angle_deg && nearest->distance_mm <= tolerance.position_mm)
        return say<"Not shown: %1. The plane was right, but the target lay %2 mm elsewhere in the image; %3 mm are allowed.">(
            verbatim(name), roundedText(nearest->inImage_mm), roundedText(kInImageFactor * tolerance.position_mm));
      return say<"Not shown: %1. At best the plane was %2 degrees and %3 mm off; %4 degrees and %5 mm are allowed.">(
          verbatim(name), roundedText(nearest->angle_deg), roundedText(nearest->distance_mm), roundedText(tolerance.angle_deg),
          roundedText(tolerance.position_mm));
    }
  };
  std::shared_ptr<const CaseGround> ground_;
  double shortest_s_;
  std::optional<double> begin_s_;
  double end_s_ = 0.0;
  std::vector<Sought> sought_;
  bool isUnambiguous_ = true;  ///< no two structures have the name of a target
};

}  // namespace

Work planeWork(const PlaneTask& task, const ReferencePlane& target, std::shared_ptr<const CaseGround> ground) {
  return std::make_unique<PlaneWork>(task, target, std::move(ground));
}

Work sweepWork(const SweepTask& task, std::shared_ptr<const OrganVoxels> organ) {
  return std::make_unique<SweepWork>(task, std::move(organ));
}

Work freeWork(const FreeTask& task, std::shared_ptr<const CaseGround> ground) {
  return std::make_unique<FreeWork>(task, std::move(ground));
}

}  // namespace ew
