#include "ew/imaging/flow_sampler.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

#include "ew/core/contract.h"
#include "flow/flow_profile.h"
#include "flow/vessel_line.h"

namespace ew {
namespace {

using detail::LinePlace;
using detail::ProfileValue;
using detail::VesselLine;

constexpr int kPhases = 256;
constexpr int kRadii = 97;  // from the axis to the wall
constexpr double kCell_mm = 2.0;
constexpr double kMostCells = 4e6;   // beyond: larger cells
constexpr double kSameAlpha = 1.02;  // ratio of Womersley numbers that share a table
constexpr double kSlowAlpha = 0.7;   // below it all profiles are parabolas

/// Of a stream's undisturbed profile: velocity and the flow within, for each 1 of flow over area.
struct WaveTable {
  FlowWave wave;
  double bluntness = 2.0, alpha = 0.0;
  std::vector<glm::vec2> values;  ///< (phases x radii), x: velocity, y: within
  std::vector<float> flow;        ///< by phase
};

struct TableRows {
  const glm::vec2* first;  ///< the radii of the phase before
  const glm::vec2* next;
  float share;
  float flow;
};

double classOf(double alpha) {
  if (alpha <= kSlowAlpha) return 0.0;
  const double step = std::log(kSameAlpha);
  return std::exp(step * std::round(std::log(alpha) / step));
}

WaveTable tableOf(const FlowStream& stream, double alpha) {
  WaveTable table{stream.wave, stream.bluntness, alpha, {}, {}};
  table.values.reserve(static_cast<std::size_t>(kPhases) * kRadii);
  // One phase gives another by turning the harmonics, so their profiles are asked for once.
  const std::size_t harmonics = stream.wave.harmonics.size();
  FlowStream one = stream;
  std::vector<std::vector<std::pair<std::complex<double>, std::complex<double>>>> shapes(harmonics);
  for (std::size_t n = 0; n < harmonics; ++n) {
    one.wave = {.mean = 0.0, .harmonics = std::vector<std::complex<double>>(n + 1)};
    one.wave.harmonics[n] = 1.0;
    const detail::WaveProfile real(one, alpha, 0.0), imaginary(one, alpha, -0.25 / static_cast<double>(n + 1));
    for (int r = 0; r < kRadii; ++r) {
      const double y = static_cast<double>(r) / (kRadii - 1);
      const ProfileValue re = real.at(y), im = imaginary.at(y);
      shapes[n].push_back({{re.velocity, im.velocity}, {re.within, im.within}});
    }
  }
  one.wave = {.mean = stream.wave.mean, .harmonics = {}};
  const detail::WaveProfile steady(one, alpha, 0.0);
  for (int k = 0; k < kPhases; ++k) {
    const double phase = static_cast<double>(k) / kPhases;
    table.flow.push_back(static_cast<float>(flowAtPhase(stream.wave, phase)));
    for (int r = 0; r < kRadii; ++r) {
      ProfileValue at = steady.at(static_cast<double>(r) / (kRadii - 1));
      for (std::size_t n = 0; n < harmonics; ++n) {
        const auto turned = stream.wave.harmonics[n] * std::polar(1.0, 2.0 * std::numbers::pi * phase * static_cast<double>(n + 1));
        at.velocity += (turned * shapes[n][static_cast<std::size_t>(r)].first).real();
        at.within += (turned * shapes[n][static_cast<std::size_t>(r)].second).real();
      }
      table.values.emplace_back(at.velocity, at.within);
    }
  }
  return table;
}

/// A jet's profile on the radii, for a flow of 1.
std::vector<glm::vec2> jetTable(const detail::JetProfile& jet) {
  std::vector<glm::vec2> values;
  for (int r = 0; r < kRadii; ++r) {
    const ProfileValue at = jet.at(static_cast<double>(r) / (kRadii - 1));
    values.emplace_back(at.velocity, at.within);
  }
  return values;
}

/// One piece of one vessel, as cells list it.
struct Piece {
  std::uint32_t vessel, node;
};

}  // namespace

struct FlowSampler::Parts {
  FlowField field;
  struct Vessel {
    VesselLine line;
    std::size_t table;
    std::vector<std::int32_t> jets;  ///< by node: its place among the jets; -1: none
  };
  std::vector<Vessel> vessels;
  std::vector<WaveTable> tables;
  std::vector<std::vector<glm::vec2>> jets;
  Bounds bounds{glm::dvec3(1.0), glm::dvec3(0.0)};
  glm::ivec3 cells{0};
  double cell_mm = kCell_mm;
  std::vector<std::uint32_t> firstPiece;  ///< by cell, and one behind the last
  std::vector<Piece> pieces;

