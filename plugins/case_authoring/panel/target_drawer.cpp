#include "panel/target_drawer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ew/imaging/display.h"
#include "ew/labelling/outline.h"
#include "logic/painting.h"
#include "logic/targets.h"

namespace ew::case_authoring {
namespace {

constexpr int kCorners = 48;
constexpr double kUsualTolerance_mm = 10.0;  // of a point whose case says none

template <class Frame>
sdk::OverlayLine<Frame> ring(const glm::dvec3& middle, const glm::dvec3& a, const glm::dvec3& b, sdk::OverlayRole role) {
  sdk::OverlayLine<Frame> line;
  for (int n = 0; n < kCorners; ++n) {
    const double at = 2.0 * std::numbers::pi * n / kCorners;
    line.points.push_back({middle + std::cos(at) * a + std::sin(at) * b});
  }
  line.isClosed = true;
  line.role = role;
  return line;
}

sdk::OverlayLine<frame::Probe> scanLine(const std::vector<glm::dvec2>& points, bool isClosed) {
  sdk::OverlayLine<frame::Probe> line;
  for (const glm::dvec2& p : points) line.points.push_back({{p.x, p.y, 0.0}});
  line.isClosed = line.isFilled = isClosed;
  return line;
}

}  // namespace

glm::dvec2 seenSize_mm(const ScanState& image) {
  const double depth_mm = resolvedDepth_mm(image.probe, image.knobs);
  return {isSector(image.probe.kind) ? depth_mm : faceHalfWidth_mm(image.probe), depth_mm};
}

int labelIn(const CaseTarget& target, const std::optional<ScanState>& image) {
  if (target.label) return *target.label;
  if (target.organ.empty() || !image) return 0;
  for (const TissueAcoustics& tissue : image->scene.tissues)
    if (tissue.name == target.organ) return tissue.label;
  return 0;
}

TargetDrawer::TargetDrawer(sdk::Host& host) : host_(host) {}

void TargetDrawer::setShown(bool shown) {
  isShown_ = shown;
  if (!shown) {
    overScan_.reset();
    overBody_.reset();
    inBody_.reset();
    shownOrgan_ = 0;
    return;
  }
  if (!overScan_) overScan_ = host_.overlays().overScan();
  if (!overBody_) overBody_ = host_.overlays().overBody();
  drawBody();
  if (const auto image = host_.scan().state()) see(*image);
}

void TargetDrawer::setTargets(const Case& shown, std::size_t chosen) {
  case_ = shown;
  chosen_ = chosen;
  setShown(isShown_);
}

void TargetDrawer::setPainting(const Painting* painting) { painting_ = painting; }

int TargetDrawer::chosenLabel() const {
  const CaseTarget* target = targetAt(case_, chosen_);
  return target != nullptr && target->kind == CaseTarget::Kind::structure ? labelIn(*target, host_.scan().state()) : 0;
}

std::vector<sdk::OverlayLine<frame::Probe>> TargetDrawer::outlines(const ScanState& image) const {
  const int label = chosenLabel();
  const auto scanned = host_.scan().scanned();
  if (label <= 0 || !scanned) return {};
  const glm::dvec2 size_mm = seenSize_mm(image);
  const labelling::PlaneArea area{-size_mm.x, size_mm.x, 0.0, size_mm.y, 1.0};
  std::vector<std::vector<glm::dvec2>> found;
  if (painting_ != nullptr) {
    const Volume& labels = painting_->labels();
    const auto planeToFile = rigidInverse(case_.volume.fileToWorld) * image.pose.probeToWorld;
    found = labelling::outlinesOf(labels, static_cast<std::uint8_t>(label), labels.grid.toVoxel<frame::File>() * planeToFile, area);
  } else if (scanned->labels) {
    found = labelling::outlinesOf(*scanned->labels, static_cast<std::uint8_t>(label),
                                  scanned->placedLabels.worldToVoxel() * image.pose.probeToWorld, area);
  }
  std::vector<sdk::OverlayLine<frame::Probe>> lines;
  for (const auto& each : found) lines.push_back(scanLine(each, true));
  return lines;
}

void TargetDrawer::see(const ScanState& image) {
  if (!overScan_) return;
  sdk::ScanDrawing drawing;
  const CaseTarget* target = targetAt(case_, chosen_);
  if (target != nullptr && target->at_mm) {
    const glm::dvec3 p = carried(rigidInverse(image.pose.probeToWorld) * case_.volume.fileToWorld, *target->at_mm);
    const double radius_mm = target->tolerance_mm.value_or(kUsualTolerance_mm), within = radius_mm * radius_mm - p.z * p.z;
    if (within > 0.0) {
      const double cut_mm = std::sqrt(within);
      drawing.lines.push_back(ring<frame::Probe>({p.x, p.y, 0.0}, {cut_mm, 0.0, 0.0}, {0.0, cut_mm, 0.0}, sdk::OverlayRole::guide));
      drawing.labels.push_back({{{p.x, p.y, 0.0}}, target->name, sdk::OverlayRole::guide, true});
    }
  }
  for (auto& line : outlines(image)) drawing.lines.push_back(std::move(line));
  if (painting_ != nullptr && painting_->isDrawing() && painting_->stroke().size() > 1) {
    auto traced = scanLine(painting_->stroke(), false);
    traced.role = sdk::OverlayRole::trainee;
    drawing.lines.push_back(std::move(traced));
  }
  overScan_->show(std::move(drawing));
}

void TargetDrawer::drawBody() {
  if (!overBody_) return;
  sdk::BodyDrawing drawing;
  const auto& fileToWorld = case_.volume.fileToWorld;
  for (std::size_t n = 0; n < case_.targets.size(); ++n) {
    const CaseTarget& target = case_.targets[n];
    const auto role = n == chosen_ ? sdk::OverlayRole::guide : sdk::OverlayRole::quiet;
    if (target.at_mm) {
      const glm::dvec3 p = carried(fileToWorld, *target.at_mm);
      if (n == chosen_) {
        const double r = target.tolerance_mm.value_or(kUsualTolerance_mm);
        const glm::dvec3 x(r, 0.0, 0.0), y(0.0, r, 0.0), z(0.0, 0.0, r);
        for (const auto& [a, b] : {std::pair{x, y}, std::pair{y, z}, std::pair{x, z}})
          drawing.lines.push_back(ring<frame::World>(p, a, b, role));
      }
      drawing.labels.push_back({{p}, n == chosen_ ? target.name : std::string(), role, true});
    }
    if (target.probeToFile) {
      const auto image = host_.scan().state();
      const double depth_mm = image ? seenSize_mm(*image).y : 100.0;
      drawing.planes.push_back({fileToWorld * *target.probeToFile, -0.4 * depth_mm, 0.4 * depth_mm, 0.0, depth_mm, role});
    }
  }
  overBody_->show(std::move(drawing));
  showOrgan();
}

void TargetDrawer::showOrgan() {
  const int label = chosenLabel();
  if (label == shownOrgan_) return;
  shownOrgan_ = label;
  inBody_.reset();
  if (label > 0) inBody_ = host_.overlays().showInBody({.translucentSkin = true, .organs = {label}, .volumeBox = true});
}

}  // namespace ew::case_authoring
