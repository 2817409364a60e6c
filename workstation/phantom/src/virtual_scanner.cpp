#include "ew/phantom/virtual_scanner.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "anatomy.h"
#include "beams.h"
#include "ew/core/contract.h"
#include "ew/core/numbers.h"
#include "ew/phantom/speckle.h"
#include "formation_kernels.h"
#include "scatterers.h"

namespace ew {

VirtualScanner::~VirtualScanner() = default;
VirtualScanner::Scratch::~Scratch() = default;

namespace {

using phantom::Beams;
using phantom::PointBatch;
using phantom::ScattererBlock;
using phantom::ScattererField;

constexpr std::size_t kCacheBytes = 400u << 20;
constexpr std::size_t kBlocksPerQuestion = 16;
constexpr double kSamplesPerPulse = 4.0;   // within the full width at half maximum
constexpr double kSamplesPerLook = 6.0;    // the same with several looks: their carriers lie off the middle
constexpr double kRowsPerSigma = 2.0;      // of the fine grid, at the narrowest place of the beam
constexpr double kLateralReach = 3.0;      // standard deviations
constexpr double kElevationalReach = 2.2;  // standard deviations: what is left out has less than a hundredth of the power
constexpr int kMostPadding = 64;           // rows beside the fan
constexpr double kScatterersPerResolutionCell = 3.5;
constexpr double kRowStepPerPitch = 0.7;  // of the walk along a line that sums up losses
constexpr double kLagPerPitch = 0.9;      // losses begin this much deeper, so that a surface does not shadow its own echo
constexpr double kGelGap_mm = 4.0;        // between face and skin, filled with gel
constexpr double kAir_db = 60.0;          // lost where the line leaves the body, or never meets it
constexpr double kAirPerGap_dbPerMm = 15.0;
constexpr double kSameThing_mm = 3.0;  // a line that comes back so soon meets no second surface
constexpr double kRing_db = -8.0;      // of the transmit pulse at the face
constexpr double kRingFall_db = 34.0;  // over the near field
constexpr double kNoNoise_db = -200.0;
constexpr std::size_t kChunk = 32;  // columns whose lateral width is taken as one

struct Fan {
  bool sector = false;
  double apex_mm = 0.0;
  double halfAngle_rad = 0.0;
  double halfWidth_mm = 0.0;
  double depth_mm = 0.0;
};

class Scanner;

struct FrameScratch final : VirtualScanner::Scratch {
  std::vector<float> fine;  ///< rows x columns complex numbers, and two that take what misses
  std::vector<float> line;  ///< columns complex numbers
  std::vector<float> turned;
  std::vector<float> pulsed;
  std::vector<float> gain;  ///< lines x steps
  std::vector<float> smooth;
  std::vector<float> delay_mm;
  std::vector<glm::dvec3> restOnLines;
  struct Block {
    std::shared_ptr<const ScattererBlock> made;
    glm::ivec3 index{0};
  };
  std::vector<Block> blocks;
  std::vector<std::int32_t> blockAt;  ///< of a box of blocks: number in `blocks`, or -1
  glm::ivec3 boxFirst{0}, boxSize{0};
  std::vector<glm::dvec3> corners;  ///< of that box, moved; x is not a number where nobody asked yet
  std::vector<float> facetX, facetY, facetZ;
  PointBatch batch;
};

/// Of an amplitude.
double factorOf(double loss_db) { return std::pow(10.0, -0.05 * loss_db); }

double gainAt(const std::vector<DepthGain>& curve, double depth_mm) {
  const auto after = std::find_if(curve.begin(), curve.end(), [&](const DepthGain& g) { return g.depth_mm > depth_mm; });
  if (after == curve.begin()) return after->gain_db;
  const DepthGain& from = *(after - 1);
  if (after == curve.end()) return from.gain_db;
  return from.gain_db + (after->gain_db - from.gain_db) * (depth_mm - from.depth_mm) / (after->depth_mm - from.depth_mm);
}

class Scanner final : public VirtualScanner {
 public:
  Scanner(std::shared_ptr<const Patient> patient, const Probe& probe, const FormationOptions& options, BeamGrid grid, double pitch_mm,
          std::uint64_t seed)
      : patient_(patient),
        probe_(probe),
        options_(options),
        grid_(std::move(grid)),
        beams_(phantom::beamsOf(probe, options)),
        field_(std::move(patient), pitch_mm, seed, kCacheBytes) {
    layOutGrid();
    layOutLooks();
    layOutBeams();
    layOutGains();
  }

  const FormationOptions& options() const override { return options_; }
  const Probe& probe() const override { return probe_; }
  const BeamGrid& grid() const override { return grid_; }
  PointSpread pointSpreadAt(double depth_mm) const override {
    return {phantom::kFwhmOfSigma * beams_.axialSigma_mm, phantom::kFwhmOfSigma * beams_.lateralSigma_mm(depth_mm),
            phantom::kFwhmOfSigma * beams_.elevationalSigma_mm(depth_mm)};
  }
  std::unique_ptr<Scratch> makeScratch() const override { return std::make_unique<FrameScratch>(); }

  void envelope(const Transform<frame::World, frame::Probe>& probeToWorld, const Deformation& deformation, std::uint64_t frame,
                Scratch& scratch, Image<float>& envelope) const override {
    auto& work = static_cast<FrameScratch&>(scratch);
    const View view{probeToWorld, inverse(probeToWorld), deformation, deformation.reach_mm() > 0.0};
    envelope = {};
    if (!findBlocks(view, work)) return;
    walkLines(view, work);
    work.fine.assign(2 * (static_cast<std::size_t>(gridding_.rows) * columns_ + 2), 0.0F);
    for (const FrameScratch::Block& block : work.blocks) addBlock(view, block, work);
    formLines(frame, work, envelope);
  }

