#include "echo_losses.h"

#include <algorithm>
#include <cmath>

#include "label_blend.h"
#include "line_kernels.h"

namespace ew::detail {
namespace {

constexpr double kStep_mm = 0.7;
constexpr double kBlurPerAperture = 0.27 * 0.29 * 0.29;
constexpr double kFNumber = 2.0;
constexpr double kLongestRelease_mm = 0.8;

}  // namespace

void EchoLosses::configure(const EchoLayout& layout, const Probe& probe, const Scene& scene, double carrier_hz) {
  layout_ = &layout;
  lines_ = static_cast<int>(layout.grid.lines.size());
  steps_ = std::max(2, static_cast<int>(std::ceil(layout.depth_mm / kStep_mm)) + 1);
  step_mm_ = layout.depth_mm / (steps_ - 1);
  const AttenuationEffect effect = scene.attenuation.value_or(AttenuationEffect{});
  most_ = static_cast<float>(std::pow(10.0, effect.largestEnhancement_db / 40.0));
  release_ = static_cast<float>(1.0 - std::exp(-step_mm_ / std::min(2.0 * layout.beams.wavelength_mm, kLongestRelease_mm)));
  perStep_db_.fill(0.0F);
  reflection_db_.fill(0.0F);
  for (const TissueAcoustics& tissue : scene.tissues) {
    if (tissue.label < 0 || tissue.label > 255) continue;
    const auto n = static_cast<std::size_t>(tissue.label);
    perStep_db_[n] =
        static_cast<float>(2.0 * (tissue.attenuation_dbPerCmMhz - effect.expected_dbPerCmMhz) * 1e-6 * carrier_hz * 0.1 * step_mm_);
    reflection_db_[n] = static_cast<float>(tissue.reflection_db);
  }
  aside_.resize(static_cast<std::size_t>(steps_));
  elevation_mm_.resize(static_cast<std::size_t>(steps_));
  for (int s = 0; s < steps_; ++s) {
    const double depth_mm = s * step_mm_, aperture_mm = std::min(probe.aperture_mm, depth_mm / kFNumber);
    const double spacing_mm = std::max(layout.grid.lineSpacing_mm(depth_mm), 1e-3);
    const double variance =
        kBlurPerAperture * aperture_mm * aperture_mm * step_mm_ / std::max(depth_mm, step_mm_) / (spacing_mm * spacing_mm);
    aside_[static_cast<std::size_t>(s)] = static_cast<float>(std::min(0.5 * variance, 1.0 / 3.0));
    elevation_mm_[static_cast<std::size_t>(s)] = static_cast<float>(layout.beams.elevationalSigma_mm(depth_mm));
  }
  const auto samples = static_cast<std::size_t>(lines_) * static_cast<std::size_t>(steps_);
  own_db_.resize(kPlanes * samples);
  reflection_.resize(kPlanes * samples);
  gains_.resize(samples);
  ways_.resize(static_cast<std::size_t>(lines_));
  amplitude_.resize(static_cast<std::size_t>(lines_));
  waiting_.resize(static_cast<std::size_t>(lines_));
  loss_.resize(static_cast<std::size_t>(lines_));
  scratch_.resize(static_cast<std::size_t>(lines_) + 2);
}

void EchoLosses::walk(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, const EchoMotion& motion,
                      Bands& bands) {
  const LabelBlend blend{labels, perStep_db_, reflection_db_};
  const glm::dmat4& m = probeToLabel.matrix;
  for (std::size_t line = 0; line < ways_.size(); ++line) {
    const BeamGrid::Line& way = layout_->grid.lines[line];
    ways_[line] = {glm::vec3(m * glm::dvec4(way.origin_mm, 0.0, 1.0)), glm::vec3(m * glm::dvec4(way.direction, 0.0, 0.0))};
  }
  const glm::vec3 aside(m[2]);
  const auto ahead_mm = static_cast<float>(2.0 * step_mm_);
  if (motion.moves())
    for (std::size_t p = 0; p < kPlanes; ++p) motion.rowsOf(static_cast<double>(kAside[p]), glm::mat3(m), bands, back_[p]);
  bands.run(steps_, [&](int firstStep, int count, int) {
    for (int p = 0; p < kPlanes; ++p)
      for (int s = firstStep; s < firstStep + count; ++s) {
        // Halfway to the step before, where its loss lies.
        const auto depth_mm = static_cast<float>(std::max(s - 0.5, 0.0) * step_mm_);
        const glm::vec3 offset = kAside[static_cast<std::size_t>(p)] * elevation_mm_[static_cast<std::size_t>(s)] * aside;
        float* own = own_db_.data() + indexOf(p, s);
        float* reflection = reflection_.data() + indexOf(p, s);
        const auto ask = [&](auto backOf) {
          for (int line = 0; line < lines_; ++line) {
            const Way& way = ways_[static_cast<std::size_t>(line)];
            glm::vec3 place = way.start + offset + depth_mm * way.perMm;
            backOf(line, place);
            blend.announce(place + ahead_mm * way.perMm);
            blend.at(place, own[line], reflection[line]);
          }
        };
        if (!motion.moves()) {
          ask([](int, glm::vec3&) {});
          continue;
        }
        const std::vector<glm::vec3>& back = back_[static_cast<std::size_t>(p)];
        ask([&](int line, glm::vec3& place) { place += motion.backOn(back, line, depth_mm); });
      }
  });

  std::fill(gains_.begin(), gains_.end(), 0.0F);
  constexpr float kLog2PerDb_oneWay = 3.32192809F / 40.0F;
  for (int p = 0; p < kPlanes; ++p) {
    std::fill(amplitude_.begin(), amplitude_.end(), 1.0F);
    std::fill(waiting_.begin(), waiting_.end(), 0.0F);
    for (int s = 0; s < steps_; ++s) {
      const float* own = own_db_.data() + indexOf(p, s);
      const float* reflection = reflection_.data() + indexOf(p, s);
      const float* before = reflection_.data() + indexOf(p, std::max(s - 1, 0));
      for (int line = 0; line < lines_; ++line) {
        const float waiting = waiting_[static_cast<std::size_t>(line)] + std::max(0.0F, reflection[line] - before[line]);
        const float released = waiting * release_;
        waiting_[static_cast<std::size_t>(line)] = waiting - released;
        loss_[static_cast<std::size_t>(line)] = (own[line] + released) * kLog2PerDb_oneWay;
      }
      marchLosses(loss_.data(), aside_[static_cast<std::size_t>(s)], most_, kWeights[static_cast<std::size_t>(p)], lines_,
                  amplitude_.data(), scratch_.data(), gains_.data() + indexOf(0, s));
    }
  }
}

void EchoLosses::gainsOf(int line, std::vector<float>& ofSteps, std::span<float> gains) const {
  ofSteps.resize(static_cast<std::size_t>(steps_));
  for (int s = 0; s < steps_; ++s) ofSteps[static_cast<std::size_t>(s)] = gains_[indexOf(0, s) + static_cast<std::size_t>(line)];
  const auto last = static_cast<float>(steps_ - 1) - 1e-3F;
  const auto perColumn = static_cast<float>(layout_->grid.sampleSpacing_mm / step_mm_);
  const float first = -static_cast<float>(layout_->columnPadding) * perColumn;
  for (std::size_t column = 0; column < gains.size(); ++column) {
    const float step = std::clamp(first + static_cast<float>(column) * perColumn, 0.0F, last);
    const auto whole = static_cast<int>(step);
    const float here = ofSteps[static_cast<std::size_t>(whole)], next = ofSteps[static_cast<std::size_t>(whole) + 1];
    gains[column] = here + (step - static_cast<float>(whole)) * (next - here);
  }
}

}  // namespace ew::detail
