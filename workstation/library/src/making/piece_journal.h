#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "ew/phantom/voxel_pieces.h"

namespace ew {

/// The pieces of a volume that is being painted, in one file to which each is appended as soon as it is done: whoever is stopped or killed
/// loses what was in work and no more. What is cut off or damaged is painted again. Nothing is said of a file that cannot be written: then
/// there is nothing to go on with.
class PieceJournal final : public VoxelPieces {
 public:
  /// @param file     of this volume alone; its folder is made. A file of an earlier run is gone on with
  /// @param recalled called once with the part that was there
  PieceJournal(std::filesystem::path file, std::function<void(double share)> recalled);

  bool recall(int piece, std::vector<std::uint8_t>& bytes) override;
  void keep(int piece, std::span<const std::uint8_t> bytes) override;
  void recalled(double share) override { recalled_(share); }

 private:
  struct Place {
    std::uint64_t at = 0, bytes = 0;
    std::string content;
  };
  std::filesystem::path file_;
  std::function<void(double)> recalled_;
  std::map<int, Place> there_;
  std::ifstream from_;
  std::mutex guard_;  // of what is written
  std::ofstream to_;
};

}  // namespace ew
