#pragma once

#include <cstddef>
#include <map>
#include <memory>

#include "ew/core/image.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/cine_reader.h"

namespace ew {

/// Any frame of a recording, through a reader that knows only the next one. Those that were read last are kept, as many as fit, so that a
/// person can step back; what lies before them is read anew from the beginning. Not for several threads at once.
class ScreenFrames {
 public:
  explicit ScreenFrames(std::size_t mostBytes = std::size_t{256} << 20) : mostBytes_(mostBytes) {}

  /// @param reader of one recording, always the same, which others may have read or rewound meanwhile
  /// @param frame from 0
  /// @error as CineReader::next and rewind; truncated (there are not so many frames)
  [[nodiscard]] Result<std::shared_ptr<const GreyImage>> at(CineReader& reader, std::size_t frame, const Progress& progress = noProgress());

 private:
  void keep(std::size_t number, std::size_t wanted);

  std::size_t mostBytes_;
  std::size_t bytes_ = 0;
  std::map<std::size_t, std::shared_ptr<const GreyImage>> kept_;
  CineFrame read_;
};

}  // namespace ew
