#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ew::detail {

/// Scatterers of a block of the lattice, as far as they are the same from wherever a probe looks.
struct BlockScatterers {
  static constexpr std::size_t kCount = 64;
  /// Ten bits of a place in the cell along each of i, j, k, from the lowest on; the highest bit says whether it is taken from the sum.
  alignas(64) std::array<std::uint32_t, kCount> place;
  std::array<float, kCount> strength_log2;  ///< of the amplitude
  // One bit for each: beams that miss a part of a block ask nothing of it.
  std::uint64_t placed = 0;    ///< its place is known
  std::uint64_t known = 0;     ///< so are strength and sign
  std::uint64_t sounding = 0;  ///< it has a strength
};

/// Blocks that one piece of a frame asked for, for the next frame: a hand moves a tenth of a beam, and most blocks are seen again. What is
/// found is what would be made anew, as long as tissue and settings stay: forget() when they do not.
class ScattererStore {
 public:
  void forget() {
    keys_.assign(keys_.size(), Ways{});
    lastFrame_.assign(keys_.size(), {});  // or what is forgotten would stay longer than what comes
    frame_ = 0;
  }
  /// A frame that asks for so many blocks begins.
  void begin(std::size_t blocks) {
    ++frame_;
    // Sets of ways that are half full let few blocks drive each other out.
    if (2 * blocks <= kWays * keys_.size()) return;
    keys_.assign(std::bit_ceil(2 * blocks / kWays + 1), Ways{});
    lastFrame_.assign(keys_.size(), {});
    blocks_.resize(kWays * keys_.size());
  }
  /// @param cell its lowest, a multiple of `cellsOfBlock` below 2^21 of them
  /// @return what is known of a block; isNew: nothing. It stays that block's until two more were asked for.
  [[nodiscard]] BlockScatterers& at(const std::array<std::uint32_t, 3>& cell, bool& isNew) {
    const std::uint64_t key = keyOf(cell);
    const std::size_t set = setOf(key);
    Ways& keys = keys_[set];
    std::size_t way = 0;
    while (way < kWays && keys[way] != key) ++way;
    std::array<std::uint32_t, kWays>& last = lastFrame_[set];
    isNew = way == kWays;
    if (isNew) {
      // The one that nobody asked for the longest time.
      way = static_cast<std::size_t>(std::min_element(last.begin(), last.end()) - last.begin());
      if (kWays * set + way == latest_) way = (way + 1) % kWays;
      keys[way] = key;
      BlockScatterers& block = blocks_[kWays * set + way];
      block.placed = block.known = block.sounding = 0;
    }
    last[way] = frame_;
    latest_ = kWays * set + way;
    return blocks_[latest_];
  }

 private:
  static constexpr std::size_t kWays = 8;
  using Ways = std::array<std::uint64_t, kWays>;  // a line of memory

  /// Never 0, which is empty.
  [[nodiscard]] static std::uint64_t keyOf(const std::array<std::uint32_t, 3>& cell) {
    return 1 + (std::uint64_t{cell[0]} | std::uint64_t{cell[1]} << 21 | std::uint64_t{cell[2]} << 42);
  }
  [[nodiscard]] std::size_t setOf(std::uint64_t key) const {
    return static_cast<std::size_t>((key * 0x9e3779b97f4a7c15ULL) >> 32) & (keys_.size() - 1);
  }

  std::vector<Ways> keys_;
  std::vector<std::array<std::uint32_t, kWays>> lastFrame_;
  std::vector<BlockScatterers> blocks_;
  std::uint32_t frame_ = 0;
  std::size_t latest_ = 0;
};

}  // namespace ew::detail
