#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "patient/anatomy.h"

namespace ew::phantom {

/// What one cube of the resting body sends back, whoever looks at it. Coordinates are mm from the cube's lowest corner.
struct ScattererBlock {
  static constexpr int kCells = 8;  ///< along each edge
  static constexpr std::uint8_t kOutside = 255;

  /// Points that scatter into all directions.
  std::vector<float> x, y, z, amplitude;

  /// Small pieces of surfaces between tissues.
  struct Facet {
    glm::vec3 place;
    glm::vec3 normal;        ///< out of the organ, unit length
    float mirror = 0.0F;     ///< amplitude per mm2 of what it sends back like a mirror
    float rough = 0.0F;      ///< and, of random sign, into a wide cone
    bool frontOnly = false;  ///< seen from outside alone
  };
  std::vector<Facet> facets;

  /// Number of the tissue in each cell, i fastest, kOutside outside the skin; empty where all are `evenTissue`.
  std::vector<std::uint8_t> tissues;
  std::uint8_t evenTissue = kOutside;

  [[nodiscard]] std::uint8_t tissueAt(int i, int j, int k) const {
    return tissues.empty() ? evenTissue : tissues[static_cast<std::size_t>((k * kCells + j) * kCells + i)];
  }
  [[nodiscard]] std::size_t bytes() const {
    return sizeof(*this) + 4 * sizeof(float) * x.capacity() + sizeof(Facet) * facets.capacity() + tissues.capacity();
  }
};

/// The scatterers of a patient: one in each cell of a lattice at most, at a hashed place in it and of hashed amplitude, and facets on the
/// surfaces between organs. Blocks are made when they are asked for and kept as long as `maxBytes` allows, those used last longest.
/// Safe to ask from several threads; what comes back depends on patient, pitch and seed alone.
class ScattererField {
 public:
  ScattererField(std::shared_ptr<const Patient> patient, double pitch_mm, std::uint64_t seed, std::size_t maxBytes);

  /// @param stopped may be empty; asked all along while a block is made
  /// @return null only when stopped
  [[nodiscard]] std::shared_ptr<const ScattererBlock> block(const glm::ivec3& index, const std::function<bool()>& stopped = {}) const;
  [[nodiscard]] double pitch_mm() const { return pitch_; }
  [[nodiscard]] double blockSize_mm() const { return pitch_ * ScattererBlock::kCells; }
  /// How far a block's facets may lie outside its cube.
  [[nodiscard]] double overhang_mm() const { return pitch_; }
  [[nodiscard]] double facetSpacing_mm() const { return 0.5 * pitch_; }
  [[nodiscard]] const Patient& patient() const { return *patient_; }

 private:
  class Filler;
  struct Hash {
    std::size_t operator()(const glm::ivec3& index) const;
  };
  struct Kept {
    glm::ivec3 index;
    std::shared_ptr<const ScattererBlock> block;
  };
  struct Shard {
    std::mutex guard;
    std::list<Kept> used;  ///< latest first
    std::unordered_map<glm::ivec3, std::list<Kept>::iterator, Hash> found;
    std::size_t bytes = 0;
  };
  static constexpr std::size_t kShards = 16;

  std::shared_ptr<const Patient> patient_;
  double pitch_;
  std::uint64_t seed_;
  std::size_t maxBytesOfShard_;
  mutable std::array<Shard, kShards> shards_;
};

}  // namespace ew::phantom
