#include "scanner/scatterers.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "echoes/echo_levels.h"
#include "ew/phantom/speckle.h"

namespace ew::phantom {
namespace {

// As in sampleDistance: how far a first-order distance may exceed the true one before a part of the body is wrongly left out.
constexpr double kScattererReserve = 1.5;
constexpr double kHalfDiagonal = 0.8660254037844386;
constexpr std::uint64_t kAmplitudeSeed = 0x616d706c69747564ull;
constexpr std::uint64_t kFacetSeed = 0x66616365745f5f31ull;
constexpr int kFacetsPerCell = 2;        // along each edge
constexpr double kCoincident_mm = 0.05;  // surfaces nearer than this are one
constexpr double kNormalStep_mm = 0.05;
constexpr double kStraight = 0.04;           // of the pitch: how far a distance may curve within a cell before it is asked exactly
constexpr double kRough_db = -9.0;           // scattered by a bone's or gas' surface, below what it mirrors
constexpr double kSmoothRough_db = -18.0;    // and by a capsule or vessel wall
constexpr double kAllRoundScattered = 0.65;  // of a border that shines all round, half as wide as drawn: the beam widens it again
constexpr double kAllRoundWidth = 0.6;
constexpr double kGlintScattered = 0.18;  // as voxelise: of a border's extra brightness, what comes from its layer of tissue

double unit16(std::uint64_t hash, int shift) { return (static_cast<double>((hash >> shift) & 0xFFFFu) + 0.5) / 65536.0; }

}  // namespace

/// Makes one block by halving it until a part lies in one tissue or is a single cell.
class ScattererField::Filler {
 public:
  Filler(const ScattererField& field, const glm::ivec3& index, const std::function<bool()>& askToStop)
      : patient_(*field.patient_), askToStop_(askToStop), pitch_(field.pitch_), seed_(field.seed_), first_(index * ScattererBlock::kCells) {
    corner_ = pitch_ * glm::dvec3(first_);
    volume_ = pitch_ * pitch_ * pitch_;
    tissues_.assign(static_cast<std::size_t>(ScattererBlock::kCells) * ScattererBlock::kCells * ScattererBlock::kCells,
                    ScattererBlock::kOutside);
  }

  /// Null when stopped.
  std::shared_ptr<const ScattererBlock> make() {
    std::vector<const Organ*> all;
    all.reserve(patient_.organs.size());
    for (const Organ& organ : patient_.organs) all.push_back(&organ);
    fill(glm::ivec3(0), ScattererBlock::kCells, all, false);
    if (stopped_) return nullptr;
    block_.evenTissue = tissues_.front();
    if (std::any_of(tissues_.begin(), tissues_.end(), [&](std::uint8_t tissue) { return tissue != tissues_.front(); }))
      block_.tissues = std::move(tissues_);
    for (std::vector<float>* values : {&block_.x, &block_.y, &block_.z, &block_.amplitude}) values->shrink_to_fit();
    block_.facets.shrink_to_fit();
    return std::make_shared<const ScattererBlock>(std::move(block_));
  }

 private:
  void fill(const glm::ivec3& cell, int size, const std::vector<const Organ*>& candidates, bool insideSkin) {
    const double radius = kHalfDiagonal * pitch_ * size;
    const glm::dvec3 centre = corner_ + pitch_ * (glm::dvec3(cell) + 0.5 * size);
    if (!insideSkin) {
      const double skin = patient_.skin->distance_mm(centre);
      if (skin > kScattererReserve * radius) return;
      insideSkin = skin < -kScattererReserve * radius;
    }
    std::vector<const Organ*> near;
    std::vector<double> atCentre_mm;
    const Organ* owner = nullptr;  // whose tissue fills the whole part
    for (const Organ* organ : candidates) {
      const double reach = radius + std::max(organ->border ? organ->border->width_mm : 0.0, pitch_);
      if (organ->shape->atLeast_mm(centre) > reach) continue;
      const double d = organ->shape->distance_mm(centre);
      if (d > kScattererReserve * reach) continue;
      near.push_back(organ);
      atCentre_mm.push_back(d);
      if (d < -kScattererReserve * reach) {  // whatever comes later is hidden by this one
        owner = organ;
        break;
      }
    }
    if (insideSkin && (near.empty() || near.front() == owner)) {
      const std::size_t tissue = near.empty() ? patient_.backgroundTissue : owner->tissue;
      for (int k = 0; k < size; ++k)
        for (int j = 0; j < size; ++j)
          for (int i = 0; i < size; ++i) {
            const glm::ivec3 at = cell + glm::ivec3(i, j, k);
            setTissue(at, tissue);
            addScatterer(at, placeIn(at), tissue, {});
          }
      return;
    }
    if (size > 1) {
      const int half = size / 2;
      for (int child = 0; child < 8; ++child)
        fill(cell + half * glm::ivec3(child & 1, (child >> 1) & 1, child >> 2), half, near, insideSkin);
      return;
    }
    if (stopped()) return;
    takeCell(cell, near, atCentre_mm);
    const glm::dvec3 place = placeIn(cell);
    if (insideSkin || patient_.skin->distance_mm(place) < 0.0) {
      std::size_t tissue = patient_.backgroundTissue;
      for (const Near& organ : near_) {
        if (!(organ.distance_mm(place) < 0.0)) continue;
        tissue = organ.organ->tissue;
        break;
      }
      setTissue(cell, tissue);
      addScatterer(cell, place, tissue, near_);
    }
    for (std::size_t n = 0; n < near_.size() && !stopped(); ++n) addFacets(cell, n);
  }

