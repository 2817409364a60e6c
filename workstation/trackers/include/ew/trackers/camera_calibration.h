#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "ew/core/image.h"
#include "ew/core/message.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/trackers/camera_model.h"

namespace ew {

/// A chessboard with markers in its white squares, as it was printed.
struct CharucoBoard {
  int columns = 7, rows = 5;  ///< squares
  double square_mm = 36.0;    ///< as measured on the paper
  double marker_mm = 26.0;    ///< side of a marker, below square_mm
  std::string dictionary = "aruco_4x4_50";
  bool operator==(const CharucoBoard&) const = default;
};

/// The corners of the board in one image.
struct CharucoView {
  std::vector<int> ids;                ///< of inner corners, row by row
  std::vector<glm::dvec2> corners_px;  ///< one for each id
  bool operator==(const CharucoView&) const = default;
};

/// Why an image was or was not kept.
enum class ViewVerdict {
  kept,
  noBoard,  ///< fewer than eight corners are seen
  blurred,  ///< it moved, or is out of focus
  moving,   ///< the board is not held still since the last image
  alike,    ///< much like one that is kept
  full,     ///< as many are kept as are useful
};

/// What the images that are kept cover, and what is missing.
struct CalibrationCoverage {
  static constexpr int kColumns = 4, kRows = 3;
  std::array<int, std::size_t{kColumns} * kRows> corners{};  ///< of the board, in each part of the image, row by row
  /// Images in which the board is: straight, tipped to the left, right, upwards and downwards (15 degrees and more), near and far.
  int straight = 0, left = 0, right = 0, up = 0, down = 0, near = 0, far = 0;
  int views = 0;
  bool enough = false;  ///< to solve
  Message next;         ///< the one thing to do next, for a person; "enough" when nothing is missing
};

/// Gathers images of a ChArUco board while somebody moves it about. Not safe from several threads.
class CalibrationCollector {
 public:
  /// @error badField: a board that cannot be
  [[nodiscard]] static Result<CalibrationCollector> make(const CharucoBoard& board, int width, int height);
  CalibrationCollector(CalibrationCollector&&) noexcept;
  CalibrationCollector& operator=(CalibrationCollector&&) noexcept;
  ~CalibrationCollector();

  struct Look {
    ViewVerdict verdict = ViewVerdict::noBoard;
    CharucoView view;      ///< what was found, for drawing over the image
    double blur_px = 0.0;  ///< spread of the edges
  };
  /// @param grey of the size given to make()
  [[nodiscard]] Look look(ImageView<const std::uint8_t> grey, double time_s);
  [[nodiscard]] CalibrationCoverage coverage() const;
  [[nodiscard]] const std::vector<CharucoView>& views() const;

 private:
  struct State;
  explicit CalibrationCollector(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// The corners of the board in an image; few or none when it is not seen.
[[nodiscard]] CharucoView findCharuco(ImageView<const std::uint8_t> grey, const CharucoBoard& board);

struct CameraCalibration {
  CameraModel model;
  std::vector<double> residuals_px;  ///< root mean square of each view given; of those left out, with the model found without them
  std::vector<bool> leftOut;         ///< of the views given: their residual was more than three times the median
  double heldOut_px = 0.0;           ///< of every fourth view, with a model found from the others; 0: too few views
  double focalSpread_px = 0.0;       ///< standard deviation of the focal length as the fit judges it
  enum class Quality { good, usable, bad } quality = Quality::bad;
  Message verdict;  ///< in words, with what to do
};

/// Finds the model that explains the views. Work of seconds.
/// @error badField (fewer than eight views with eight corners each, or views that all look the same), cancelled, internal
[[nodiscard]] Result<CameraCalibration> calibrateCamera(const std::vector<CharucoView>& views, const CharucoBoard& board, int width,
                                                        int height, Progress& progress);

}  // namespace ew
