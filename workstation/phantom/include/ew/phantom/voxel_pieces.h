#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ew {

/// Where voxelise leaves the pieces it has painted and finds those of a run that was stopped, so that hours of work are never begun again.
/// The same patient and options paint the same pieces; whoever keeps them keeps those of one patient with one set of options apart from
/// others.
class VoxelPieces {
 public:
  virtual ~VoxelPieces() = default;
  /// @param bytes becomes what was kept. @return false: the piece is not there
  virtual bool recall(int piece, std::vector<std::uint8_t>& bytes) = 0;
  /// Called on any thread, also from several at once. What cannot be kept is painted again.
  virtual void keep(int piece, std::span<const std::uint8_t> bytes) = 0;
  /// Which part of the pieces was there, 0 to 1; called once before the first is painted.
  virtual void recalled(double) {}
};

}  // namespace ew
