#include "marker_dictionary.h"

#include <algorithm>
#include <array>
#include <opencv2/aruco.hpp>
#include <opencv2/aruco/charuco.hpp>

#include "ew/core/contract.h"
#include "ew/core/json_fields.h"

namespace ew {
namespace {

struct DictionaryEntry {
  std::string_view name;
  int number;
};
constexpr std::array<DictionaryEntry, 6> kDictionaries = {{{"apriltag_16h5", cv::aruco::DICT_APRILTAG_16h5},
                                                           {"apriltag_25h9", cv::aruco::DICT_APRILTAG_25h9},
                                                           {"apriltag_36h11", cv::aruco::DICT_APRILTAG_36h11},
                                                           {"aruco_4x4_50", cv::aruco::DICT_4X4_50},
                                                           {"aruco_5x5_100", cv::aruco::DICT_5X5_100},
                                                           {"aruco_6x6_250", cv::aruco::DICT_6X6_250}}};

const DictionaryEntry* dictionaryNamed(std::string_view name) {
  const auto* found = std::find_if(kDictionaries.begin(), kDictionaries.end(), [&](const auto& each) { return each.name == name; });
  return found == kDictionaries.end() ? nullptr : found;
}

}  // namespace

int opencvDictionary(std::string_view dictionary) {
  const DictionaryEntry* known = dictionaryNamed(dictionary);
  EW_EXPECTS(known != nullptr);
  return known == nullptr ? cv::aruco::DICT_APRILTAG_36h11 : known->number;
}

int markersOf(std::string_view dictionary) {
  const DictionaryEntry* known = dictionaryNamed(dictionary);
  return known == nullptr ? 0 : cv::aruco::getPredefinedDictionary(known->number)->bytesList.rows;
}

Message dictionariesText() {
  std::array<std::string_view, kDictionaries.size()> names;
  for (std::size_t n = 0; n < names.size(); ++n) names[n] = kDictionaries[n].name;
  return wordsText(names);
}

MarkerSquares squaresOf(std::string_view dictionary, int id) {
  const auto known = cv::aruco::getPredefinedDictionary(opencvDictionary(dictionary));
  MarkerSquares made;
  made.side = known->markerSize + 2;
  cv::Mat image;
  known->drawMarker(id, made.side, image, 1);
  made.isBlack.reserve(static_cast<std::size_t>(made.side) * static_cast<std::size_t>(made.side));
  for (int row = 0; row < made.side; ++row)
    for (int column = 0; column < made.side; ++column) made.isBlack.push_back(image.at<unsigned char>(row, column) < 128 ? 1 : 0);
  return made;
}

std::vector<ChessSquare> chessSquares(const CalibrationBoard& board) {
  // Read off OpenCV's own image, since the order of its boards changed between versions.
  constexpr int kSquare_px = 200;
  const auto known = cv::aruco::getPredefinedDictionary(opencvDictionary(board.dictionary));
  const auto theirs =
      cv::aruco::CharucoBoard::create(board.columns, board.rows, 1.0F, static_cast<float>(board.marker_mm / board.square_mm), known);
  cv::Mat image;
  theirs->draw({board.columns * kSquare_px, board.rows * kSquare_px}, image, 0, 1);
  std::vector<std::vector<unsigned char>> markers;
  for (int id = 0; id < (board.columns * board.rows + 1) / 2; ++id) markers.push_back(squaresOf(board.dictionary, id).isBlack);
  const int modules = known->markerSize + 2;
  const double marker_px = kSquare_px * board.marker_mm / board.square_mm, border_px = 0.5 * (kSquare_px - marker_px);
  std::vector<ChessSquare> squares;
  for (int row = 0; row < board.rows; ++row)
    for (int column = 0; column < board.columns; ++column) {
      const auto isBlack = [&](double x, double y) {
        return image.at<unsigned char>(row * kSquare_px + static_cast<int>(y), column * kSquare_px + static_cast<int>(x)) < 128;
      };
      ChessSquare square{column, row, -1};
      if (!isBlack(0.5 * border_px, 0.5 * border_px)) {
        std::vector<unsigned char> seen;
        for (int y = 0; y < modules; ++y)
          for (int x = 0; x < modules; ++x)
            seen.push_back(isBlack(border_px + (x + 0.5) * marker_px / modules, border_px + (y + 0.5) * marker_px / modules) ? 1 : 0);
        const auto found = std::find(markers.begin(), markers.end(), seen);
        EW_EXPECTS(found != markers.end());
        square.marker = static_cast<int>(found - markers.begin());
      }
      squares.push_back(square);
    }
  return squares;
}

}  // namespace ew
