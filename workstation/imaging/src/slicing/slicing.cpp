#include "ew/imaging/slicing.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "ew/imaging/effects/stretch.h"
#include "ew/imaging/frame_stack.h"
#include "row_sampler.h"

namespace ew {
namespace {

using ImageToVoxel = Transform<frame::Voxel, frame::Image>;
using detail::RowSampler;
using detail::TemplateLine;

/// The spans of row y, or the whole row when no spans were given.
struct Clipping {
  std::span<const std::vector<RowSpan>> spans;
  RowSpan wholeRow;
  [[nodiscard]] std::span<const RowSpan> of(int y) const {
    if (spans.empty()) return {&wholeRow, 1};
    return spans[static_cast<std::size_t>(y)];
  }
};

struct Rows {
  int begin = 0;
  int end = 0;
};

/// Whether the first and the last row of a plane can be sampled: then one that cannot makes the whole image black.
bool reachesInRange(const glm::dmat4& imageToVoxel, int height) {
  return detail::isInRange(glm::dvec3(imageToVoxel[3])) && detail::isInRange(glm::dvec3(imageToVoxel[1]) * static_cast<double>(height));
}

/// Base and template of Eq. 1: every row of the plane begins at its own base and repeats the one template.
void slicePlane(Quality quality, const SliceSource& source, const ImageToVoxel& imageToVoxel, const Clipping& clipping, Rows rows,
                ImageView<std::uint8_t> out, SliceScratch& scratch) {
  const glm::dmat4& m = imageToVoxel.matrix;
  const SliceSource chosen = source.inLayoutFor(sliceClassOf(quality, glm::dvec3(m[0]), glm::dvec3(m[1])));
  TemplateLine line = detail::layTemplate(chosen, glm::dvec3(m[0]), out.width, scratch);
  line.empty = line.empty || !reachesInRange(m, out.height);
  RowSampler sampler(quality);
  for (int y = rows.begin; y < rows.end; ++y) {
    const glm::dvec3 base_voxel = glm::dvec3(m[3]) + static_cast<double>(y) * glm::dvec3(m[1]);
    for (const RowSpan& span : clipping.of(y)) sampler.sample(line, base_voxel, span, out.row(y));
  }
  sampler.finish();
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
void sliceZoomedIn(const SliceSource& source, const ImageToVoxel& imageToVoxel, int columns, int rows, const Clipping& clipping, Rows asked,
                   ImageView<std::uint8_t> out, SliceScratch& scratch) {
  const glm::dmat4& m = imageToVoxel.matrix;
  const auto scale = [](int pixels, int samples) { return samples > 1 ? static_cast<double>(pixels - 1) / (samples - 1) : 0.0; };
  const glm::dvec3 step_voxel = glm::dvec3(m[0]) * scale(out.width, columns);
  const glm::dvec3 downwards_voxel = glm::dvec3(m[1]) * scale(out.height, rows);
  const SliceSource chosen = source.inLayoutFor(sliceClassOf(Quality::weave, step_voxel, downwards_voxel));
  TemplateLine line = detail::layTemplate(chosen, step_voxel, columns, scratch);
  line.empty = line.empty || !reachesInRange(m, out.height);

  const auto width = static_cast<std::size_t>(out.width);
  const auto sampleCount = static_cast<std::size_t>(columns);
  scratch.rows.resize(sampleCount + 2 * width);
  const std::span<std::uint8_t> samples(scratch.rows.data(), sampleCount);
  const auto stretched = [&](int row) {
    return std::span<std::uint8_t>(scratch.rows.data() + sampleCount + static_cast<std::size_t>(row % 2) * width, width);
  };
  using Clock = std::chrono::steady_clock;
  Clock::duration sampling{};
  RowSampler sampler(Quality::weave);
  int sampledRows = -1;  // none yet
  const auto need = [&](int upper, int lower) {
    for (int row = std::max(upper, sampledRows); row <= lower; ++row) {
      const auto start = Clock::now();
      sampler.sample(line, glm::dvec3(m[3]) + static_cast<double>(row) * downwards_voxel, {0, columns}, samples.data());
      sampler.finish();
      sampling += Clock::now() - start;
      stretch(samples, stretched(row));
      sampledRows = row + 1;
    }
  };
  const std::uint64_t step = out.height > 1 ? (static_cast<std::uint64_t>(rows - 1) << 32) / static_cast<std::uint64_t>(out.height - 1) : 0;
  for (int y = asked.begin; y < asked.end; ++y) {
    const std::uint64_t position =
        y + 1 == out.height && out.height > 1 ? static_cast<std::uint64_t>(rows - 1) << 32 : step * static_cast<std::uint64_t>(y);
    const int upper = static_cast<int>(position >> 32);
    const int lower = std::min(upper + 1, rows - 1);
    const int weight = static_cast<int>((position & 0xffffffffU) >> (32 - kBlendBits));
    need(upper, lower);
    for (const RowSpan& span : clipping.of(y)) blendRows(stretched(upper).data(), stretched(lower).data(), weight, span, out.row(y));
  }
  scratch.zoomSampling_us = std::chrono::duration<double, std::micro>(sampling).count();
}

void sliceClipped(Quality quality, const SliceSource& source, const ImageToVoxel& imageToVoxel, const Clipping& clipping, Rows asked,
                  ImageView<std::uint8_t> out, SliceScratch& scratch) {
  if (out.width < 1 || out.height < 1) return;
  if (source.frames != nullptr) {
    for (int y = asked.begin; y < asked.end; ++y)
      for (const RowSpan& span : clipping.of(y))
        source.frames->sampleRow(quality, glm::dvec3(imageToVoxel.matrix * glm::dvec4(0.0, y, 0.0, 1.0)),
                                 glm::dvec3(imageToVoxel.matrix[0]), span, out.row(y));
    return;
  }
  if (quality != Quality::weave) return slicePlane(quality, source, imageToVoxel, clipping, asked, out, scratch);
  const int columns = voxelSizedSamples(out.width, glm::length(glm::dvec3(imageToVoxel.matrix[0])));
  const int rows = voxelSizedSamples(out.height, glm::length(glm::dvec3(imageToVoxel.matrix[1])));
  if (columns == out.width && rows == out.height) return slicePlane(quality, source, imageToVoxel, clipping, asked, out, scratch);
  sliceZoomedIn(source, imageToVoxel, columns, rows, clipping, asked, out, scratch);
}

/// That of the middle one of rows that lie beside one another. A row alone is too little to matter.
SliceClass classOf(Quality quality, std::span<const SampleRow> rows) {
  if (rows.empty()) return {quality};
  const std::size_t at = rows.size() / 2;
  const SampleRow &row = rows[at], &before = rows[at > 0 ? at - 1 : 0];
  const double middle = 0.5 * (row.span.begin + row.span.end);
  return sliceClassOf(quality, row.step_voxel, row.start_voxel - before.start_voxel + middle * (row.step_voxel - before.step_voxel));
}

Clipping wholeImage(const ImageView<std::uint8_t>& out) { return {{}, {0, out.width}}; }

}  // namespace

void sliceWeave(const SliceSource& source, const ImageToVoxel& imageToVoxel, ImageView<std::uint8_t> out, SliceScratch& scratch) {
  slicePlane(Quality::weave, source, imageToVoxel, wholeImage(out), {0, out.height}, out, scratch);
}

void sliceLinear(const SliceSource& source, const ImageToVoxel& imageToVoxel, ImageView<std::uint8_t> out, SliceScratch& scratch) {
  slicePlane(Quality::linear, source, imageToVoxel, wholeImage(out), {0, out.height}, out, scratch);
}

void sliceCubic(const SliceSource& source, const ImageToVoxel& imageToVoxel, ImageView<std::uint8_t> out, SliceScratch& scratch) {
  slicePlane(Quality::cubic, source, imageToVoxel, wholeImage(out), {0, out.height}, out, scratch);
}

void slice(Quality quality, const SliceSource& source, const ImageToVoxel& imageToVoxel, ImageView<std::uint8_t> out,
           SliceScratch& scratch) {
  sliceClipped(quality, source, imageToVoxel, wholeImage(out), {0, out.height}, out, scratch);
}

void slice(Quality quality, const SliceSource& source, const ImageToVoxel& imageToVoxel, std::span<const std::vector<RowSpan>> spans,
           ImageView<std::uint8_t> out, SliceScratch& scratch) {
  sliceBand(quality, source, imageToVoxel, spans, 0, out.height, out, scratch);
}

void sliceBand(Quality quality, const SliceSource& source, const ImageToVoxel& imageToVoxel, std::span<const std::vector<RowSpan>> spans,
               int firstRow, int rowCount, ImageView<std::uint8_t> out, SliceScratch& scratch) {
  EW_EXPECTS(spans.size() == static_cast<std::size_t>(out.height));
  EW_EXPECTS(firstRow >= 0 && rowCount >= 0 && rowCount <= out.height - firstRow);
  sliceClipped(quality, source, imageToVoxel, {spans, {}}, {firstRow, firstRow + rowCount}, out, scratch);
}

void sampleRows(Quality quality, const SliceSource& source, std::span<const SampleRow> rows, ImageView<std::uint8_t> out,
                SliceScratch& scratch) {
  if (source.frames != nullptr) {
    for (const SampleRow& row : rows) {
      EW_EXPECTS(row.row >= 0 && row.row < out.height && row.span.begin >= 0 && row.span.end <= out.width);
      source.frames->sampleRow(quality, row.start_voxel, row.step_voxel, row.span, out.row(row.row));
    }
    return;
  }
  int width = 0;
  for (const SampleRow& row : rows) width = std::max(width, row.span.end);
  const SliceSource chosen = source.inLayoutFor(classOf(quality, rows));
  RowSampler sampler(quality);
  TemplateLine line;
  for (const SampleRow& row : rows) {
    EW_EXPECTS(row.row >= 0 && row.row < out.height && row.span.begin >= 0 && row.span.end <= out.width);
    // The lines of a linear array share their step, and so their template.
    if (line.empty || line.step_voxel != row.step_voxel) line = detail::layTemplate(chosen, row.step_voxel, width, scratch);
    sampler.sample(line, row.start_voxel, row.span, out.row(row.row));
  }
  sampler.finish();
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
