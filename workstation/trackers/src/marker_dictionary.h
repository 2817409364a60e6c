#pragma once

#include <string_view>
#include <vector>

#include "ew/core/message.h"

namespace ew {

/// How many markers a dictionary of MarkerBody::dictionary has; 0: it is not known.
[[nodiscard]] int markersOf(std::string_view dictionary);
/// Its number in OpenCV. @param dictionary a known one
[[nodiscard]] int opencvDictionary(std::string_view dictionary);
/// The names there are, for a sentence.
[[nodiscard]] Message dictionariesText();

/// The squares of a marker, row by row from the top, 1 black, with its black border. @param dictionary a known one
struct MarkerSquares {
  int side = 0;
  std::vector<unsigned char> isBlack;
};
[[nodiscard]] MarkerSquares squaresOf(std::string_view dictionary, int id);

}  // namespace ew
