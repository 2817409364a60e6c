#include "scanner/form_lines.h"

#include <algorithm>
#include <cmath>

#include "ew/phantom/speckle.h"

namespace ew::phantom {
namespace {

constexpr double kLagPerPitch = 0.9;  // losses begin this much deeper, so that a surface does not shadow its own echo
constexpr double kNoNoise_db = -200.0;

void weaken(const ScannerSetup& setup, double pitch_mm, std::size_t l, FrameScratch& work) {
  if (!setup.options.attenuation) return;
  const float* gain = work.gain.data() + l * static_cast<std::size_t>(setup.steps);
  const double lag_mm = kLagPerPitch * pitch_mm;
  for (std::size_t column = 0; column < setup.columns; ++column) {
    const double depth = (static_cast<double>(column) - setup.columnPadding) * setup.grid.sampleSpacing_mm - lag_mm;
    const double step = std::clamp(depth / setup.step_mm, 0.0, static_cast<double>(setup.steps - 1) - 1e-6);
    const auto s = static_cast<std::size_t>(step);
    const auto t = static_cast<float>(step - static_cast<double>(s));
    const float factor = gain[s] + t * (gain[s + 1] - gain[s]);
    work.line[2 * column] *= factor;
    work.line[2 * column + 1] *= factor;
  }
}

/// Before the pulse's filter, which the receiver is: noise has the grain of the pulse along a line and none across.
void addNoise(const ScannerSetup& setup, std::uint64_t frame, std::size_t l, FrameScratch& work) {
  if (setup.options.noise_db <= kNoNoise_db) return;
  // A sum of two even 16-bit numbers has the variance 2^32 / 6; the filter makes it Gaussian enough.
  const auto strength =
      static_cast<float>(std::sqrt(3.0 * std::pow(10.0, 0.1 * setup.options.noise_db) * setup.grid.sampleSpacing_mm) / 65536.0);
  const std::uint64_t seed = hashOfPlace(setup.options.noiseSeed, static_cast<std::int64_t>(frame), 0, 0x6e6f697365);
  for (std::size_t column = 0; column < setup.columns; ++column) {
    const std::uint64_t hash = hashOfPlace(seed, static_cast<std::int64_t>(l), static_cast<std::int64_t>(column), 1);
    const auto part = [&](int shift) { return static_cast<float>((hash >> shift) & 0xFFFFu) - 32767.5F; };
    work.line[2 * column] += strength * (part(0) + part(16));
    work.line[2 * column + 1] += strength * (part(32) + part(48));
  }
}

/// The pulse's filter about one carrier, and its envelope.
void addLook(const ScannerSetup& setup, std::size_t look, std::size_t l, FrameScratch& work, Image<float>& envelope) {
  const std::size_t lines = setup.grid.lines.size(), samples = static_cast<std::size_t>(setup.grid.samples);
  const std::size_t margin = 2 * static_cast<std::size_t>(setup.columnPadding), count = 2 * samples;
  const float* in = work.line.data();
  if (setup.turns.size() > 1) {
    const std::vector<float>& turn = setup.turns[look];
    work.turned.resize(work.line.size());
    for (std::size_t n = 0; n < work.line.size(); n += 2) {
      work.turned[n] = work.line[n] * turn[n] - work.line[n + 1] * turn[n + 1];
      work.turned[n + 1] = work.line[n] * turn[n + 1] + work.line[n + 1] * turn[n];
    }
    in = work.turned.data();
  }
  std::fill(work.pulsed.begin(), work.pulsed.begin() + static_cast<std::ptrdiff_t>(count), 0.0F);
  accumulate(in + margin, setup.pulse[0], count, work.pulsed.data());
  for (std::size_t t = 1; t < setup.pulse.size(); ++t) {
    accumulate(in + margin - 2 * t, setup.pulse[t], count, work.pulsed.data());
    accumulate(in + margin + 2 * t, setup.pulse[t], count, work.pulsed.data());
  }
  const auto share = static_cast<float>(setup.lookScale / static_cast<double>(setup.turns.size()));
  for (std::size_t s = 0; s < samples; ++s) {
    const float re = work.pulsed[2 * s] + setup.ring[s], im = work.pulsed[2 * s + 1];
    envelope.pixels[s * lines + l] += share * setup.depthGain[s] * std::sqrt(re * re + im * im);
  }
}

}  // namespace

void formLines(const ScannerSetup& setup, double pitch_mm, std::uint64_t frame, FrameScratch& work, Image<float>& envelope) {
  const std::size_t lines = setup.grid.lines.size(), samples = static_cast<std::size_t>(setup.grid.samples);
  const std::size_t stride = 2 * setup.columns;
  envelope.width = static_cast<int>(lines);
  envelope.height = setup.grid.samples;
  envelope.pixels.resize(lines * samples);
  work.line.resize(stride);
  work.pulsed.resize(stride);
  for (std::size_t l = 0; l < lines; ++l) {
    // Lateral beam: rows about the line, weighted by depth.
    std::fill(work.line.begin(), work.line.end(), 0.0F);
    const float* middle =
        work.fine.data() + (static_cast<std::size_t>(setup.rowPadding) + l * static_cast<std::size_t>(setup.rowsPerLine)) * stride;
    for (std::size_t chunk = 0; chunk < setup.reachOfChunk.size(); ++chunk) {
      const std::size_t first = 2 * kChunk * chunk, count = std::min(2 * kChunk, stride - first);
      for (int t = -setup.reachOfChunk[chunk]; t <= setup.reachOfChunk[chunk]; ++t) {
        const float* weights = setup.lateral[static_cast<std::size_t>(std::abs(t))].data() + first;
        accumulate(middle + t * static_cast<std::ptrdiff_t>(stride) + static_cast<std::ptrdiff_t>(first), weights, count,
                   work.line.data() + first);
      }
    }
    weaken(setup, pitch_mm, l, work);
    addNoise(setup, frame, l, work);
    for (std::size_t s = 0; s < samples; ++s) envelope.pixels[s * lines + l] = 0.0F;
    for (std::size_t look = 0; look < setup.turns.size(); ++look) addLook(setup, look, l, work, envelope);
  }
}

}  // namespace ew::phantom
