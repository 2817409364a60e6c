#include "echo_losses.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace ew::detail {
namespace {

constexpr double kStep_mm = 0.7, kFastStep_mm = 1.0;
constexpr double kLongestRelease_mm = 0.8;
constexpr float kSameThing_mm = 3.0F;
constexpr float kMostGel_mm = 4.0F;  // beyond it there is air, which takes away the contact
constexpr float kSkinStep_mm = 0.2F;

}  // namespace

void EchoLosses::configure(const EchoLayout& layout, const Probe& probe, const Scene& scene, double carrier_hz) {
  layout_ = &layout;
  planes_ = layout.planes;
  lines_ = static_cast<int>(layout.grid.lines.size());
  steps_ = std::max(2, static_cast<int>(std::ceil(layout.depth_mm / (planes_ == 1 ? kFastStep_mm : kStep_mm))) + 1);
  step_mm_ = layout.depth_mm / (steps_ - 1);
  const AttenuationEffect effect = scene.attenuation.value_or(AttenuationEffect{});
  most_ = static_cast<float>(std::pow(10.0, effect.largestEnhancement_db / 40.0));
  release_ = static_cast<float>(1.0 - std::exp(-step_mm_ / std::min(2.0 * layout.beams.wavelength_mm, kLongestRelease_mm)));
  const auto perStep_db = [&](double attenuation_dbPerCmMhz) {
    return static_cast<float>(2.0 * (attenuation_dbPerCmMhz - effect.expected_dbPerCmMhz) * 1e-6 * carrier_hz * 0.1 * step_mm_);
  };
  gelPerStep_db_ = perStep_db(0.0);
  perStep_db_.fill(0.0F);
  reflection_db_.fill(0.0F);
  for (const TissueAcoustics& tissue : scene.tissues) {
    if (tissue.label < 0 || tissue.label > 255) continue;
    const auto n = static_cast<std::size_t>(tissue.label);
    perStep_db_[n] = perStep_db(tissue.attenuation_dbPerCmMhz);
    reflection_db_[n] = static_cast<float>(tissue.reflection_db);
  }
  elevation_mm_.clear();
  for (int s = 0; s < steps_; ++s) elevation_mm_.push_back(static_cast<float>(layout.beams.elevationalSigma_mm(s * step_mm_)));
  rays_.configure(layout, probe, steps_, step_mm_);
  const auto samples = static_cast<std::size_t>(lines_) * static_cast<std::size_t>(steps_);
  for (std::vector<float>* ofPlanes : {&own_db_, &reflection_, &gains_}) ofPlanes->resize(static_cast<std::size_t>(planes_) * samples);
  skin_mm_.resize(static_cast<std::size_t>(lines_));
  for (March& march : marches_)
    for (std::vector<float>* ofLines : {&march.waiting_db, &march.loss_log2, &march.reflection_log2, &march.met_db, &march.since_mm})
      ofLines->resize(static_cast<std::size_t>(lines_));
}

void EchoLosses::findSkin(const SliceSource& level, const glm::mat4& labelToLevel, const EchoMotion& motion) {
  const auto isTissue = [&](const glm::vec3& place) {
    const glm::ivec3 voxel = glm::ivec3(glm::floor(glm::vec3(labelToLevel * glm::vec4(place, 1.0F)) + 0.5F));
    if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(voxel, level.grid.dims))) return false;
    return level.voxels[level.grid.indexOf(voxel.x, voxel.y, voxel.z)] > 0;
  };
  // Voxels have a level from half a voxel before the skin on.
  const auto early_mm = static_cast<float>(0.5 * level.grid.spacing_mm.x);
  for (int line = 0; line < lines_; ++line) {
    const glm::vec3 start = ways_.startOf(line), perMm = ways_.perMmOf(line);
    float depth_mm = 0.0F;
    for (; depth_mm < kMostGel_mm; depth_mm += kSkinStep_mm) {
      glm::vec3 place = start + (depth_mm - early_mm) * perMm;
      if (motion.moves()) place += motion.backOn(back_[0], line, depth_mm);
      if (isTissue(place)) break;
    }
    skin_mm_[static_cast<std::size_t>(line)] = std::min(depth_mm, kMostGel_mm);
  }
}

