#include "scanner/block_echoes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scanner/slice_blocks.h"

namespace ew::phantom {
namespace {

void move(const View& view, const float* x, const float* y, const float* z, std::size_t count, const Trilinear& to, PointBatch& batch) {
  if (view.deforms) {
    moveTrilinear(x, y, z, count, to, batch);
  } else {
    moveAffine(x, y, z, count, to, batch);
  }
}

void delay(const ScannerSetup& setup, std::size_t count, FrameScratch& work) {
  const std::size_t steps = static_cast<std::size_t>(setup.steps);
  const double lastLine = static_cast<double>(setup.grid.lines.size() - 1), lastStep = static_cast<double>(setup.steps - 1);
  for (std::size_t n = 0; n < count; ++n) {
    const double line = std::clamp((static_cast<double>(work.batch.row[n]) - setup.rowPadding) / setup.rowsPerLine, 0.0, lastLine - 1e-6);
    const double step = std::clamp(static_cast<double>(work.batch.range_mm[n]) / setup.step_mm, 0.0, lastStep - 1e-6);
    const auto l = static_cast<std::size_t>(line), s = static_cast<std::size_t>(step);
    const auto tl = static_cast<float>(line - static_cast<double>(l)), ts = static_cast<float>(step - static_cast<double>(s));
    const float* near = work.delay_mm.data() + l * steps + s;
    const float* far = near + steps;
    work.batch.range_mm[n] += (1.0F - tl) * (near[0] + ts * (near[1] - near[0])) + tl * (far[0] + ts * (far[1] - far[0]));
  }
}

void addBatch(const ScannerSetup& setup, std::size_t count, FrameScratch& work) {
  PointBatch& batch = work.batch;
  placeOnLines(setup.gridding, count, batch);
  if (setup.options.speedOfSound) delay(setup, count, work);
  weigh(setup.gridding, count, batch);
  deposit(count, batch, work.fine.data());
}

void addFacets(const ScannerSetup& setup, double spacing_mm, const View& view, const ScattererBlock& made, const Trilinear& to,
               FrameScratch& work) {
  PointBatch& batch = work.batch;
  const glm::mat3 turn(to[1], to[2], to[3]);
  // A facet is a spot of half its spacing: what it mirrors falls off with the tilt against the wave as that spot's Fourier transform.
  const double spread = 2.0 * std::numbers::pi * spacing_mm / setup.beams.wavelength_mm;
  const auto sharpness = static_cast<float>(0.5 * spread * spread);
  const auto roughScale = static_cast<float>(std::sqrt(setup.beams.axialSigma_mm * std::sqrt(std::numbers::pi)));
  for (std::size_t first = 0; first < made.facets.size(); first += PointBatch::kMost) {
    const std::size_t count = std::min(PointBatch::kMost, made.facets.size() - first);
    work.facetX.resize(count);
    work.facetY.resize(count);
    work.facetZ.resize(count);
    for (std::size_t n = 0; n < count; ++n) {
      const glm::vec3& place = made.facets[first + n].place;
      work.facetX[n] = place.x;
      work.facetY[n] = place.y;
      work.facetZ[n] = place.z;
    }
    move(view, work.facetX.data(), work.facetY.data(), work.facetZ.data(), count, to, batch);
    for (std::size_t n = 0; n < count; ++n) {
      const ScattererBlock::Facet& facet = made.facets[first + n];
      const float x = batch.x[n], y = batch.y[n], z = batch.z[n];
      glm::vec3 wave(0.0F, 1.0F, 0.0F);
      float depth = y;
      if (setup.fan.sector) {
        const float up = y + setup.gridding.apex_mm, radius = std::sqrt(x * x + up * up) + 1e-6F;
        wave = {x / radius, up / radius, 0.0F};
        depth = radius - setup.gridding.apex_mm;
      }
      const float off = depth - setup.gridding.lensFocus_mm, perRange = off < 0.0F ? setup.gridding.nearPerMm : setup.gridding.farPerMm;
      const float q = off * perRange;
      wave.z = z * q * perRange / (1.0F + q * q);
      const glm::vec3 normal = turn * facet.normal;
      const float lengths2 = glm::dot(normal, normal) * glm::dot(wave, wave);
      const float cosine = glm::dot(normal, wave) / std::sqrt(lengths2);
      const auto column = static_cast<std::size_t>(
          std::clamp(setup.gridding.firstColumn + setup.gridding.columnsPerMm * depth, 0.0F, static_cast<float>(setup.columns - 1)));
      const bool visible = !facet.frontOnly || cosine < 0.0F;
      const float mirror = facet.mirror * setup.mirrorScale[column] * std::exp(-sharpness * (1.0F - cosine * cosine));
      batch.amplitude[n] = visible ? mirror + facet.rough * roughScale * std::abs(cosine) : 0.0F;
    }
    addBatch(setup, count, work);
  }
}

}  // namespace

void addBlock(const ScannerSetup& setup, const ScattererField& field, const View& view, const FrameScratch::Block& block,
              FrameScratch& work) {
  const Trilinear to = motionOf(field, view, block.index, work);
  const ScattererBlock& made = *block.made;
  PointBatch& batch = work.batch;
  if (!made.x.empty()) {
    const std::size_t count = made.x.size();
    static_assert(std::size_t{ScattererBlock::kCells} * ScattererBlock::kCells * ScattererBlock::kCells <= PointBatch::kMost);
    move(view, made.x.data(), made.y.data(), made.z.data(), count, to, batch);
    std::copy(made.amplitude.begin(), made.amplitude.end(), batch.amplitude.begin());
    addBatch(setup, count, work);
  }
  if (setup.options.specular && !made.facets.empty()) addFacets(setup, field.facetSpacing_mm(), view, made, to, work);
}

}  // namespace ew::phantom
