#include "ew/imaging/slicing.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "ew/imaging/effects/stretch.h"
#include "template_line.h"

namespace ew {
namespace {

using ImageToVoxel = Transform<frame::Voxel, frame::Image>;
using detail::Clipping;
using detail::TemplateLine;

using RowsSampler = void (*)(const TemplateLine&, const SliceScratch&, int, const Clipping&, ImageView<std::uint8_t>);

RowsSampler samplerOf(Quality quality) {
  switch (quality) {
    case Quality::weave:
      return detail::weaveRows;
    case Quality::linear:
      return detail::linearRows;
    case Quality::cubic:
      return detail::cubicRows;
  }
  return detail::linearRows;
}

void blacken(const Clipping& clipping, ImageView<std::uint8_t> out) {
  for (int y = 0; y < out.height; ++y)
    for (const RowSpan& span : clipping.of(y)) std::fill(out.row(y) + span.begin, out.row(y) + span.end, std::uint8_t{0});
}

void sliceRows(RowsSampler sampleRows, const SliceSource& source, const ImageToVoxel& imageToVoxel, const Clipping& clipping,
               ImageView<std::uint8_t> out, SliceScratch& scratch) {
  const glm::dmat4& m = imageToVoxel.matrix;
  const TemplateLine line =
      detail::layTemplate(source, glm::dvec3(m[3]), glm::dvec3(m[0]), glm::dvec3(m[1]), out.width, out.height, scratch);
  if (line.empty) return blacken(clipping, out);
  sampleRows(line, scratch, 0, clipping, out);
}

/// How many voxel-sized samples cover `pixels` pixels, ends included; `pixels` when a pixel is not smaller than a voxel.
int voxelSizedSamples(int pixels, double step_voxel) {
  const double length_voxel = static_cast<double>(pixels - 1) * step_voxel;
  // The subtrahend forgives the rounding of a step that is meant to be exactly one voxel. NaN compares false.
  if (!(length_voxel < static_cast<double>(pixels - 1))) return pixels;
  return std::min(pixels, static_cast<int>(std::ceil(length_voxel - 1e-9)) + 1);
}

constexpr int kBlendBits = 14;  // 8 bit greys times 14 bit weights stay in 16 x 16 -> 32 bit products, which vector units have

void blendRows(const std::uint8_t* upper, const std::uint8_t* lower, int weight, RowSpan span, std::uint8_t* out) {
  const int rest = (1 << kBlendBits) - weight;
  for (int x = span.begin; x < span.end; ++x)
    out[x] = static_cast<std::uint8_t>((upper[x] * rest + lower[x] * weight + (1 << (kBlendBits - 1))) >> kBlendBits);
}

/// Fig. 5: rows x columns voxel-sized samples, stretched along each row as it is sampled and downwards as soon as two rows are there.
void sliceZoomedIn(const SliceSource& source, const ImageToVoxel& imageToVoxel, int columns, int rows, const Clipping& clipping,
                   ImageView<std::uint8_t> out, SliceScratch& scratch) {
  const glm::dmat4& m = imageToVoxel.matrix;
  const auto scale = [](int pixels, int samples) { return samples > 1 ? static_cast<double>(pixels - 1) / (samples - 1) : 0.0; };
  const TemplateLine line = detail::layTemplate(source, glm::dvec3(m[3]), glm::dvec3(m[0]) * scale(out.width, columns),
                                                glm::dvec3(m[1]) * scale(out.height, rows), columns, rows, scratch);
  if (line.empty) return blacken(clipping, out);

  const auto width = static_cast<std::size_t>(out.width);
  const auto sampleCount = static_cast<std::size_t>(columns);
  scratch.rows.resize(sampleCount + 2 * width);
  const std::span<std::uint8_t> samples(scratch.rows.data(), sampleCount);
  const auto stretched = [&](int row) {
    return std::span<std::uint8_t>(scratch.rows.data() + sampleCount + static_cast<std::size_t>(row % 2) * width, width);
  };
  using Clock = std::chrono::steady_clock;
  Clock::duration sampling{};
  int sampledRows = 0;
  const auto need = [&](int row) {
    for (; sampledRows <= row; ++sampledRows) {
      const auto start = Clock::now();
      detail::weaveRows(line, scratch, sampledRows, {{}, {0, columns}}, {samples.data(), columns, 1, columns});
      sampling += Clock::now() - start;
      stretch(samples, stretched(sampledRows));
    }
  };
  const std::uint64_t step = out.height > 1 ? (static_cast<std::uint64_t>(rows - 1) << 32) / static_cast<std::uint64_t>(out.height - 1) : 0;
  for (int y = 0; y < out.height; ++y) {
    const std::uint64_t position =
        y + 1 == out.height && out.height > 1 ? static_cast<std::uint64_t>(rows - 1) << 32 : step * static_cast<std::uint64_t>(y);
    const int upper = static_cast<int>(position >> 32);
    const int lower = std::min(upper + 1, rows - 1);
    const int weight = static_cast<int>((position & 0xffffffffU) >> (32 - kBlendBits));
    need(lower);
    for (const RowSpan& span : clipping.of(y)) blendRows(stretched(upper).data(), stretched(lower).data(), weight, span, out.row(y));
  }
  scratch.zoomSampling_us = std::chrono::duration<double, std::micro>(sampling).count();
}

void sliceClipped(Quality quality, const SliceSource& source, const ImageToVoxel& imageToVoxel, const Clipping& clipping,
                  ImageView<std::uint8_t> out, SliceScratch& scratch) {
  if (out.width < 1 || out.height < 1) return;
  if (quality != Quality::weave) return sliceRows(samplerOf(quality), source, imageToVoxel, clipping, out, scratch);
  const int columns = voxelSizedSamples(out.width, glm::length(glm::dvec3(imageToVoxel.matrix[0])));
  const int rows = voxelSizedSamples(out.height, glm::length(glm::dvec3(imageToVoxel.matrix[1])));
  if (columns == out.width && rows == out.height) return sliceRows(detail::weaveRows, source, imageToVoxel, clipping, out, scratch);
  sliceZoomedIn(source, imageToVoxel, columns, rows, clipping, out, scratch);
}

Clipping wholeImage(const ImageView<std::uint8_t>& out) { return {{}, {0, out.width}}; }

}  // namespace

void sliceWeave(const SliceSource& source, const ImageToVoxel& imageToVoxel, ImageView<std::uint8_t> out, SliceScratch& scratch) {
  sliceRows(detail::weaveRows, source, imageToVoxel, wholeImage(out), out, scratch);
}

void sliceLinear(const SliceSource& source, const ImageToVoxel& imageToVoxel, ImageView<std::uint8_t> out, SliceScratch& scratch) {
  sliceRows(detail::linearRows, source, imageToVoxel, wholeImage(out), out, scratch);
}

void slice(Quality quality, const SliceSource& source, const ImageToVoxel& imageToVoxel, ImageView<std::uint8_t> out,
           SliceScratch& scratch) {
  sliceClipped(quality, source, imageToVoxel, wholeImage(out), out, scratch);
}

void slice(Quality quality, const SliceSource& source, const ImageToVoxel& imageToVoxel, std::span<const std::vector<RowSpan>> spans,
           ImageView<std::uint8_t> out, SliceScratch& scratch) {
  EW_EXPECTS(spans.size() == static_cast<std::size_t>(out.height));
  sliceClipped(quality, source, imageToVoxel, {spans, {}}, out, scratch);
}

void sliceCubic(const SliceSource& source, const ImageToVoxel& imageToVoxel, ImageView<std::uint8_t> out, SliceScratch& scratch) {
  sliceRows(detail::cubicRows, source, imageToVoxel, wholeImage(out), out, scratch);
}

void sampleRows(Quality quality, const SliceSource& source, std::span<const SampleRow> rows, ImageView<std::uint8_t> out,
                SliceScratch& scratch) {
  const RowsSampler sampler = samplerOf(quality);
  for (const SampleRow& row : rows) {
    EW_EXPECTS(row.row >= 0 && row.row < out.height && row.span.begin >= 0 && row.span.end <= out.width);
    if (row.span.begin >= row.span.end) continue;
    const Clipping clipping{{}, row.span};
    const ImageView<std::uint8_t> outRow{out.row(row.row), out.width, 1, out.stride};
    const TemplateLine line = detail::layTemplate(source, row.start_voxel, row.step_voxel, glm::dvec3(0.0), row.span.end, 1, scratch);
    if (line.empty)
      blacken(clipping, outRow);
    else
      sampler(line, scratch, 0, clipping, outRow);
  }
}

Transform<frame::Probe, frame::Image> sliceGeometry(int width, double pixel_mm) {
  Transform<frame::Probe, frame::Image> imageToProbe;
  imageToProbe.matrix[0][0] = pixel_mm;
  imageToProbe.matrix[1][1] = pixel_mm;
  imageToProbe.matrix[2][2] = pixel_mm;
  imageToProbe.matrix[3][0] = -0.5 * static_cast<double>(width - 1) * pixel_mm;
  return imageToProbe;
}

}  // namespace ew
