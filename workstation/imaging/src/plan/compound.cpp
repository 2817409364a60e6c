#include "compound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "echoes/line_kernels.h"
#include "ew/core/contract.h"
#include "ew/core/image.h"

namespace ew::detail {
namespace {

constexpr double kFade_lines = 12.0;  // over which a direction's share fades towards its outermost line
constexpr double kFade_mm = 4.0;      // likewise towards both ends of its lines

}  // namespace

std::vector<double> looksBeside(int angles, bool fromAnArc) {
  EW_EXPECTS(angles % 2 == 1 && angles >= 1);
  const double step_rad = (fromAnArc ? 12.0 : 8.5) * std::numbers::pi / 180.0;
  std::vector<double> looks_rad;
  for (int n = -(angles / 2); n <= angles / 2; ++n)
    if (n != 0) looks_rad.push_back(step_rad * n);
  return looks_rad;
}

CompoundTable makeCompound(const Probe& probe, const Knobs& knobs, const BeamGrid& middle, std::span<const BeamGrid> grids,
                           std::span<const double> looks_rad) {
  EW_EXPECTS(grids.size() == looks_rad.size());
  CompoundTable table;
  table.lines = static_cast<int>(middle.lines.size());
  const double lastLine = table.lines - 1.0, lastSample = middle.samples - 1.0;
  for (std::size_t look = 0; look < grids.size(); ++look) {
    EW_EXPECTS(grids[look].lines.size() == middle.lines.size() && grids[look].samples == middle.samples);
    std::vector<CompoundTable::Tap>& taps = table.ofLook.emplace_back();
    taps.reserve(static_cast<std::size_t>(table.lines) * static_cast<std::size_t>(middle.samples));
    for (int s = 0; s < middle.samples; ++s)
      for (const BeamGrid::Line& line : middle.lines) {
        const glm::dvec2 at =
            lineAndSampleAt(probe, knobs, grids[look], line.origin_mm + middle.depth_mm(s) * line.direction, looks_rad[look]);
        CompoundTable::Tap& tap = taps.emplace_back();
        const double aside = std::clamp(std::min(at.x, lastLine - at.x) / kFade_lines, 0.0, 1.0);
        const double along = std::clamp(middle.depth_mm(std::min(at.y, lastSample - at.y)) / kFade_mm, 0.0, 1.0);
        tap.share = static_cast<float>(aside * along);
        const double x = std::clamp(at.x, 0.0, lastLine), y = std::clamp(at.y, 0.0, lastSample);
        const double wholeX = std::min(std::floor(x), lastLine - 1.0), wholeY = std::min(std::floor(y), lastSample - 1.0);
        tap.first = static_cast<std::uint32_t>(wholeY) * static_cast<std::uint32_t>(table.lines) + static_cast<std::uint32_t>(wholeX);
        tap.lineWeight = static_cast<float>(x - wholeX);
        tap.sampleWeight = static_cast<float>(y - wholeY);
      }
  }
  return table;
}

double compoundBrightens_db(int angles, int looks) {
  // Half of the squared coefficient of variation of a Rayleigh amplitude, in dB, over the independent values that were averaged (as
  // echo_layout.cpp has it for looks).
  const double independent = looks * looks / (looks + 2.0 * (looks - 1) * std::exp(-2.0));
  return 0.5 * 8.685889638 * (4.0 / std::numbers::pi - 1.0) / independent * (1.0 - 1.0 / angles);
}

void compound(const CompoundTable& table, double brightens_db, double greyPerDb, std::span<BeamImage* const> asides, Bands& bands,
              BeamImage& levels) {
  EW_EXPECTS(asides.size() == table.ofLook.size() && levels.width == table.lines);
  const double perDoubling = 20.0 * std::log10(2.0) * greyPerDb;
  const auto less = static_cast<float>(std::pow(10.0, -0.05 * brightens_db));
  const auto rowOf = [&](BeamImage& image, int row) { return image.pixels.data() + static_cast<std::ptrdiff_t>(row) * table.lines; };
  bands.run(levels.height, [&](int firstRow, int count, int) {
    for (BeamImage* aside : asides) toAmplitudes(static_cast<float>(1.0 / perDoubling), count * table.lines, rowOf(*aside, firstRow));
    toAmplitudes(static_cast<float>(1.0 / perDoubling), count * table.lines, rowOf(levels, firstRow));
  });
  bands.run(levels.height, [&](int firstRow, int count, int) {
    for (int row = firstRow; row < firstRow + count; ++row) {
      float* out = rowOf(levels, row);
      for (int line = 0; line < table.lines; ++line) {
        const std::size_t n = static_cast<std::size_t>(row) * static_cast<std::size_t>(table.lines) + static_cast<std::size_t>(line);
        float sum = out[line], shares = 1.0F;
        for (std::size_t look = 0; look < asides.size(); ++look) {
          const CompoundTable::Tap& tap = table.ofLook[look][n];
          const float* near = asides[look]->pixels.data() + tap.first;
          const float* far = near + table.lines;
          const float above = near[0] + (near[1] - near[0]) * tap.lineWeight, below = far[0] + (far[1] - far[0]) * tap.lineWeight;
          sum += tap.share * (above + (below - above) * tap.sampleWeight);
          shares += tap.share;
        }
        out[line] = less * sum / shares;
      }
      fromAmplitudes(static_cast<float>(perDoubling), table.lines, out);
    }
  });
}

}  // namespace ew::detail