void EchoLosses::walk(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, const SliceSource& level,
                      const Transform<frame::Voxel, frame::Probe>& probeToLevel, const EchoMotion& motion, Bands& bands) {
  const LabelBlend blend{labels, perStep_db_, reflection_db_};
  const glm::dmat4& m = probeToLabel.matrix;
  ways_.lay(layout_->grid, m);
  const glm::vec3 aside(m[2]);
  const auto ahead_mm = static_cast<float>(2.0 * step_mm_);
  if (motion.moves())
    for (std::size_t p = 0; p < static_cast<std::size_t>(planes_); ++p)
      motion.rowsOf(static_cast<double>(kAside[p]), glm::mat3(m), bands, back_[p]);
  findSkin(level, glm::mat4(probeToLevel.matrix * glm::inverse(m)), motion);
  bands.run(steps_, [&](int firstStep, int count, int) {
    for (int p = 0; p < planes_; ++p)
      for (int s = firstStep; s < firstStep + count; ++s) {
        // Halfway to the step before, where its loss lies.
        const auto depth_mm = static_cast<float>(std::max(s - 0.5, 0.0) * step_mm_);
        const glm::vec3 offset = kAside[static_cast<std::size_t>(p)] * elevation_mm_[static_cast<std::size_t>(s)] * aside;
        float* own = own_db_.data() + indexOf(p, s);
        float* reflection = reflection_.data() + indexOf(p, s);
        blendRow(blend, {ways_, offset, depth_mm, ahead_mm, motion.rowsAround(back_[static_cast<std::size_t>(p)], depth_mm)}, 0, lines_,
                 own, reflection);
        if (s == 0) {
          std::fill_n(own, lines_, 0.0F);
        } else if (const auto stepStart_mm = static_cast<float>((s - 1) * step_mm_); stepStart_mm < kMostGel_mm) {
          for (int line = 0; line < lines_; ++line) {
            const float beforeSkin_mm = skin_mm_[static_cast<std::size_t>(line)] - stepStart_mm;
            own[line] += std::clamp(beforeSkin_mm / static_cast<float>(step_mm_), 0.0F, 1.0F) * (gelPerStep_db_ - own[line]);
          }
        }
      }
  });
  bands.runEach(planes_, [&](int plane, int) { march(plane); });
  if (planes_ == 1) return;
  bands.run(steps_, [&](int firstStep, int count, int) {
    for (int p = 1; p < planes_; ++p) {
      float* sum = gains_.data() + indexOf(0, firstStep);
      std::transform(sum, sum + static_cast<std::ptrdiff_t>(count) * lines_, gains_.data() + indexOf(p, firstStep), sum, std::plus());
    }
  });
}

void EchoLosses::march(int plane) {
  constexpr float kLog2PerDb_oneWay = 3.32192809F / 40.0F;
  constexpr float kOut = 0.5F;  // of the reflection that was met
  const auto step_mm = static_cast<float>(step_mm_);
  March& at = marches_[static_cast<std::size_t>(plane)];
  std::fill(at.waiting_db.begin(), at.waiting_db.end(), 0.0F);
  std::fill(at.since_mm.begin(), at.since_mm.end(), 0.0F);
  std::copy_n(reflection_.data() + indexOf(plane, 0), lines_, at.met_db.data());
  rays_.begin(at.rays);
  for (int s = 0; s < steps_; ++s) {
    const float* own = own_db_.data() + indexOf(plane, s);
    const float* reflection = reflection_.data() + indexOf(plane, s);
    const float* before = reflection_.data() + indexOf(plane, std::max(s - 1, 0));
    for (int n = 0; n < lines_; ++n) {
      const auto line = static_cast<std::size_t>(n);
      const float waiting = at.waiting_db[line] + std::max(0.0F, reflection[n] - at.met_db[line]);
      const float released = waiting * release_;
      at.waiting_db[line] = waiting - released;
      at.loss_log2[line] = (own[n] + released) * kLog2PerDb_oneWay;
      at.reflection_log2[line] = before[n] * kLog2PerDb_oneWay;
      const float met_db = std::max(at.met_db[line], reflection[n]);
      const float since_mm = reflection[n] < kOut * met_db ? at.since_mm[line] + step_mm : 0.0F;
      at.met_db[line] = since_mm < kSameThing_mm ? met_db : reflection[n];
      at.since_mm[line] = since_mm;
    }
    float* gain = gains_.data() + indexOf(plane, s);
    std::fill_n(gain, lines_, 0.0F);
    rays_.pass(s, {at.loss_log2.data(), at.reflection_log2.data()}, most_, planes_ == 1 ? 1.0F : kWeights[static_cast<std::size_t>(plane)],
               at.rays, gain);
  }
}

GainSteps EchoLosses::gainOf(int line, std::vector<float>& ofSteps) const {
  const std::size_t asked = static_cast<std::size_t>(steps_) + GainSteps::kBeyond;
  ofSteps.resize(std::max(ofSteps.size(), asked));
  for (int s = 0; s < steps_; ++s) ofSteps[static_cast<std::size_t>(s)] = gains_[indexOf(0, s) + static_cast<std::size_t>(line)];
  const auto perColumn = static_cast<float>(layout_->grid.sampleSpacing_mm / step_mm_);
  return {ofSteps.data(), steps_, -static_cast<float>(layout_->columnPadding) * perColumn, perColumn};
}

}  // namespace ew::detail