  [[nodiscard]] bool stopped() {
    stopped_ = stopped_ || (askToStop_ && askToStop_());
    return stopped_;
  }

  /// Distances of one organ at the corners of the block's cells; not a number where nobody asked yet.
  static constexpr int kNodes = ScattererBlock::kCells + 1;
  struct Corners {
    const Organ* organ = nullptr;
    std::vector<double> distance_mm;
  };

  /// An organ near the cell at hand. Where its distance is straight enough within the cell it is interpolated between the corners, which
  /// neighbouring cells share; small vessels, edges and thin layers are asked exactly.
  struct Near {
    const Organ* organ = nullptr;
    double atCentre_mm = 0.0;
    bool straight = false;
    glm::dvec3 corner_mm{0.0};
    double perPitch = 1.0;
    std::array<double, 8> v{};

    [[nodiscard]] double distance_mm(const glm::dvec3& p) const {
      if (!straight) return organ->shape->distance_mm(p);
      const glm::dvec3 t = (p - corner_mm) * perPitch;
      const auto along = [&](std::size_t n) { return v[n] + t.x * (v[n + 1] - v[n]); };
      const double nearer = along(0) + t.y * (along(2) - along(0)), farther = along(4) + t.y * (along(6) - along(4));
      return nearer + t.z * (farther - nearer);
    }
    /// Of the distance, which is `d` at p.
    [[nodiscard]] glm::dvec3 gradient(const glm::dvec3& p, double d) const {
      glm::dvec3 slope;
      for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0.0);
        step[axis] = kNormalStep_mm;
        slope[axis] = (distance_mm(p + step) - d) / kNormalStep_mm;
      }
      return slope;
    }
  };

  void takeCell(const glm::ivec3& cell, const std::vector<const Organ*>& near, const std::vector<double>& atCentre_mm) {
    near_.resize(near.size());
    for (std::size_t n = 0; n < near.size(); ++n) {
      Near& taken = near_[n];
      taken.organ = near[n];
      taken.atCentre_mm = atCentre_mm[n];
      taken.corner_mm = corner_ + pitch_ * glm::dvec3(cell);
      taken.perPitch = 1.0 / pitch_;
      Corners& corners = cornersOf(near[n]);
      double sum = 0.0;
      for (int c = 0; c < 8; ++c) {
        const glm::ivec3 node = cell + glm::ivec3(c & 1, (c >> 1) & 1, c >> 2);
        double& kept = corners.distance_mm[static_cast<std::size_t>((node.z * kNodes + node.y) * kNodes + node.x)];
        if (std::isnan(kept)) kept = near[n]->shape->distance_mm(corner_ + pitch_ * glm::dvec3(node));
        taken.v[static_cast<std::size_t>(c)] = kept;
        sum += kept;
      }
      taken.straight = std::abs(0.125 * sum - taken.atCentre_mm) < kStraight * pitch_;
    }
  }

  Corners& cornersOf(const Organ* organ) {
    for (Corners& corners : corners_) {
      if (corners.organ == organ) return corners;
    }
    corners_.push_back(
        {organ, std::vector<double>(static_cast<std::size_t>(kNodes * kNodes * kNodes), std::numeric_limits<double>::quiet_NaN())});
    return corners_.back();
  }

  void setTissue(const glm::ivec3& cell, std::size_t tissue) {
    tissues_[static_cast<std::size_t>((cell.z * ScattererBlock::kCells + cell.y) * ScattererBlock::kCells + cell.x)] =
        static_cast<std::uint8_t>(tissue);
  }

  [[nodiscard]] std::uint64_t hashOf(const glm::ivec3& cell, std::uint64_t salt) const {
    const glm::ivec3 at = first_ + cell;
    return hashOfPlace(seed_ ^ salt, at.x, at.y, at.z);
  }
  [[nodiscard]] glm::dvec3 placeIn(const glm::ivec3& cell) const {
    const std::uint64_t hash = hashOf(cell, 0);
    return corner_ + pitch_ * (glm::dvec3(cell) + glm::dvec3(unit16(hash, 0), unit16(hash, 16), unit16(hash, 32)));
  }

  void addScatterer(const glm::ivec3& cell, const glm::dvec3& place, std::size_t number, const std::vector<Near>& near) {
    const Tissue& tissue = patient_.tissues[number];
    const double level = withBorders(tissueLevelAt(patient_, number, place), place, near);
    const double kept = tissue.scatterers_perMm3 ? std::min(1.0, *tissue.scatterers_perMm3 * volume_) : 1.0;
    if (!(kept > 0.0) || (tissue.speckle <= 0.0 && level <= tissue.echoLevel)) return;
    const std::uint64_t hash = hashOf(cell, kAmplitudeSeed);
    if (unit16(hash, 32) > kept) return;
    // Equal magnitudes, random signs: without spread of the magnitudes the intensity has the statistics of an exponential variable although
    // a resolution cell holds few scatterers (its second moment: 2.01 to 2.03 times the square of the first; with Gaussian amplitudes it
    // would take ten times more of them).
    const double sign = (hash & 1u) != 0 ? 1.0 : -1.0;
    const double amplitude = sign * std::sqrt(specklePowerAt(level) * volume_ / kept);
    const glm::dvec3 local = place - corner_;
    block_.x.push_back(static_cast<float>(local.x));
    block_.y.push_back(static_cast<float>(local.y));
    block_.z.push_back(static_cast<float>(local.z));
    block_.amplitude.push_back(static_cast<float>(amplitude));
  }

  /// The layer of tissue along an organ's surface scatters more than what it parts.
  [[nodiscard]] double withBorders(double level, const glm::dvec3& place, const std::vector<Near>& near) const {
    double strongest = 0.0, towards = 0.0;
    for (const Near& each : near) {
      const Organ* organ = each.organ;
      const double d = each.distance_mm(place);
      if (organ->border) {
        const bool allRound = organ->border->shine == Shine::allRound;
        const double t = d / (organ->border->width_mm * (allRound ? kAllRoundWidth : 1.0));
        const double share = allRound ? kAllRoundScattered : kGlintScattered;
        if (t * t < 1.0) {
          const double weight = share * (1.0 - t * t) * (1.0 - t * t);
          if (weight * organ->border->echoLevel > strongest * towards) {
            strongest = weight;
            towards = organ->border->echoLevel;
          }
        }
      }
      if (d < 0.0) break;
    }
    return towards > level ? level + strongest * (towards - level) : level;
  }

  [[nodiscard]] std::optional<double> impedanceAt(const glm::dvec3& place) const {
    if (patient_.skin->distance_mm(place) >= 0.0) return std::nullopt;
    for (const Near& each : near_) {
      if (each.distance_mm(place) < 0.0) return patient_.tissues[each.organ->tissue].impedance_mrayl;
    }
    return patient_.tissues[patient_.backgroundTissue].impedance_mrayl;
  }

  /// Points spread evenly in a layer of the facets' spacing about the surface, brought down onto it: each stands for spacing^2 of it.
  void addFacets(const glm::ivec3& cell, std::size_t n) {
    const Near& here = near_[n];
    const Organ& organ = *here.organ;
    const double spacing = pitch_ / kFacetsPerCell;
    if (std::abs(here.atCentre_mm) > kScattererReserve * (kHalfDiagonal * pitch_ + 0.5 * spacing)) return;
    for (int part = 0; part < kFacetsPerCell * kFacetsPerCell * kFacetsPerCell; ++part) {
      const glm::ivec3 sub = kFacetsPerCell * (first_ + cell) + glm::ivec3(part & 1, (part >> 1) & 1, part >> 2);
      const std::uint64_t hash =
          hashOfPlace(seed_ ^ kFacetSeed ^ (static_cast<std::uint64_t>(&organ - patient_.organs.data()) << 8), sub.x, sub.y, sub.z);
      const glm::dvec3 place = spacing * (glm::dvec3(sub) + glm::dvec3(unit16(hash, 0), unit16(hash, 16), unit16(hash, 32)));
      const double d = here.distance_mm(place);
      if (std::abs(d) > 0.5 * spacing) continue;
      const glm::dvec3 gradient = here.gradient(place, d);
      const double steep = glm::length(gradient);
      if (!(steep > 0.0)) continue;
      const glm::dvec3 normal = gradient / steep;
      const glm::dvec3 foot = place - normal * (d / steep);
      if (hidden(foot, n) || patient_.skin->distance_mm(foot) > kCoincident_mm) continue;

      double mirror = 0.0, rough_db = kSmoothRough_db;
      bool frontOnly = false;
      if (organ.border) {
        mirror = amplitudeAt(organ.border->echoLevel);
        frontOnly = organ.border->shine == Shine::front;
        if (frontOnly) rough_db = kRough_db;
      } else {
        const auto outside = impedanceAt(foot + 2.0 * kCoincident_mm * normal);
        if (!outside) continue;
        mirror = mirroredBetween(patient_.tissues[organ.tissue].impedance_mrayl, *outside);
        if (!(mirror > 0.0)) continue;
      }
      const double area = spacing * spacing;
      ScattererBlock::Facet facet;
      facet.place = glm::vec3(foot - corner_);
      facet.normal = glm::vec3(normal);
      facet.mirror = static_cast<float>(mirror * area);
      facet.rough = static_cast<float>(mirror * std::pow(10.0, 0.05 * rough_db) * spacing * std::sqrt(12.0) * (unit16(hash, 48) - 0.5));
      facet.frontOnly = frontOnly;
      block_.facets.push_back(facet);
    }
  }

  /// Whether an organ of higher priority covers this point of organ n's surface, or has drawn the same surface already.
  [[nodiscard]] bool hidden(const glm::dvec3& foot, std::size_t n) const {
    for (std::size_t m = 0; m < n; ++m) {
      const double d = near_[m].distance_mm(foot);
      if (d < -kCoincident_mm) return true;
      if (d <= kCoincident_mm && (near_[m].organ->border || !near_[n].organ->border)) return true;
    }
    return false;
  }

  const Patient& patient_;
  const std::function<bool()>& askToStop_;
  bool stopped_ = false;
  double pitch_;
  std::uint64_t seed_;
  glm::ivec3 first_;
  glm::dvec3 corner_;
  double volume_ = 0.0;
  ScattererBlock block_;
  std::vector<std::uint8_t> tissues_;
  std::vector<Corners> corners_;
  std::vector<Near> near_;
};

