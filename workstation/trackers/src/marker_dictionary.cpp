#include "marker_dictionary.h"

#include <algorithm>
#include <array>
#include <opencv2/aruco.hpp>

#include "ew/core/contract.h"
#include "ew/core/json_fields.h"

namespace ew {
namespace {

struct KnownDictionary {
  std::string_view name;
  int number;
};
constexpr std::array<KnownDictionary, 6> kDictionaries = {{{"apriltag_16h5", cv::aruco::DICT_APRILTAG_16h5},
                                                           {"apriltag_25h9", cv::aruco::DICT_APRILTAG_25h9},
                                                           {"apriltag_36h11", cv::aruco::DICT_APRILTAG_36h11},
                                                           {"aruco_4x4_50", cv::aruco::DICT_4X4_50},
                                                           {"aruco_5x5_100", cv::aruco::DICT_5X5_100},
                                                           {"aruco_6x6_250", cv::aruco::DICT_6X6_250}}};

const KnownDictionary* dictionaryNamed(std::string_view name) {
  const auto* found = std::find_if(kDictionaries.begin(), kDictionaries.end(), [&](const auto& each) { return each.name == name; });
  return found == kDictionaries.end() ? nullptr : found;
}

}  // namespace

int opencvDictionary(std::string_view dictionary) {
  const KnownDictionary* known = dictionaryNamed(dictionary);
  EW_EXPECTS(known != nullptr);
  return known == nullptr ? cv::aruco::DICT_APRILTAG_36h11 : known->number;
}

int markersOf(std::string_view dictionary) {
  const KnownDictionary* known = dictionaryNamed(dictionary);
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
  cv::Mat picture;
  known->drawMarker(id, made.side, picture, 1);
  made.isBlack.reserve(static_cast<std::size_t>(made.side) * static_cast<std::size_t>(made.side));
  for (int row = 0; row < made.side; ++row)
    for (int column = 0; column < made.side; ++column) made.isBlack.push_back(picture.at<unsigned char>(row, column) < 128 ? 1 : 0);
  return made;
}

}  // namespace ew