 private:
  struct View {
    Transform<frame::World, frame::Probe> probeToWorld;
    Transform<frame::Probe, frame::World> worldToProbe;
    const Deformation& deformation;
    bool deforms;
    [[nodiscard]] glm::dvec3 toProbe(const glm::dvec3& world) const { return (worldToProbe * Point<frame::World>{world}).at; }
    [[nodiscard]] glm::dvec3 toWorld(const glm::dvec3& probe) const { return (probeToWorld * Point<frame::Probe>{probe}).at; }
  };

  void layOutGrid() {
    const auto lines = static_cast<int>(grid_.lines.size());
    fan_.sector = isSector(probe_.kind);
    fan_.apex_mm = fan_.sector ? probe_.radius_mm : 0.0;
    fan_.halfAngle_rad = probe_.halfAngle_rad;
    fan_.halfWidth_mm = grid_.lines.back().origin_mm.x;
    fan_.depth_mm = grid_.depth_mm(grid_.samples - 1);

    double finest = std::numeric_limits<double>::infinity();  // standard deviation in lines
    for (int s = 0; s < grid_.samples; s += 8)
      finest = std::min(finest, beams_.lateralSigma_mm(grid_.depth_mm(s)) / grid_.lineSpacing_mm(grid_.depth_mm(s)));
    rowsPerLine_ = std::clamp(static_cast<int>(std::ceil(kRowsPerSigma / finest)), 1, 16);
    double widest = 1.0;  // reach in rows
    for (int s = 0; s < grid_.samples; ++s) widest = std::max(widest, kLateralReach * rowSigma(grid_.depth_mm(s)));
    rowPadding_ = static_cast<int>(std::ceil(std::min<double>(widest, kMostPadding)));
    columnPadding_ = static_cast<int>(std::ceil(4.0 * beams_.axialSigma_mm / grid_.sampleSpacing_mm)) + 2;
    columns_ = static_cast<std::size_t>(grid_.samples + 2 * columnPadding_);

    gridding_.sector = fan_.sector;
    gridding_.apex_mm = static_cast<float>(fan_.apex_mm);
    const double across = fan_.sector ? 2.0 * fan_.halfAngle_rad : 2.0 * fan_.halfWidth_mm;
    gridding_.rows = (lines - 1) * rowsPerLine_ + 1 + 2 * rowPadding_;
    gridding_.columns = static_cast<std::int32_t>(columns_);
    gridding_.rowsPerUnit = static_cast<float>((lines - 1) * rowsPerLine_ / across);
    gridding_.middleRow = static_cast<float>(rowPadding_ + 0.5 * (lines - 1) * rowsPerLine_);
    gridding_.columnsPerMm = static_cast<float>(1.0 / grid_.sampleSpacing_mm);
    gridding_.firstColumn = static_cast<float>(columnPadding_);
    gridding_.turnsPerMm = static_cast<float>(2.0 / beams_.wavelength_mm);
    gridding_.lensFocus_mm = static_cast<float>(beams_.lensFocus_mm);
    gridding_.nearPerMm = static_cast<float>(1.0 / beams_.lensNearRange_mm);
    gridding_.farPerMm = static_cast<float>(1.0 / beams_.lensFarRange_mm);
    gridding_.waistPerMm2 = static_cast<float>(0.5 / (beams_.lensWaist_mm * beams_.lensWaist_mm));
    gridding_.weight = static_cast<float>(1.0 / std::sqrt(beams_.lensWaist_mm * std::sqrt(std::numbers::pi)));
    gridding_.cut = static_cast<float>(0.5 * kElevationalReach * kElevationalReach);
  }

  [[nodiscard]] double rowSpacing_mm(double depth_mm) const { return grid_.lineSpacing_mm(depth_mm) / rowsPerLine_; }
  /// Of the lateral beam, in rows.
  [[nodiscard]] double rowSigma(double depth_mm) const {
    return beams_.lateralSigma_mm(depth_mm) / std::max(rowSpacing_mm(depth_mm), 1e-6);
  }

  void layOutBeams() {
    lateral_.assign(static_cast<std::size_t>(rowPadding_ + 1), std::vector<float>(2 * columns_, 0.0F));
    reachOfChunk_.assign((columns_ + kChunk - 1) / kChunk, 0);
    mirrorScale_.resize(columns_);
    for (std::size_t column = 0; column < columns_; ++column) {
      const double depth = std::clamp((static_cast<double>(column) - columnPadding_) * grid_.sampleSpacing_mm, 0.0, fan_.depth_mm);
      const double sigma = rowSigma(depth);
      const int reach = std::clamp(static_cast<int>(std::ceil(kLateralReach * sigma)), 1, rowPadding_);
      int& reachOfChunk = reachOfChunk_[column / kChunk];
      reachOfChunk = std::max(reachOfChunk, reach);
      double power = 0.0;
      for (int t = -reach; t <= reach; ++t) power += std::exp(-(t * t) / (sigma * sigma));
      const double strength = 1.0 / std::sqrt(power * std::max(rowSpacing_mm(depth), 1e-6));
      for (int t = 0; t <= reach; ++t) {
        const auto weight = static_cast<float>(strength * std::exp(-0.5 * t * t / (sigma * sigma)));
        lateral_[static_cast<std::size_t>(t)][2 * column] = weight;
        lateral_[static_cast<std::size_t>(t)][2 * column + 1] = weight;
      }
      mirrorScale_[column] = static_cast<float>(1.0 / (planeEcho(depth) * lookScale_));
    }
    // Points are shared by two columns; that adds a sixth of a step's square to the variance, which the pulse leaves out.
    const double columns = beams_.axialSigma_mm / grid_.sampleSpacing_mm, sigma = std::sqrt(columns * columns - 1.0 / 6.0);
    const int reach = columnPadding_ - 1;
    double power = 0.0;
    for (int t = -reach; t <= reach; ++t) power += std::exp(-(t * t) / (sigma * sigma));
    for (int t = 0; t <= reach; ++t)
      pulse_.push_back(static_cast<float>(std::exp(-0.5 * t * t / (sigma * sigma)) / std::sqrt(power * grid_.sampleSpacing_mm)));
  }