ScattererField::ScattererField(std::shared_ptr<const Patient> patient, double pitch_mm, std::uint64_t seed, std::size_t maxBytes)
    : patient_(std::move(patient)), pitch_(pitch_mm), seed_(seed), maxBytesOfShard_(maxBytes / kShards) {}

std::size_t ScattererField::Hash::operator()(const glm::ivec3& index) const {
  return static_cast<std::size_t>(hashOfPlace(0, index.x, index.y, index.z));
}

std::shared_ptr<const ScattererBlock> ScattererField::block(const glm::ivec3& index, const std::function<bool()>& stopped) const {
  Shard& shard = shards_[Hash{}(index) % kShards];
  {
    const std::lock_guard lock(shard.guard);
    if (const auto found = shard.found.find(index); found != shard.found.end()) {
      shard.used.splice(shard.used.begin(), shard.used, found->second);
      return found->second->block;
    }
  }
  // Made without the lock: two threads may make the same block at once, and both make the same one.
  std::shared_ptr<const ScattererBlock> made = Filler(*this, index, stopped).make();
  if (!made) return made;
  const std::lock_guard lock(shard.guard);
  if (const auto found = shard.found.find(index); found != shard.found.end()) return found->second->block;
  shard.used.push_front({index, made});
  shard.found.emplace(index, shard.used.begin());
  shard.bytes += made->bytes();
  while (shard.bytes > maxBytesOfShard_ && shard.used.size() > 1) {
    shard.bytes -= shard.used.back().block->bytes();
    shard.found.erase(shard.used.back().index);
    shard.used.pop_back();
  }
  return made;
}

}  // namespace ew::phantom
