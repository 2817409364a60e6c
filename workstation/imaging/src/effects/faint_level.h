#pragma once

#include <algorithm>

#include "ew/imaging/effects/beam_gain.h"

namespace ew {

/// openBlack for one level. Monotone in the level.
template <class T>
T withBlackOpened(T level, T lift) {
  const T faint = std::min(T{1}, std::max(T{0}, T{1} - level * (T{1} / static_cast<T>(kFaintLevel))));
  return level - lift * (faint * faint);
}

}  // namespace ew
