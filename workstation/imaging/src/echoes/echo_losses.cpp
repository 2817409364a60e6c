#include "echo_losses.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "line_kernels.h"

namespace ew::detail {
namespace {

constexpr double kStep_mm = 0.5;
constexpr double kBlurPerAperture = 0.27 * 0.29 * 0.29;
constexpr double kFNumber = 2.0;
constexpr double kLongestRelease_mm = 0.8;

/// Means of two tables over the eight voxels around a point; the table's value for label 0 outside.
struct Blended {
  float own = 0.0F;
  float reflection = 0.0F;
};

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
  amplitude_.resize(static_cast<std::size_t>(lines_));
  waiting_.resize(static_cast<std::size_t>(lines_));
  loss_.resize(static_cast<std::size_t>(lines_));
  scratch_.resize(static_cast<std::size_t>(lines_) + 2);
}

void EchoLosses::walk(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, Bands& bands) {
  const glm::ivec3 dims = labels.grid.dims;
  const std::ptrdiff_t row = dims.x, plane = static_cast<std::ptrdiff_t>(dims.x) * dims.y;
  const auto at = [&](const glm::dvec3& p) {
    const glm::dvec3 limited = glm::clamp(p, glm::dvec3(0.0), glm::dvec3(dims - 1) - 1e-6);
    if (limited != p) return Blended{perStep_db_[0], reflection_db_[0]};
    const glm::ivec3 whole(limited);
    const glm::vec3 t(limited - glm::dvec3(whole));
    const std::uint8_t* first = labels.voxels + whole.x + row * whole.y + plane * whole.z;
    std::array<std::uint16_t, 4> pairs;
    std::memcpy(&pairs[0], first, 2);
    std::memcpy(&pairs[1], first + row, 2);
    std::memcpy(&pairs[2], first + plane, 2);
    std::memcpy(&pairs[3], first + row + plane, 2);
    const auto even = static_cast<std::uint16_t>(*first * 0x0101U);
    if (((pairs[0] ^ even) | (pairs[1] ^ even) | (pairs[2] ^ even) | (pairs[3] ^ even)) == 0)
      return Blended{perStep_db_[*first], reflection_db_[*first]};
    const auto blended = [&](const std::array<float, 256>& table) {
      const auto along = [&](std::uint16_t pair) {
        const float low = table[pair & 0xFFU], high = table[pair >> 8];
        return low + t.x * (high - low);
      };
      const float near = along(pairs[0]) + t.y * (along(pairs[1]) - along(pairs[0]));
      const float far = along(pairs[2]) + t.y * (along(pairs[3]) - along(pairs[2]));
      return near + t.z * (far - near);
    };
    return Blended{blended(perStep_db_), blended(reflection_db_)};
  };
  const glm::dmat4& m = probeToLabel.matrix;
  bands.run(steps_, [&](int firstStep, int count, int) {
    for (int p = 0; p < kPlanes; ++p)
      for (int s = firstStep; s < firstStep + count; ++s) {
        // Halfway to the step before, where its loss lies.
        const double depth_mm = std::max(s - 0.5, 0.0) * step_mm_;
        const double aside_mm = kAside[static_cast<std::size_t>(p)] * static_cast<double>(elevation_mm_[static_cast<std::size_t>(s)]);
        const std::size_t first = indexOf(p, s);
        for (int line = 0; line < lines_; ++line) {
          const BeamGrid::Line& way = layout_->grid.lines[static_cast<std::size_t>(line)];
          const glm::dvec4 place(way.origin_mm + depth_mm * way.direction, aside_mm, 1.0);
          const Blended found = at(glm::dvec3(m * place));
          own_db_[first + static_cast<std::size_t>(line)] = found.own;
          reflection_[first + static_cast<std::size_t>(line)] = found.reflection;
        }
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

void EchoLosses::gainsOf(int line, std::span<float> gains) const {
  const auto last = static_cast<float>(steps_ - 1) - 1e-3F;
  const auto perColumn = static_cast<float>(layout_->grid.sampleSpacing_mm / step_mm_);
  const float first = -static_cast<float>(layout_->columnPadding) * perColumn;
  for (std::size_t column = 0; column < gains.size(); ++column) {
    const float step = std::clamp(first + static_cast<float>(column) * perColumn, 0.0F, last);
    const auto whole = static_cast<int>(step);
    const float t = step - static_cast<float>(whole);
    const float here = gains_[indexOf(0, whole) + static_cast<std::size_t>(line)],
                next = gains_[indexOf(0, whole + 1) + static_cast<std::size_t>(line)];
    gains[column] = here + t * (next - here);
  }
}

}  // namespace ew::detail