  /// What a plane mirror square to the beam returns: the integrals of the lateral and elevational beams and the pulse's peak, where the
  /// squares of all three have the integral 1. The lens' wavefront is curved, so its integral is Fresnel's.
  [[nodiscard]] double planeEcho(double depth_mm) const {
    const double rootPi = std::sqrt(std::numbers::pi);
    const double lateral = std::sqrt(2.0 * rootPi * beams_.lateralSigma_mm(depth_mm));
    const double sigma = beams_.elevationalSigma_mm(depth_mm);
    const double bend = 4.0 * std::numbers::pi / beams_.wavelength_mm * beams_.elevationalCurvature_perMm(depth_mm);
    const double elevational = rootPi / std::sqrt(sigma * rootPi) / std::pow(0.25 / std::pow(sigma, 4) + bend * bend, 0.25);
    return lateral * elevational / std::sqrt(beams_.axialSigma_mm * rootPi);
  }

  void layOutLooks() {
    const int looks = options_.looks;
    for (int look = 0; look < looks; ++look) {
      const double step = (look - 0.5 * (looks - 1)) * beams_.lookStep_radPerMm() * grid_.sampleSpacing_mm;
      std::vector<float>& turn = turns_.emplace_back();
      for (std::size_t column = 0; column < columns_; ++column) {
        turn.push_back(static_cast<float>(std::cos(step * static_cast<double>(column))));
        turn.push_back(static_cast<float>(-std::sin(step * static_cast<double>(column))));
      }
    }
    if (looks == 1) return;
    // The mean of the logarithm rises with the number of looks: their averaged amplitude has the mean sqrt(pi) / 2 and the squared
    // coefficient of variation 4 / pi - 1 over the independent looks among them. Scaled back to that of a single look, so that a tissue
    // keeps its level.
    const double independent = looks * looks / (looks + 2.0 * (looks - 1) * std::exp(-2.0));
    const double mean_db = 10.0 * std::log10(0.25 * std::numbers::pi) - 0.5 * 8.685889638 * (4.0 / std::numbers::pi - 1.0) / independent;
    lookScale_ = factorOf(mean_db + 2.507);
  }

  void layOutGains() {
    for (int s = 0; s < grid_.samples; ++s) {
      const double gain_db = gainAt(options_.tgc, grid_.depth_mm(s)) + options_.gain_db;
      depthGain_.push_back(static_cast<float>(std::pow(10.0, 0.05 * gain_db)));
      double ring = 0.0;
      if (probe_.nearField_mm > 0.0) {
        const double t = grid_.depth_mm(s) / probe_.nearField_mm;
        const double beat = 0.6 + 0.4 * std::cos(2.0 * std::numbers::pi * grid_.depth_mm(s) / (1.7 * beams_.wavelength_mm));
        ring = beat * std::pow(10.0, 0.05 * (kRing_db - kRingFall_db * t));
      }
      ring_.push_back(static_cast<float>(ring > 1e-5 ? ring : 0.0));
    }
    step_mm_ = kRowStepPerPitch * field_.pitch_mm();
    steps_ = static_cast<int>(std::ceil(fan_.depth_mm / step_mm_)) + 1;
    step_mm_ = fan_.depth_mm / (steps_ - 1);
    for (const Tissue& tissue : patient_->tissues) {
      keptPerStep_.push_back(factorOf(2.0 * tissue.attenuation_dbPerCmMhz * options_.carrier_hz * 1e-6 * step_mm_ * 0.1));
      keptAtSurface_.push_back(factorOf(tissue.reflection_db));
      delayPerStep_mm_.push_back((options_.assumedSpeed_mPerS / tissue.speed_mPerS - 1.0) * step_mm_);
    }
  }

  [[nodiscard]] double reach_mm(double depth_mm) const {
    return kElevationalReach * beams_.elevationalSigma_mm(std::clamp(depth_mm, 0.0, fan_.depth_mm));
  }
  [[nodiscard]] double reachBetween_mm(double nearer_mm, double farther_mm) const {
    return std::max(reach_mm(nearer_mm), reach_mm(farther_mm));  // narrowest in the focus, wider to both sides
  }

  /// Whether a ball in the probe frame may touch what the beams see.
  [[nodiscard]] bool seen(const glm::dvec3& centre, double radius) const {
    double depth = centre.y, beside = std::abs(centre.x) - fan_.halfWidth_mm;
    if (fan_.sector) {
      const double x = centre.x, y = centre.y + fan_.apex_mm, rho = std::sqrt(x * x + y * y);
      depth = rho - fan_.apex_mm;
      const double over = std::abs(std::atan2(x, y)) - fan_.halfAngle_rad;
      beside = over <= 0.0 ? 0.0 : (over < 0.5 * std::numbers::pi ? rho * std::sin(over) : rho);
    }
    const double delay = options_.speedOfSound ? 0.1 * fan_.depth_mm : 0.0;
    if (depth < -radius - 1.0 || depth > fan_.depth_mm + radius + 1.0 + delay) return false;
    const double clamped = std::clamp(depth, 0.0, fan_.depth_mm);
    if (beside > radius + kLateralReach * beams_.lateralSigma_mm(clamped)) return false;
    return std::abs(centre.z) < radius + reachBetween_mm(depth - radius, depth + radius);
  }

