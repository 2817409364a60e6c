#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "ew/acquisition/screen.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/cine_reader.h"
#include "ew/io/retention.h"
#include "ew/io/sequence.h"

namespace ew {

inline constexpr int kScreenFrames = 300;  ///< as many are looked at

/// A recording that was looked through once: what it is, and what its screen shows.
struct ScreenSurvey {
  std::filesystem::path recording;
  CineReader reader;  ///< at its first frame
  ScreenAnalysis found;
  std::vector<double> times_s;     ///< of the frames that can be read
  GreyImage image;                 ///< the middle frame of those looked at, to show
  std::optional<Error> brokenOff;  ///< why there are fewer frames than promised
};

/// Reads a recording once from front to end, with one frame in memory, and finds everything.
/// @param outline one that is known, see findScreen()
/// @param mostFrames of those looked at, spread over the recording; all are counted and timed
/// @param turned what a person says of how the images lie, on top of what the file says
/// @param rate_hz of the images by a person, instead of the times that the file states or that are assumed
/// @error as CineReader::open; badField (an outline that is not in the images), cancelled
[[nodiscard]] Result<ScreenSurvey> openScreen(const std::filesystem::path& recording, const std::optional<FanOutline>& outline = {},
                                              Progress& progress = noProgress(), const ReaderLimits& limits = {},
                                              int mostFrames = kScreenFrames, const Orientation& turned = {},
                                              const std::optional<double>& rate_hz = {});

/// What a cleaned recording is: its frames without pixels, "Image" to "Picture" (mm from the upper left pixel) where the size of a pixel is
/// known, and the fan's geometry as fields.
[[nodiscard]] Sequence cleanedHeader(const ScreenSurvey& opened, const ScreenGeometry& geometry, const PixelRect& kept);

/// What openSweep() and reconstruct take beside a cleaned recording: the clip of the fan and, where the size of a pixel is known, "Image"
/// to "Probe" with the origin in the middle of the probe's face.
[[nodiscard]] DeviceSet deviceSetOf(const ScreenGeometry& geometry, const PixelRect& kept);

/// How much of the recording is stored: pixels of the part that is cut out, and frames of all those that the recording has.
[[nodiscard]] Retention keptOf(const ScreenSurvey& opened, const ScreenGeometry& geometry, const CleaningOptions& options);

struct ScreenCleaning {
  std::size_t frames = 0;
  PixelRect kept = {};
  std::size_t pixelsInside = 0;
  std::size_t pixelsFilled = 0;
  Removed removed = {};
};

/// Reads the recording again and writes it cleaned as .igs.mha, frame by frame.
/// @param geometry with an outline, unless the outside is kept
/// @error as CineReader::next and writeSequence; unsupported (no outline), unsupported (too little is kept and nobody said yes, with the
/// context
///        entry "ask": "accept-small"), cancelled
[[nodiscard]] Result<ScreenCleaning> writeCleaned(ScreenSurvey& opened, const ScreenGeometry& geometry, const CleaningOptions& options,
                                                  const std::filesystem::path& file, Progress& progress = noProgress());

}  // namespace ew
