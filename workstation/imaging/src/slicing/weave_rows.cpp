#include <algorithm>
#include <array>

#include "piece_pipeline.h"

namespace ew::detail {
namespace {

template <class Offset>
struct Nearest {
  static constexpr bool kBlends = false;
  static void announce(const TemplateLine& line, const Piece<Offset>& piece) {
    for (std::size_t n = 0; n < piece.count; ++n) prefetch(line.voxels + piece.offset[n]);
  }
  static void sample(const TemplateLine& line, const Piece<Offset>& piece) {
    for (std::size_t n = 0; n < piece.count; ++n) piece.out[n] = line.voxels[piece.offset[n]];
  }
};

template <class Offset>
void weaveRows(const TemplateLine& line, const SliceScratch& scratch, const std::vector<Offset>& templateOffset, int firstRow,
               const Clipping& clipping, ImageView<std::uint8_t> out) {
  FixedPosition highest{};
  for (std::size_t a = 0; a < 3; ++a) highest[a] = static_cast<std::int64_t>(line.dims[static_cast<int>(a)]) * kOneVoxel - 1;
  PiecePipeline<Offset, Nearest<Offset>> pipeline(line, scratch, templateOffset);
  for (int y = 0; y < out.height; ++y) {
    FixedPosition base = line.base(firstRow + y);
    for (std::int64_t& b : base) b += kHalfVoxel;  // the integer part is then the nearest voxel
    std::uint8_t* row = out.row(y);
    for (const RowSpan& within : clipping.of(y)) {
      RowSpan run = clipRow(line, scratch, base, within, {0, 0, 0}, highest);
      if (run.begin == run.end) run = {within.begin, within.begin};
      std::fill(row + within.begin, row + run.begin, std::uint8_t{0});
      pipeline.push(base, run, row);
      std::fill(row + run.end, row + within.end, std::uint8_t{0});
    }
  }
  pipeline.finish();
}

}  // namespace

void weaveRows(const TemplateLine& line, const SliceScratch& scratch, int firstRow, const Clipping& clipping, ImageView<std::uint8_t> out) {
  if (line.needsLongOffsets)
    weaveRows(line, scratch, scratch.longTemplateOffset, firstRow, clipping, out);
  else
    weaveRows(line, scratch, scratch.templateOffset, firstRow, clipping, out);
}

}  // namespace ew::detail