  /// The blocks that the slice meets; one that nobody met before is filled, which takes its time.
  /// @return false when the work was stopped
  bool findBlocks(const View& view, FrameScratch& work) const {
    const double size = field_.blockSize_mm();
    const double slack = view.deforms ? view.deformation.reach_mm() : 0.0;
    const double widest = reachBetween_mm(0.0, fan_.depth_mm) + 1.0;
    glm::dvec3 lowest(std::numeric_limits<double>::infinity()), highest(-std::numeric_limits<double>::infinity());
    for (std::size_t n = 0; n < grid_.lines.size(); ++n) {
      for (int corner = 0; corner < 4; ++corner) {
        const BeamGrid::Line& line = grid_.lines[n];
        const glm::dvec2 at = line.origin_mm + line.direction * ((corner & 1) ? fan_.depth_mm + 1.0 : -1.0);
        const glm::dvec3 world = view.toWorld(glm::dvec3(at, (corner & 2) ? widest : -widest));
        lowest = glm::min(lowest, world);
        highest = glm::max(highest, world);
      }
    }
    const double margin = slack + size;
    work.boxFirst = glm::ivec3(glm::floor((lowest - margin) / size));
    work.boxSize = glm::ivec3(glm::floor((highest + margin) / size)) - work.boxFirst + 1;
    const auto count =
        static_cast<std::size_t>(work.boxSize.x) * static_cast<std::size_t>(work.boxSize.y) * static_cast<std::size_t>(work.boxSize.z);
    work.blockAt.assign(count, -1);
    work.blocks.clear();
    if (view.deforms) {
      const glm::ivec3 nodes = work.boxSize + 1;
      work.corners.assign(static_cast<std::size_t>(nodes.x) * static_cast<std::size_t>(nodes.y) * static_cast<std::size_t>(nodes.z),
                          glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
    }
    // A deformed block may be larger than it rests; its facets lie a little outside it.
    const double radius = std::sqrt(0.75) * size * (view.deforms ? 1.2 : 1.0) + field_.overhang_mm();
    std::size_t at = 0;
    for (int k = 0; k < work.boxSize.z; ++k)
      for (int j = 0; j < work.boxSize.y; ++j)
        for (int i = 0; i < work.boxSize.x; ++i, ++at) {
          const glm::ivec3 index = work.boxFirst + glm::ivec3(i, j, k);
          const glm::dvec3 centre = size * (glm::dvec3(index) + 0.5);
          if (!seen(view.toProbe(centre), radius + slack)) continue;
          if (view.deforms && !seen(view.toProbe(view.deformation.moved(centre)), radius)) continue;
          work.blockAt[at] = static_cast<std::int32_t>(work.blocks.size());
          work.blocks.push_back({field_.block(index), index});
          if (work.blocks.size() % kBlocksPerQuestion == 0 && work.stopped && work.stopped()) return false;
        }
    return true;
  }

  [[nodiscard]] const ScattererBlock* blockOf(const glm::ivec3& index, const FrameScratch& work) const {
    const glm::ivec3 at = index - work.boxFirst;
    if (at.x < 0 || at.y < 0 || at.z < 0 || at.x >= work.boxSize.x || at.y >= work.boxSize.y || at.z >= work.boxSize.z) return nullptr;
    const auto n =
        work.blockAt[(static_cast<std::size_t>(at.z) * static_cast<std::size_t>(work.boxSize.y) + static_cast<std::size_t>(at.y)) *
                         static_cast<std::size_t>(work.boxSize.x) +
                     static_cast<std::size_t>(at.x)];
    return n < 0 ? nullptr : work.blocks[static_cast<std::size_t>(n)].made.get();
  }

  [[nodiscard]] std::uint8_t tissueAt(const glm::dvec3& rest, const FrameScratch& work) const {
    const double perPitch = 1.0 / field_.pitch_mm();
    const glm::ivec3 cell(glm::floor(rest * perPitch));
    static_assert(ScattererBlock::kCells == 8);
    const glm::ivec3 index(cell.x >> 3, cell.y >> 3, cell.z >> 3);
    const ScattererBlock* block = blockOf(index, work);
    return block == nullptr ? ScattererBlock::kOutside : block->tissueAt(cell.x & 7, cell.y & 7, cell.z & 7);
  }

  /// Losses and delays along every line, in three planes across the slice.
  void walkLines(const View& view, FrameScratch& work) const {
    const std::size_t lines = grid_.lines.size(), steps = static_cast<std::size_t>(steps_);
    work.gain.assign(lines * steps, options_.attenuation ? 0.0F : 1.0F);
    work.delay_mm.assign(options_.speedOfSound ? lines * steps : 0, 0.0F);
    if (!options_.attenuation && !options_.speedOfSound) return;

    // Where a deformed body's lines lie at rest: exact every few steps and lines, straight in between.
    constexpr std::size_t kEveryLine = 8, kEveryStep = 8;
    const std::size_t coarseLines = (lines - 1) / kEveryLine + 2, coarseSteps = (steps - 1) / kEveryStep + 2;
    const auto pointOn = [&](std::size_t line, double depth) {
      const BeamGrid::Line& at = grid_.lines[line];
      return view.toWorld(glm::dvec3(at.origin_mm + at.direction * depth, 0.0));
    };
    if (view.deforms) {
      work.restOnLines.resize(coarseLines * coarseSteps);
      for (std::size_t l = 0; l < coarseLines; ++l)
        for (std::size_t s = 0; s < coarseSteps; ++s) {
          const glm::dvec3 world = pointOn(std::min(l * kEveryLine, lines - 1), static_cast<double>(s * kEveryStep) * step_mm_);
          work.restOnLines[l * coarseSteps + s] = view.deformation.rest(world) - world;
        }
    }
    const glm::dvec3 aside = (view.probeToWorld * Direction<frame::Probe>{{0.0, 0.0, 1.0}}).along;
    constexpr std::array<double, 3> kPlanes{0.0, -0.75, 0.75}, kWeights{0.5, 0.25, 0.25};
    for (std::size_t plane = 0; plane < kPlanes.size(); ++plane) {
      for (std::size_t l = 0; l < lines; ++l) {
        double left = 1.0, delay_mm = 0.0, gap_mm = 0.0;  // share of the amplitude that is left
        std::uint8_t last = ScattererBlock::kOutside, reflected = ScattererBlock::kOutside;
        double reflected_mm = -1e9;  // where the line last was in the tissue that reflected it
        bool entered = false;
        for (std::size_t s = 0; s < steps; ++s) {
          if (s > 0) {
            const double depth = (static_cast<double>(s) - 0.5) * step_mm_;
            glm::dvec3 at = pointOn(l, depth);
            if (view.deforms) {
              const std::size_t l0 = l / kEveryLine, s0 = s / kEveryStep;
              const double tl = static_cast<double>(l % kEveryLine) / kEveryLine;
              const double ts = static_cast<double>(s % kEveryStep) / kEveryStep;
              const glm::dvec3* near = &work.restOnLines[l0 * coarseSteps + s0];
              const glm::dvec3* far = near + coarseSteps;
              at += (1.0 - tl) * ((1.0 - ts) * near[0] + ts * near[1]) + tl * ((1.0 - ts) * far[0] + ts * far[1]);
            }
            at += aside * (kPlanes[plane] * beams_.elevationalSigma_mm(depth));
            const std::uint8_t tissue = tissueAt(at, work);
            if (tissue == ScattererBlock::kOutside) {
              if (entered) {
                left *= air_;
              } else {
                gap_mm = depth;
              }
            } else {
              if (!entered && gap_mm > kGelGap_mm) left *= factorOf(std::min((gap_mm - kGelGap_mm) * kAirPerGap_dbPerMm, kAir_db));
              entered = true;
              left *= keptPerStep_[tissue];
              delay_mm += delayPerStep_mm_[tissue];
              if (keptAtSurface_[tissue] < 1.0) {
                if (tissue != last && !(tissue == reflected && depth - reflected_mm < kSameThing_mm)) left *= keptAtSurface_[tissue];
                reflected = tissue;
                reflected_mm = depth;
              }
            }
            last = tissue;
          }
          const std::size_t at = l * steps + s;
          if (options_.attenuation) work.gain[at] += static_cast<float>(kWeights[plane] * left);
          if (options_.speedOfSound) work.delay_mm[at] += static_cast<float>(kWeights[plane] * delay_mm);
        }
      }
    }
    acrossLines(work.gain, work.smooth);
    if (options_.speedOfSound) acrossLines(work.delay_mm, work.smooth);
  }

  /// Beams are about a line wide: (1 2 1) / 4 across them.
  void acrossLines(std::vector<float>& values, std::vector<float>& smooth) const {
    const std::size_t steps = static_cast<std::size_t>(steps_), lines = values.size() / steps;
    smooth.resize(values.size());
    for (std::size_t l = 0; l < lines; ++l) {
      const float* before = values.data() + (l > 0 ? l - 1 : 0) * steps;
      const float* here = values.data() + l * steps;
      const float* after = values.data() + std::min(l + 1, lines - 1) * steps;
      for (std::size_t s = 0; s < steps; ++s) smooth[l * steps + s] = 0.25F * (before[s] + after[s]) + 0.5F * here[s];
    }
    values.swap(smooth);
  }

  [[nodiscard]] phantom::Trilinear motionOf(const View& view, const glm::ivec3& index, FrameScratch& work) const {
    const double size = field_.blockSize_mm();
    phantom::Trilinear to{};
    if (!view.deforms) {
      to[0] = glm::vec3(view.toProbe(size * glm::dvec3(index)));
      const glm::dmat4& m = view.worldToProbe.matrix;
      for (int axis = 0; axis < 3; ++axis) to[static_cast<std::size_t>(axis) + 1] = glm::vec3(m[axis]);
      return to;
    }
    std::array<glm::dvec3, 8> corner;
    for (int n = 0; n < 8; ++n) {
      const glm::ivec3 node = index + glm::ivec3(n & 1, (n >> 1) & 1, n >> 2) - work.boxFirst, nodes = work.boxSize + 1;
      glm::dvec3& kept =
          work.corners[(static_cast<std::size_t>(node.z) * static_cast<std::size_t>(nodes.y) + static_cast<std::size_t>(node.y)) *
                           static_cast<std::size_t>(nodes.x) +
                       static_cast<std::size_t>(node.x)];
      if (std::isnan(kept.x)) kept = view.toProbe(view.deformation.moved(size * glm::dvec3(node + work.boxFirst)));
      corner[static_cast<std::size_t>(n)] = kept;
    }
    const auto& c = corner;
    to[0] = glm::vec3(c[0]);
    to[1] = glm::vec3((c[1] - c[0]) / size);
    to[2] = glm::vec3((c[2] - c[0]) / size);
    to[3] = glm::vec3((c[4] - c[0]) / size);
    to[4] = glm::vec3((c[3] - c[2] - c[1] + c[0]) / (size * size));
    to[5] = glm::vec3((c[5] - c[4] - c[1] + c[0]) / (size * size));
    to[6] = glm::vec3((c[6] - c[4] - c[2] + c[0]) / (size * size));
    to[7] = glm::vec3((c[7] - c[6] - c[5] - c[3] + c[4] + c[2] + c[1] - c[0]) / (size * size * size));
    return to;
  }

  void addBlock(const View& view, const FrameScratch::Block& block, FrameScratch& work) const {
    const phantom::Trilinear to = motionOf(view, block.index, work);
    const ScattererBlock& made = *block.made;
    PointBatch& batch = work.batch;
    if (!made.x.empty()) {
      const std::size_t count = made.x.size();
      static_assert(ScattererBlock::kCells * ScattererBlock::kCells * ScattererBlock::kCells <= PointBatch::kMost);
      move(view, made.x.data(), made.y.data(), made.z.data(), count, to, batch);
      std::copy(made.amplitude.begin(), made.amplitude.end(), batch.amplitude.begin());
      addBatch(count, work);
    }
    if (options_.specular && !made.facets.empty()) addFacets(view, made, to, work);
  }

  static void move(const View& view, const float* x, const float* y, const float* z, std::size_t count, const phantom::Trilinear& to,
                   PointBatch& batch) {
    if (view.deforms) {
      phantom::moveTrilinear(x, y, z, count, to, batch);
    } else {
      phantom::moveAffine(x, y, z, count, to, batch);
    }
  }

  void addBatch(std::size_t count, FrameScratch& work) const {
    PointBatch& batch = work.batch;
    phantom::placeOnLines(gridding_, count, batch);
    if (options_.speedOfSound) delay(count, work);
    phantom::weigh(gridding_, count, batch);
    phantom::deposit(count, batch, work.fine.data());
  }

  void delay(std::size_t count, FrameScratch& work) const {
    const std::size_t steps = static_cast<std::size_t>(steps_);
    const double lastLine = static_cast<double>(grid_.lines.size() - 1), lastStep = static_cast<double>(steps_ - 1);
    for (std::size_t n = 0; n < count; ++n) {
      const double line = std::clamp((static_cast<double>(work.batch.row[n]) - rowPadding_) / rowsPerLine_, 0.0, lastLine - 1e-6);
      const double step = std::clamp(static_cast<double>(work.batch.range_mm[n]) / step_mm_, 0.0, lastStep - 1e-6);
      const auto l = static_cast<std::size_t>(line), s = static_cast<std::size_t>(step);
      const auto tl = static_cast<float>(line - static_cast<double>(l)), ts = static_cast<float>(step - static_cast<double>(s));
      const float* near = work.delay_mm.data() + l * steps + s;
      const float* far = near + steps;
      work.batch.range_mm[n] += (1.0F - tl) * (near[0] + ts * (near[1] - near[0])) + tl * (far[0] + ts * (far[1] - far[0]));
    }
  }

  void addFacets(const View& view, const ScattererBlock& made, const phantom::Trilinear& to, FrameScratch& work) const {
    PointBatch& batch = work.batch;
    const glm::mat3 turn(to[1], to[2], to[3]);
    // A facet is a spot of half its spacing: what it mirrors falls off with the tilt against the wave as that spot's Fourier transform.
    const double spread = 2.0 * std::numbers::pi * field_.facetSpacing_mm() / beams_.wavelength_mm;
    const auto sharpness = static_cast<float>(0.5 * spread * spread);
    const auto roughScale = static_cast<float>(std::sqrt(beams_.axialSigma_mm * std::sqrt(std::numbers::pi)));
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
        if (fan_.sector) {
          const float up = y + gridding_.apex_mm, radius = std::sqrt(x * x + up * up) + 1e-6F;
          wave = {x / radius, up / radius, 0.0F};
          depth = radius - gridding_.apex_mm;
        }
        const float off = depth - gridding_.lensFocus_mm, perRange = off < 0.0F ? gridding_.nearPerMm : gridding_.farPerMm;
        const float q = off * perRange;
        wave.z = z * q * perRange / (1.0F + q * q);
        const glm::vec3 normal = turn * facet.normal;
        const float lengths2 = glm::dot(normal, normal) * glm::dot(wave, wave);
        const float cosine = glm::dot(normal, wave) / std::sqrt(lengths2);
        const auto column = static_cast<std::size_t>(
            std::clamp(gridding_.firstColumn + gridding_.columnsPerMm * depth, 0.0F, static_cast<float>(columns_ - 1)));
        const bool visible = !facet.frontOnly || cosine < 0.0F;
        const float mirror = facet.mirror * mirrorScale_[column] * std::exp(-sharpness * (1.0F - cosine * cosine));
        batch.amplitude[n] = visible ? mirror + facet.rough * roughScale * std::abs(cosine) : 0.0F;
      }
      addBatch(count, work);
    }
  }

