#include "live_echoes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "effects/spread_bits.h"
#include "ew/imaging/effects/noise.h"
#include "line_kernels.h"
#include "pairs.h"

namespace ew::detail {
namespace {

constexpr double kHazeReach_mm = 8.0;
constexpr int kLobesOnASide = 4;
constexpr double kNoHaze_db = -80.0;
constexpr int kParts = 3;  // of a piece: left, right, between

}  // namespace

void LiveEchoes::configure(const Probe& probe, const Knobs& knobs, const Scene& scene, const EchoBeams& beams, const BeamGrid& grid,
                           double look_rad) {
  const LiveEchoesEffect effect = scene.liveEchoes.value_or(LiveEchoesEffect{});
  carrier_hz_ = knobs.carrier_hz;
  layout_ = echoLayoutOf(probe, knobs, effect, beams, grid, look_rad);
  stride_ = std::ptrdiff_t{2} * layout_.tiles * kTileColumns;
  field_.assign(static_cast<std::size_t>(stride_) * layout_.grid.lines.size(), 0.0F);
  fineStride_ = stride_ + 2;  // scatterers are shared by two columns
  fine_.assign(static_cast<std::size_t>(fineStride_) * static_cast<std::size_t>(layout_.rows), 0);
  surfaces_.configure(layout_);
  losses_.configure(layout_, probe, scene, knobs.carrier_hz);
  reverberation_.configure(layout_, scene);
  reduction_.configure(layout_);
  motion_.configure(layout_);
  noiseOf_.reset();
  layHaze(effect.haze_db);
}

/// Side lobes: a few lines on both sides, turned so that they do not add up in step.
void LiveEchoes::layHaze(double haze_db) {
  lobes_.clear();
  if (!(haze_db > kNoHaze_db)) return;
  const double each = std::sqrt(std::pow(10.0, 0.1 * haze_db) / (2 * kLobesOnASide));
  for (int n = 1; n <= kLobesOnASide; ++n)
    for (const int side : {-1, 1}) {
      Lobe& lobe = lobes_.emplace_back(Lobe{static_cast<float>(each), (n + (side > 0 ? 2 : 0)) % 4, {}});
      for (int tile = 0; tile < layout_.tiles; ++tile) {
        const double depth_mm = std::clamp(layout_.depthOfColumn_mm((tile + 0.5) * kTileColumns), 0.0, layout_.depth_mm);
        const double spacing_mm = std::max(layout_.grid.lineSpacing_mm(depth_mm), 1e-3);
        lobe.offset.push_back(side * std::max(n, static_cast<int>(std::lround(kHazeReach_mm * n / kLobesOnASide / spacing_mm))));
      }
    }
}

void LiveEchoes::move(const TissueMotion* motion, const BodyState& body, double strength,
                      const Transform<frame::Probe, frame::World>& motionToProbe, const SliceSource* giving,
                      const Transform<frame::Voxel, frame::Probe>& probeToGiving, Bands& bands) {
  motion_.rest();
  if (motion != nullptr && !(body == BodyState{}) && strength > 0.0) motion_.take(*motion, body, strength, motionToProbe);
  if (giving != nullptr) motion_.press(layout_, *giving, probeToGiving);
  motion_.find(layout_, bands);
}

void LiveEchoes::scatter(const TissueMaps& maps, std::uint64_t version, const Grid& placed,
                         const Transform<frame::World, frame::Probe>& probeToWorld, Bands& bands) {
  const Transform<frame::Voxel, frame::Probe> probeToVoxel = placed.worldToVoxel() * probeToWorld;
  const SliceSource level(VolumeView<const std::uint8_t>{maps.level.data(), placed});
  scratch_.resize(static_cast<std::size_t>(bands.threads()));
  noiseKey_.reset();
  ScatterPlaces places{.scatterers = echoPlaceOf(layout_.pitch_mm, level.grid, probeToVoxel),
                       .fragments = echoPlaceOf(kFragmentCell_mm / kBlockCells, level.grid, probeToVoxel),
                       .level = level,
                       .task = {}};
  places.fragments.beside_mm = kMostFragment_mm;
  ScatterTask& task = places.task;
  task = scatterTaskOf(layout_, places.scatterers, level);
  task.field = fine_.data();
  task.stride = static_cast<std::int32_t>(fineStride_);
  stores_.resize(static_cast<std::size_t>(kParts * piecesOf(layout_)));
  if (version == 0 || version != storesOf_ || !task.hasSameScatterers(storedTask_))
    for (ScattererStore& store : stores_) store.forget();
  storesOf_ = version;
  storedTask_ = task;
  // Every other piece, then those between: two threads never add to the same place. Deep ones, which hold most, come first, and all of
  // the left before all of the right, so that a thread stays on its side.
  const int pieces = piecesOf(layout_);
  const bool isHalved = bands.threads() > 1 && hasSides(layout_);
  const auto pieceOf = [&](int odd, int n) { return 2 * ((pieces + 1 - odd) / 2 - 1 - n) + odd; };
  for (const int odd : {0, 1}) {
    const int count = (pieces + 1 - odd) / 2;
    if (isHalved)
      bands.runEach(2 * count, [&](int n, int slot) {
        addPiece(places, pieceOf(odd, n % count), n < count ? PartOfPiece::left : PartOfPiece::right, slot);
      });
  }
  for (const int odd : {0, 1})
    bands.runEach((pieces + 1 - odd) / 2, [&](int n, int slot) {
      // A deep one and a shallow one in turn, so that shares are alike.
      const int last = (pieces + 1 - odd) / 2 - 1, turned = n % 2 == 0 ? n / 2 : last - n / 2;
      addPiece(places, pieceOf(odd, turned), isHalved ? PartOfPiece::between : PartOfPiece::all, slot);
    });
  if (!maps.surfaces.empty() && !maps.surfaceDistance.empty()) surfaces_.add(maps, probeToVoxel, motion_, bands, fine_.data(), fineStride_);
  filter(bands);
}

void LiveEchoes::addPiece(const ScatterPlaces& places, int piece, PartOfPiece part, int slot) {
  Scratch& mine = scratch_[static_cast<std::size_t>(slot)];
  const int own = part == PartOfPiece::between ? 2 : part == PartOfPiece::right ? 1 : 0;
  findBlocks(layout_, places.scatterers, motion_, places.level.grid.dims, piece, part, mine.shifts, mine.blocks);
  addScatterers(places.task, mine.blocks, stores_[static_cast<std::size_t>(kParts * piece + own)]);
  if (!(layout_.effect.fragmentsPerCm3 > 0.0)) return;
  findBlocks(layout_, places.fragments, motion_, places.level.grid.dims, piece, part, mine.shifts, mine.blocks);
  surfaces_.addFragments(places.level, places.fragments, mine.blocks, reachedFrom(layout_, piece), fine_.data(), fineStride_);
}

LiveEchoes::Rows LiveEchoes::rowsAbout(int line, int tile) const {
  const int reach = layout_.reachOfTile[static_cast<std::size_t>(tile)], row = layout_.rowPadding + line * layout_.rowsPerLine;
  return {row - reach, std::max(row - reach, row - layout_.rowsPerLine + reach + 1)};
}

/// Lines in as many parts as there are threads, each part tile after tile.
void LiveEchoes::filter(Bands& bands) {
  const int lines = static_cast<int>(layout_.grid.lines.size()), parts = std::min(bands.threads(), lines);
  bands.runEach(parts * layout_.tiles, [&](int n, int) { filterTile(n % layout_.tiles, n / layout_.tiles, parts); });
  if (parts == 1) return;
  // What two parts asked is empty for the next frame when both are done.
  bands.runEach(layout_.tiles, [&](int tile, int) {
    const LateralTask lateral = lateralOf(tile);
    for (int part = 1; part < parts; ++part) {
      const Rows about = rowsAbout(lines * part / parts, tile);
      for (int row = about.begin; row < about.end; ++row) std::fill_n(lateral.tile + row * lateral.stride, lateral.cleared, 0);
    }
  });
}

LateralTask LiveEchoes::lateralOf(int tile) {
  const std::ptrdiff_t firstValue = std::ptrdiff_t{2} * tile * kTileColumns;
  LateralTask lateral;
  lateral.tile = fine_.data() + firstValue;
  lateral.stride = fineStride_;
  lateral.width = 2 * kTileColumns;
  lateral.cleared = static_cast<int>(tile + 1 == layout_.tiles ? fineStride_ - firstValue : lateral.width);
  lateral.unit = static_cast<float>(kDepositUnit);
  lateral.weights = layout_.lateral[static_cast<std::size_t>(tile)].data();
  lateral.reach = layout_.reachOfTile[static_cast<std::size_t>(tile)];
  lateral.firstRow = layout_.rowPadding;
  lateral.rowsPerLine = layout_.rowsPerLine;
  lateral.out = field_.data() + firstValue;
  lateral.outStride = stride_;
  return lateral;
}

void LiveEchoes::filterTile(int tile, int part, int parts) {
  const int lines = static_cast<int>(layout_.grid.lines.size());
  LateralTask lateral = lateralOf(tile);
  lateral.beginLine = lines * part / parts;
  lateral.endLine = lines * (part + 1) / parts;
  lateral.beginCleared = part == 0 ? 0 : rowsAbout(lateral.beginLine, tile).end;
  lateral.endCleared = part + 1 == parts ? layout_.rows : rowsAbout(lateral.endLine, tile).begin;
  filterLaterally(lateral);
}

void LiveEchoes::lose(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, const SliceSource& level,
                      const Transform<frame::Voxel, frame::Probe>& probeToLevel, Bands& bands) {
  losses_.walk(labels, probeToLabel, level, probeToLevel, motion_, bands);
  bands.run(static_cast<int>(layout_.grid.lines.size()), [&](int first, int count, int slot) {
    Scratch& mine = scratch_[static_cast<std::size_t>(slot)];
    for (int line = first; line < first + count; ++line) scaleComplex(losses_.gainOf(line, mine.gains), layout_.columns, lineAt(line));
  });
}

void LiveEchoes::reverberate(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, Bands& bands) {
  reverberation_.find(labels, probeToLabel, motion_, bands);
  bands.run(static_cast<int>(layout_.grid.lines.size()), [&](int first, int count, int slot) {
    EchoReverberation::Scratch& mine = scratch_[static_cast<std::size_t>(slot)].reverberation;
    for (int line = first; line < first + count; ++line)
      reverberation_.add(line, {lineAt(line), 2 * static_cast<std::size_t>(layout_.columns)}, mine);
  });
}

void LiveEchoes::addNoise(const NoiseEffect& noise, std::uint64_t frameNumber, Bands&) {
  if (noiseOf_ != noise) {
    noiseOf_ = noise;
    noise_.resize(static_cast<std::size_t>(layout_.columns));
    for (int column = 0; column < layout_.columns; ++column) {
      const double level_db = noiseLevel_db(noise, carrier_hz_, std::max(layout_.depthOfColumn_mm(column), 0.0));
      // The pulse's filter has the power 1 / spacing.
      noise_[static_cast<std::size_t>(column)] =
          static_cast<float>(std::sqrt(0.5 * std::pow(10.0, 0.1 * level_db) * layout_.grid.sampleSpacing_mm));
    }
  }
  noiseKey_ = spreadBits(frameNumber + 0x9e3779b97f4a7c15ULL);
}

void LiveEchoes::addHaze(int line, std::span<float> out) {
  static_assert(2 * kLobesOnASide <= kMostQuarterTurnRows);
  const auto lines = static_cast<int>(layout_.grid.lines.size());
  std::array<QuarterTurnRow, kMostQuarterTurnRows> rows;
  for (int tile = 0; tile < layout_.tiles; ++tile) {
    const int first = tile * kTileColumns, count = std::min(kTileColumns, layout_.columns - first);
    int seen = 0;
    for (const Lobe& lobe : lobes_) {
      const int other = line + lobe.offset[static_cast<std::size_t>(tile)];
      if (other < 0 || other >= lines) continue;
      rows[static_cast<std::size_t>(seen++)] = {pairAt(lineAt(other), first), lobe.weight, lobe.quarter};
    }
    if (seen > 0) addTurned(rows.data(), seen, count, pairAt(out.data(), first));
  }
}

void LiveEchoes::takeEnvelope(double greyPerDb, Bands& bands, ImageView<float> echoes) {
  const int samples = layout_.grid.samples;
  const auto perDoubling = static_cast<float>(20.0 * std::log10(2.0) * greyPerDb);
  constexpr int kGroup = 16;  // lines that are written side by side
  const EnvelopeTask pulse{layout_.pulse.data(), static_cast<int>(layout_.pulse.size()) - 1, layout_.middleShare, layout_.lookPairs};
  bands.runEach((echoes.width + kGroup - 1) / kGroup, [&](int group, int slot) {
    Scratch& mine = scratch_[static_cast<std::size_t>(slot)];
    mine.line.resize(std::max(mine.line.size(), 2 * static_cast<std::size_t>(layout_.columns)));
    mine.levels.resize(static_cast<std::size_t>(kGroup) * static_cast<std::size_t>(samples));
    const int first = kGroup * group, count = std::min(kGroup, echoes.width - first);
    for (int n = 0; n < count; ++n) {
      const float* own = lineAt(first + n);
      std::copy(own, pairAt(own, layout_.columns), mine.line.begin());
      addHaze(first + n, mine.line);
      if (noiseKey_) {
        const std::uint64_t key = spreadBits(*noiseKey_ + static_cast<std::uint64_t>(first + n) * 0x9e3779b97f4a7c15ULL);
        addComplexNoise(key, noise_.data(), layout_.columns, mine.line.data());
      }
      envelopeOf(pulse, pairAt(mine.line.data(), layout_.columnPadding), samples,
                 mine.levels.data() + static_cast<std::ptrdiff_t>(n) * samples);
    }
    for (int s = 0; s < samples; ++s) {
      float* row = echoes.row(s) + first;
      for (int n = 0; n < count; ++n) row[n] = mine.levels[static_cast<std::size_t>(n * samples + s)];
    }
  });

  const auto aside = static_cast<float>(layout_.effect.lineAverage);
  bands.run(samples, [&](int first, int count, int slot) {
    std::vector<float>& around = scratch_[static_cast<std::size_t>(slot)].gains;
    around.resize(std::max(around.size(), static_cast<std::size_t>(echoes.width + 2)));
    for (int s = first; s < first + count; ++s) {
      float* row = echoes.row(s);
      std::copy(row, row + echoes.width, around.begin() + 1);
      around.front() = row[0];
      around[static_cast<std::size_t>(echoes.width) + 1] = row[echoes.width - 1];
      toLevels(around.data() + 1, aside, perDoubling, echoes.width, row);
    }
  });
  reduction_.run(greyPerDb, bands, echoes);
}

}  // namespace ew::detail