  explicit Parts(const FlowField& described) : field(described) {
    for (std::size_t n = 0; n < field.streams.size(); ++n) addVessel(n);
    layCells();
  }

  void addVessel(std::size_t stream) {
    auto line = detail::vesselLineOf(field, stream);
    if (!line) return;
    const FlowStream& described = field.streams[stream];
    const double alpha = described.wave.harmonics.empty() ? 0.0 : classOf(line->alpha);
    const auto known = std::find_if(tables.begin(), tables.end(), [&](const WaveTable& each) {
      return each.alpha == alpha && each.bluntness == described.bluntness && each.wave == described.wave;
    });
    Vessel vessel{std::move(*line), static_cast<std::size_t>(known - tables.begin()), {}};
    if (known == tables.end()) tables.push_back(tableOf(described, alpha));
    for (const VesselLine::Node& node : vessel.line.nodes) {
      vessel.jets.push_back(node.jetShare > 0.0 ? static_cast<std::int32_t>(jets.size()) : -1);
      if (node.jetShare > 0.0) jets.push_back(jetTable(node.jet));
    }
    vessels.push_back(std::move(vessel));
  }

  /// @param visit called with each piece and the box around it
  template <class Visit>
  void forEachPiece(const Visit& visit) const {
    for (std::size_t v = 0; v < vessels.size(); ++v) {
      const auto& nodes = vessels[v].line.nodes;
      const auto widest = std::max_element(nodes.begin(), nodes.end(),
                                           [](const VesselLine::Node& a, const VesselLine::Node& b) { return a.radius_mm < b.radius_mm; });
      const double radius_mm = widest->radius_mm;
      for (std::size_t n = 0; n + 1 < nodes.size(); ++n) {
        // Wider than the piece itself: the piece nearest to a place decides, also where one farther away is so wide that it reaches there.
        visit(Piece{static_cast<std::uint32_t>(v), static_cast<std::uint32_t>(n)},
              Bounds{glm::min(nodes[n].place_mm, nodes[n + 1].place_mm) - radius_mm,
                     glm::max(nodes[n].place_mm, nodes[n + 1].place_mm) + radius_mm});
      }
    }
  }

  template <class Visit>
  void forEachCell(const Bounds& box, const Visit& visit) const {
    const glm::ivec3 from = glm::clamp(glm::ivec3(glm::floor((box.lowest_mm - bounds.lowest_mm) / cell_mm)), glm::ivec3(0), cells - 1);
    const glm::ivec3 to = glm::clamp(glm::ivec3(glm::floor((box.highest_mm - bounds.lowest_mm) / cell_mm)), glm::ivec3(0), cells - 1);
    for (int k = from.z; k <= to.z; ++k)
      for (int j = from.y; j <= to.y; ++j)
        for (int i = from.x; i <= to.x; ++i) visit(indexOf({i, j, k}));
  }

  [[nodiscard]] std::size_t indexOf(const glm::ivec3& cell) const {
    return static_cast<std::size_t>(cell.x) +
           static_cast<std::size_t>(cells.x) *
               (static_cast<std::size_t>(cell.y) + static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cell.z));
  }