  void formLines(std::uint64_t frame, FrameScratch& work, Image<float>& envelope) const {
    const std::size_t lines = grid_.lines.size(), samples = static_cast<std::size_t>(grid_.samples);
    const std::size_t stride = 2 * columns_;
    envelope.width = static_cast<int>(lines);
    envelope.height = grid_.samples;
    envelope.pixels.resize(lines * samples);
    work.line.resize(stride);
    work.pulsed.resize(stride);
    for (std::size_t l = 0; l < lines; ++l) {
      // Lateral beam: rows about the line, weighted by depth.
      std::fill(work.line.begin(), work.line.end(), 0.0F);
      const float* middle =
          work.fine.data() + (static_cast<std::size_t>(rowPadding_) + l * static_cast<std::size_t>(rowsPerLine_)) * stride;
      for (std::size_t chunk = 0; chunk < reachOfChunk_.size(); ++chunk) {
        const std::size_t first = 2 * kChunk * chunk, count = std::min(2 * kChunk, stride - first);
        for (int t = -reachOfChunk_[chunk]; t <= reachOfChunk_[chunk]; ++t) {
          const float* weights = lateral_[static_cast<std::size_t>(std::abs(t))].data() + first;
          phantom::accumulate(middle + t * static_cast<std::ptrdiff_t>(stride) + static_cast<std::ptrdiff_t>(first), weights, count,
                              work.line.data() + first);
        }
      }
      weaken(l, work);
      addNoise(frame, l, work);
      for (std::size_t s = 0; s < samples; ++s) envelope.pixels[s * lines + l] = 0.0F;
      for (std::size_t look = 0; look < turns_.size(); ++look) addLook(look, l, work, envelope);
    }
  }

