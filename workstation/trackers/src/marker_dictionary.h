#pragma once

#include <string_view>
#include <vector>

#include "ew/core/message.h"
#include "ew/trackers/paper_body.h"

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

/// A square of a chess board with markers, counted from the upper left.
struct ChessSquare {
  int column = 0;
  int row = 0;
  int marker = -1;  ///< -1: a black square
};
/// All squares as OpenCV's board has them; with another phase or order of ids it would not be found.
[[nodiscard]] std::vector<ChessSquare> chessSquares(const CalibrationBoard& board);

}  // namespace ew