  void layCells() {
    if (vessels.empty()) return;
    Bounds all{glm::dvec3(1e300), glm::dvec3(-1e300)};
    forEachPiece([&](const Piece&, const Bounds& box) {
      all.lowest_mm = glm::min(all.lowest_mm, box.lowest_mm);
      all.highest_mm = glm::max(all.highest_mm, box.highest_mm);
    });
    bounds = all;
    const glm::dvec3 size_mm = all.highest_mm - all.lowest_mm;
    cell_mm = std::max(kCell_mm, std::cbrt(size_mm.x * size_mm.y * size_mm.z / kMostCells));
    const auto lay = [&] { cells = glm::max(glm::ivec3(glm::ceil(size_mm / cell_mm)), glm::ivec3(1)); };
    for (lay(); static_cast<double>(cells.x) * cells.y * cells.z > kMostCells; lay()) cell_mm *= 1.2;  // a flat box keeps a layer
    // Counted first, then filled.
    firstPiece.assign(indexOf(cells - 1) + 2, 0);
    forEachPiece([&](const Piece&, const Bounds& box) { forEachCell(box, [&](std::size_t cell) { ++firstPiece[cell + 1]; }); });
    for (std::size_t cell = 1; cell < firstPiece.size(); ++cell) firstPiece[cell] += firstPiece[cell - 1];
    pieces.resize(firstPiece.back());
    std::vector<std::uint32_t> next(firstPiece.begin(), firstPiece.end() - 1);
    forEachPiece([&](const Piece& piece, const Bounds& box) { forEachCell(box, [&](std::size_t cell) { pieces[next[cell]++] = piece; }); });
  }

  [[nodiscard]] TableRows tableAt(const WaveTable& table, double phase) const {
    const double at = std::clamp(phase, 0.0, 1.0) * kPhases;
    const auto before = std::min(static_cast<int>(at), kPhases - 1);
    const int after = (before + 1) % kPhases;
    const auto share = static_cast<float>(at - before);
    const float flow = table.flow[static_cast<std::size_t>(before)];
    return {table.values.data() + static_cast<std::ptrdiff_t>(before) * kRadii,
            table.values.data() + static_cast<std::ptrdiff_t>(after) * kRadii, share,
            flow + share * (table.flow[static_cast<std::size_t>(after)] - flow)};
  }
};

namespace {

double phaseAlong(const FlowField& field, const FlowStream& stream, const FlowMoment::Stream& moment, double along_mm) {
  const double late_s = stream.pulseWave_mmPerS > 0.0 ? along_mm / stream.pulseWave_mmPerS : 0.0, since_s = moment.since_s - late_s;
  if (since_s >= 0.0) return since_s / moment.duration_s;
  if (since_s >= -moment.durationBefore_s) return std::clamp(1.0 + since_s / moment.durationBefore_s, 0.0, 1.0);
  const Cycle cycle = cycleAt(*field.rhythms.pulse, moment.time_s - late_s);  // a wave so slow that a third beat is on its way
  return cycle.since_s / cycle.duration_s;
}

}  // namespace

FlowSampler::FlowSampler(const FlowField& field) : parts_(std::make_unique<const Parts>(field)) {}
FlowSampler::~FlowSampler() = default;
FlowSampler::FlowSampler(FlowSampler&&) noexcept = default;
FlowSampler& FlowSampler::operator=(FlowSampler&&) noexcept = default;

const Bounds& FlowSampler::bounds() const { return parts_->bounds; }

void FlowSampler::prepare(double time_s, FlowMoment& moment) const {
  const FlowField& field = parts_->field;
  moment.streams.resize(field.streams.size());
  const double breath = field.rhythms.breathing ? bodyAt(field.rhythms, time_s).breath : 0.0;
  for (std::size_t n = 0; n < field.streams.size(); ++n) {
    const FlowStream& stream = field.streams[n];
    FlowMoment::Stream& wave = moment.streams[n];
    wave = {.time_s = 0.0,
            .since_s = 0.0,
            .duration_s = 1.0,
            .durationBefore_s = 1.0,
            .unit_mm3PerS = stream.flow_mm3PerS * (1.0 + stream.breathShare * breath)};
    if (!field.rhythms.pulse) continue;
    const Cycle cycle = cycleAt(*field.rhythms.pulse, time_s - stream.delay_s);
    wave.time_s = time_s - stream.delay_s;
    wave.since_s = cycle.since_s;
    wave.duration_s = cycle.duration_s;
    wave.durationBefore_s = cycleAt(*field.rhythms.pulse, time_s - stream.delay_s - cycle.since_s - 1e-6).duration_s;
  }
}