  /// The pulse's filter about one carrier, and its envelope.
  void addLook(std::size_t look, std::size_t l, FrameScratch& work, Image<float>& envelope) const {
    const std::size_t lines = grid_.lines.size(), samples = static_cast<std::size_t>(grid_.samples);
    const std::size_t margin = 2 * static_cast<std::size_t>(columnPadding_), count = 2 * samples;
    const float* in = work.line.data();
    if (turns_.size() > 1) {
      const std::vector<float>& turn = turns_[look];
      work.turned.resize(work.line.size());
      for (std::size_t n = 0; n < work.line.size(); n += 2) {
        work.turned[n] = work.line[n] * turn[n] - work.line[n + 1] * turn[n + 1];
        work.turned[n + 1] = work.line[n] * turn[n + 1] + work.line[n + 1] * turn[n];
      }
      in = work.turned.data();
    }
    std::fill(work.pulsed.begin(), work.pulsed.begin() + static_cast<std::ptrdiff_t>(count), 0.0F);
    phantom::accumulate(in + margin, pulse_[0], count, work.pulsed.data());
    for (std::size_t t = 1; t < pulse_.size(); ++t) {
      phantom::accumulate(in + margin - 2 * t, pulse_[t], count, work.pulsed.data());
      phantom::accumulate(in + margin + 2 * t, pulse_[t], count, work.pulsed.data());
    }
    const auto share = static_cast<float>(lookScale_ / static_cast<double>(turns_.size()));
    for (std::size_t s = 0; s < samples; ++s) {
      const float re = work.pulsed[2 * s] + ring_[s], im = work.pulsed[2 * s + 1];
      envelope.pixels[s * lines + l] += share * depthGain_[s] * std::sqrt(re * re + im * im);
    }
  }

