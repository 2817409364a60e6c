#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "ew/imaging/display.h"
#include "ew/measurement/examination.h"
#include "ew/measurement/findings.h"
#include "ew/measurement/measurement_list.h"
#include "ew/scanning/recording.h"

namespace ew::ui {

/// An image that was measured: with its state it can be formed and measured again.
struct ImageMeasurements {
  std::uint64_t image = 0;  ///< as of Calipers::image and strip
  ScanState state;
  DisplayGeometry geometry;
  measurement::Measurements measurements;
};

/// What somebody has measured of a patient and not saved: enough for all of it to be there again.
struct MeasurementWork {
  struct Sheet {
    std::string package;
    std::optional<double> gestation_weeks;
    std::vector<measurement::Examination::Answer> answers;
    std::vector<std::pair<std::uint64_t, int>> found;  ///< image and number of the measurements that are in it
  };
  std::vector<ImageMeasurements> images;  ///< in the order they were first measured
  std::vector<Sheet> sheets;
  std::string current;  ///< package of the worksheet in hand; empty: none
  std::vector<measurement::Combination> combinations;

  [[nodiscard]] bool isEmpty() const { return images.empty() && sheets.empty(); }
};

inline constexpr int kMeasuredWorkFormat = 1;

/// All but the states of the images, which statesOf() has.
[[nodiscard]] nlohmann::json jsonOf(const MeasurementWork& work);
/// The images' states, a frame each in their order, a second from one to the next: what readJournal and jsonOf give together.
[[nodiscard]] ScanRecording statesOf(const MeasurementWork& work);
/// @param states of statesOf(); an image without one is left out @param where how sentences name the document
/// @error badField, newerFormat
[[nodiscard]] Result<MeasurementWork> measuredWorkFrom(const nlohmann::json& document, const ScanRecording& states, const Message& where);

}  // namespace ew::ui