BloodVelocity FlowSampler::at(const FlowMoment& moment, const glm::dvec3& p_mm) const {
  const Parts& parts = *parts_;
  EW_EXPECTS(moment.streams.size() == parts.field.streams.size());
  const glm::dvec3 inGrid = (p_mm - parts.bounds.lowest_mm) / parts.cell_mm;
  const bool isInside = inGrid.x >= 0.0 && inGrid.y >= 0.0 && inGrid.z >= 0.0 && inGrid.x <= parts.cells.x && inGrid.y <= parts.cells.y &&
                        inGrid.z <= parts.cells.z;
  if (!isInside || parts.pieces.empty()) return {};
  const std::size_t cell = parts.indexOf(glm::min(glm::ivec3(inGrid), parts.cells - 1));

  // In each vessel the piece whose line is nearest, of the vessels the one in which the place lies deepest.
  const Parts::Vessel* deepest = nullptr;
  LinePlace place;
  std::uint32_t last = parts.firstPiece[cell + 1];
  for (std::uint32_t n = parts.firstPiece[cell]; n < last;) {
    const std::uint32_t number = parts.pieces[n].vessel;
    const Parts::Vessel& vessel = parts.vessels[number];
    LinePlace nearest;
    nearest.away_mm = 1e300;
    for (; n < last && parts.pieces[n].vessel == number; ++n) {
      const LinePlace here = detail::placeOnPiece(vessel.line, parts.pieces[n].node, p_mm);
      if (here.away_mm < nearest.away_mm) nearest = here;
    }
    if (nearest.isBeyond || !(nearest.depth() < 1.0)) continue;
    if (deepest && !(nearest.depth() < place.depth())) continue;
    deepest = &vessel;
    place = nearest;
  }
  if (!deepest) return {};

  const FlowMoment::Stream& wave = moment.streams[deepest->line.stream];
  const VesselLine::Node &a = deepest->line.nodes[place.node], &b = deepest->line.nodes[place.node + 1];
  const double along_mm = a.at_mm + place.share * (b.at_mm - a.at_mm);
  const TableRows table =
      parts.tableAt(parts.tables[deepest->table], phaseAlong(parts.field, parts.field.streams[deepest->line.stream], wave, along_mm));
  const double y = place.depth(), onRadii = y * (kRadii - 1);
  const int inner = std::min(static_cast<int>(onRadii), kRadii - 2);
  const auto outwards = static_cast<float>(onRadii - inner);
  const auto among = [&](const glm::vec2* radii) { return radii[inner] + outwards * (radii[inner + 1] - radii[inner]); };
  const glm::vec2 plain = among(table.first) + table.share * (among(table.next) - among(table.first));
  const auto atNode = [&](const VesselLine::Node& node, std::int32_t jet) {
    if (jet < 0) return plain;
    return plain + static_cast<float>(node.jetShare) * (table.flow * among(parts.jets[static_cast<std::size_t>(jet)].data()) - plain);
  };
  const glm::dvec2 here(atNode(a, deepest->jets[place.node])), next(atNode(b, deepest->jets[place.node + 1]));
  const double length_mm = b.at_mm - a.at_mm, widens = (b.radius_mm - a.radius_mm) / length_mm;
  const double along = here.x + place.share * (next.x - here.x);
  const double drift = y > 1e-9 ? place.radius_mm / (2.0 * y) * (next.y - here.y) / length_mm : 0.0;
  const double unit_mmPerS = wave.unit_mm3PerS / (std::numbers::pi * place.radius_mm * place.radius_mm);
  return detail::bloodOf(deepest->line, place, p_mm, unit_mmPerS * glm::dvec2(along, along * y * widens - drift),
                         std::abs(unit_mmPerS * static_cast<double>(table.flow)));
}

std::size_t FlowSampler::bytes() const {
  std::size_t bytes = parts_->pieces.size() * sizeof(Piece) + parts_->firstPiece.size() * sizeof(std::uint32_t);
  for (const WaveTable& table : parts_->tables) bytes += table.values.size() * sizeof(glm::vec2) + table.flow.size() * sizeof(float);
  for (const auto& jet : parts_->jets) bytes += jet.size() * sizeof(glm::vec2);
  for (const auto& vessel : parts_->vessels) bytes += vessel.line.nodes.size() * (sizeof(VesselLine::Node) + sizeof(std::int32_t));
  return bytes;
}

}  // namespace ew