  void weaken(std::size_t l, FrameScratch& work) const {
    if (!options_.attenuation) return;
    const float* gain = work.gain.data() + l * static_cast<std::size_t>(steps_);
    const double lag_mm = kLagPerPitch * field_.pitch_mm();
    for (std::size_t column = 0; column < columns_; ++column) {
      const double depth = (static_cast<double>(column) - columnPadding_) * grid_.sampleSpacing_mm - lag_mm;
      const double step = std::clamp(depth / step_mm_, 0.0, static_cast<double>(steps_ - 1) - 1e-6);
      const auto s = static_cast<std::size_t>(step);
      const auto t = static_cast<float>(step - static_cast<double>(s));
      const float factor = gain[s] + t * (gain[s + 1] - gain[s]);
      work.line[2 * column] *= factor;
      work.line[2 * column + 1] *= factor;
    }
  }

  /// Before the pulse's filter, which the receiver is: noise has the grain of the pulse along a line and none across.
  void addNoise(std::uint64_t frame, std::size_t l, FrameScratch& work) const {
    if (options_.noise_db <= kNoNoise_db) return;
    // A sum of two even 16-bit numbers has the variance 2^32 / 6; the filter makes it Gaussian enough.
    const auto strength = static_cast<float>(std::sqrt(3.0 * std::pow(10.0, 0.1 * options_.noise_db) * grid_.sampleSpacing_mm) / 65536.0);
    const std::uint64_t seed = hashOfPlace(options_.noiseSeed, static_cast<std::int64_t>(frame), 0, 0x6e6f697365);
    for (std::size_t column = 0; column < columns_; ++column) {
      const std::uint64_t hash = hashOfPlace(seed, static_cast<std::int64_t>(l), static_cast<std::int64_t>(column), 1);
      const auto part = [&](int shift) { return static_cast<float>((hash >> shift) & 0xFFFFu) - 32767.5F; };
      work.line[2 * column] += strength * (part(0) + part(16));
      work.line[2 * column + 1] += strength * (part(32) + part(48));
    }
  }

  std::shared_ptr<const Patient> patient_;
  Probe probe_;
  FormationOptions options_;
  BeamGrid grid_;
  Beams beams_;
  ScattererField field_;
  Fan fan_;
  phantom::Gridding gridding_;
  int rowsPerLine_ = 4;
  int rowPadding_ = 0;
  int columnPadding_ = 0;
  std::size_t columns_ = 0;
  std::vector<std::vector<float>> lateral_;  ///< by distance in rows: a weight per column, twice
  std::vector<int> reachOfChunk_;
  std::vector<float> pulse_;
  std::vector<std::vector<float>> turns_;  ///< by look: the phase that brings its carrier to the middle, per column
  double lookScale_ = 1.0;
  std::vector<float> mirrorScale_;
  std::vector<float> depthGain_;
  std::vector<float> ring_;
  double step_mm_ = 0.5;
  int steps_ = 0;
  std::vector<double> keptPerStep_;    ///< by tissue, both ways
  std::vector<double> keptAtSurface_;  ///< by tissue that is entered
  double air_ = factorOf(kAir_db);
  std::vector<double> delayPerStep_mm_;
};

}  // namespace

Result<std::unique_ptr<VirtualScanner>> makeVirtualScanner(std::shared_ptr<const Patient> patient, const Probe& probe,
                                                           const FormationOptions& options, std::uint64_t seed) {
  EW_EXPECTS(patient != nullptr);
  std::optional<Error> problem;
  const auto check = [&](const char* field, double value, double lowest, double highest) {
    if (problem || (value >= lowest && value <= highest)) return;
    problem = Error{ErrorCode::badField,
                    std::string("The virtual scanner's ") + field + " is " + textOf(value) + "; choose one from " + textOf(lowest) +
                        " to " + textOf(highest) + ".",
                    {{"field", field}}};
  };
  FormationOptions resolved = options;
  if (resolved.depth_mm == 0.0) resolved.depth_mm = probe.defaultDepth_mm;
  if (resolved.carrier_hz == 0.0) resolved.carrier_hz = probe.carrier_hz;
  check("depth_mm", resolved.depth_mm, std::min(5.0, probe.minDepth_mm), probe.maxDepth_mm);
  if (resolved.focus_mm == 0.0) resolved.focus_mm = 0.5 * resolved.depth_mm;
  check("focus_mm", resolved.focus_mm, 1.0, 1000.0);
  check("carrier_hz", resolved.carrier_hz, 0.5e6, 30e6);
  check("pulseCycles", resolved.pulseCycles, 0.5, 10.0);
  check("looks", resolved.looks, 1, 5);
  check("assumedSpeed_mPerS", resolved.assumedSpeed_mPerS, 500.0, 4000.0);
  check("noise_db", resolved.noise_db, -1000.0, 0.0);
  check("dynamicRange_db", resolved.dynamicRange_db, 20.0, 120.0);
  check("gain_db", resolved.gain_db, -100.0, 100.0);
  check("expected_dbPerCmMhz", resolved.expected_dbPerCmMhz, 0.0, 10.0);
  check("largestTgc_db", resolved.largestTgc_db, 0.0, 200.0);
  for (std::size_t n = 0; n < resolved.tgc.size(); ++n) {
    check("tgc.gain_db", resolved.tgc[n].gain_db, -200.0, 200.0);
    check("tgc.depth_mm", resolved.tgc[n].depth_mm, n == 0 ? 0.0 : std::nextafter(resolved.tgc[n - 1].depth_mm, 1e9), 1000.0);
  }
  if (problem) return passOn(*problem);
  if (resolved.tgc.empty()) {
    const double slope = resolved.attenuation ? 0.2 * resolved.expected_dbPerCmMhz * resolved.carrier_hz * 1e-6 : 0.0;  // dB/mm, both ways
    const double reach = slope > 0.0 ? std::min(resolved.largestTgc_db / slope, 1000.0) : 0.0;
    resolved.tgc.push_back({0.0, 0.0});
    if (reach > 0.0) resolved.tgc.push_back({reach, slope * reach});
  }

  const Beams beams = phantom::beamsOf(probe, resolved);
  const double pulse_mm = phantom::kFwhmOfSigma * beams.axialSigma_mm;
  const double samplesPerPulse = resolved.looks > 1 ? kSamplesPerLook : kSamplesPerPulse;
  BeamGrid grid = makeBeamGrid(probe, Knobs{}, resolved.depth_mm, pulse_mm / samplesPerPulse);

  // As few scatterers as the smallest resolution cell needs. The patient's pitch times powers of the root of two: probes of nearly the same
  // resolution see the same scatterers.
  double cell_mm3 = std::numeric_limits<double>::infinity();
  const double cube = phantom::kFwhmOfSigma * phantom::kFwhmOfSigma;
  for (int n = 0; n <= 64; ++n) {
    const double depth = resolved.depth_mm * n / 64.0;
    cell_mm3 = std::min(cell_mm3, pulse_mm * cube * beams.lateralSigma_mm(depth) * beams.elevationalSigma_mm(depth));
  }
  const double wanted_mm = std::cbrt(cell_mm3 / kScatterersPerResolutionCell);
  const double octave = std::clamp(std::floor(2.0 * std::log2(wanted_mm / patient->scattererPitch_mm)), -8.0, 2.0);
  const double pitch_mm = patient->scattererPitch_mm * std::exp2(0.5 * octave);
  return std::make_unique<Scanner>(std::move(patient), probe, resolved, std::move(grid), pitch_mm, seed);
}

void compressEnvelope(const Image<float>& envelope, double dynamicRange_db, Image<std::uint8_t>& levels) {
  EW_EXPECTS(dynamicRange_db > 0.0);
  levels.width = envelope.width;
  levels.height = envelope.height;
  levels.pixels.resize(envelope.pixels.size());
  const auto scale = static_cast<float>(255.0 * 20.0 / dynamicRange_db);
  for (std::size_t n = 0; n < envelope.pixels.size(); ++n) {
    const float amplitude = envelope.pixels[n];
    const float level = amplitude > 0.0F ? 255.0F + scale * std::log10(amplitude) : 0.0F;
    levels.pixels[n] = static_cast<std::uint8_t>(std::clamp(level, 0.0F, 255.0F) + 0.5F);
  }
}

}  // namespace ew
