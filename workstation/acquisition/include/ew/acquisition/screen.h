#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "ew/acquisition/fan_outline.h"
#include "ew/core/image.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/cine_reader.h"
#include "ew/io/deidentify.h"

namespace ew {

// A recorded screen: where the scan is, how large its pixels are, where text and graphics lie over it, and how it is stored without them.
// What moves is scan, what stands still is screen. Every found thing is a plain value that a person can correct.

/// What each pixel did over the frames: all that finding needs of a recording, 19 bytes a pixel however long it is.
class ScreenStatistics {
 public:
  ScreenStatistics(int width_px, int height_px);
  /// Frames that show what the last one showed (a screen is recorded faster than it is scanned) count once.
  /// @param frame of the size that was named
  void add(const CineFrame& frame);

  [[nodiscard]] int width_px() const { return width_px_; }
  [[nodiscard]] int height_px() const { return height_px_; }
  [[nodiscard]] int frames() const { return frames_; }  ///< that differed
  [[nodiscard]] GreyImage lowest() const { return lowest_; }
  [[nodiscard]] GreyImage highest() const { return highest_; }
  [[nodiscard]] Image<float> mean() const;
  [[nodiscard]] Image<float> deviation() const;      ///< standard deviation over time
  [[nodiscard]] Image<float> activity() const;       ///< 0..1: share of changes of more than 2 levels from frame to frame
  [[nodiscard]] Image<float> colouredShare() const;  ///< 0..1 of the frames

 private:
  int width_px_, height_px_;
  int frames_ = 0;
  GreyImage lowest_, highest_, last_;
  std::vector<std::uint32_t> sum_, squares_;
  std::vector<std::uint16_t> changes_, coloured_;
};

enum class ScreenPartKind {
  text,          ///< burnt in, over the scan
  possibleText,  ///< may be text or echoes, in a recording that hardly moves: counts when a person says so
  outside,       ///< text, logo or graphics beside the scan
  bar,           ///< grey or colour bar
  scale          ///< tick marks of the depth scale
};
[[nodiscard]] const char* nameOf(ScreenPartKind kind);

/// Something of the screen that is no scan.
struct ScreenPart {
  PixelRect rect = {};
  ScreenPartKind kind = ScreenPartKind::text;
  bool operator==(const ScreenPart&) const = default;
};

/// Evenly spaced marks beside the scan, one below the other.
struct DepthTicks {
  double x_px = 0.0;         ///< of the end at which they are aligned
  double first_px = 0.0;     ///< y of the upper one
  double spacing_px = 0.0;   ///< of neighbours
  int count = 0;             ///< that were seen
  int every = 1;             ///< each so many is longer: the major marks; 1: all are alike
  double residual_px = 0.0;  ///< rms of their distance from even places
  bool operator==(const DepthTicks&) const = default;
};

struct ScreenAnalysis {
  int width_px = 0;
  int height_px = 0;
  int frames = 0;                          ///< different ones that were looked at
  std::optional<FanOutline> outline = {};  ///< empty: not found
  double quality = 0.0;  ///< 0..1: how much of the outline is borne out by edges, times how much of what moves lies inside
  std::optional<DepthTicks> ticks = {};
  std::vector<ScreenPart> parts = {};
  std::vector<PixelScale> scales = {};  ///< that the recording itself states (CineInfo)
  std::vector<Message> notes = {};      ///< what was not found, or found with doubt
};

/// Below this quality the outline counts as not found.
inline constexpr double kLeastQuality = 0.4;
/// Below this one it is given with a note of doubt: recorded and made screens whose outline was right had 0.93 and more.
inline constexpr double kSureQuality = 0.9;

/// Finds everything. The outline: what changes from frame to frame (or, of one still image, what is bright) is cleaned by morphology;
/// candidates of two straight sides come from a seeded random sample of its silhouette; outline points are then measured along the normals
/// (best step between two levels) and fitted together by least squares with Tukey's weights: sides through one apex with concentric arcs,
/// or four lines. Source of the weights: Beaton & Tukey, Technometrics 16, 1974. The best of several thresholds wins.
/// @param outline one that is known: then it is not looked for, quality is 1
[[nodiscard]] ScreenAnalysis findScreen(const ScreenStatistics& statistics, const std::optional<FanOutline>& outline = {});

/// What a person said about a found screen. Empty: nothing.
struct ScreenCorrection {
  Orientation turned = {};                 ///< of the images, on top of what the file says; all pixels below are of turned images
  std::optional<FanOutline> outline = {};  ///< replaces the found one
  std::optional<double> depth_mm = {};     ///< along the beams, from near to far edge
  std::optional<double> tick_mm = {};      ///< between neighbouring ticks
  std::vector<PixelRect> added = {};       ///< boxes over the scan that were not found, or found and not counted
  std::vector<PixelRect> removed = {};     ///< found boxes of text that overlap one of these by half are no text
  bool operator==(const ScreenCorrection&) const = default;
};

/// What counts in the end.
struct ScreenGeometry {
  int width_px = 0;
  int height_px = 0;
  std::optional<FanOutline> outline = {};
  /// Of square pixels: by the stated depth, else by the stated ticks, else by the recording's own scale.
  std::optional<double> pixel_mm = {};
  std::vector<PixelRect> text = {};  ///< boxes over the scan, also over its edge; none overlap
  std::vector<Message> notes = {};
};

/// @error badField (a depth or an outline that cannot be, ticks stated where none were found)
[[nodiscard]] Result<ScreenGeometry> corrected(const ScreenAnalysis& found, const ScreenCorrection& correction);

/// A screen's geometry as a file: what was found (for people and other programs) and the correction (which is read back). Pixels are those
/// of the recording. The file lies beside the cleaned recording, "liver.screen.json" beside "liver.igs.mha".
[[nodiscard]] std::filesystem::path screenFileBeside(const std::filesystem::path& recording);
/// @error notWritable
[[nodiscard]] Result<void> writeScreen(const ScreenAnalysis& found, const ScreenCorrection& correction, const std::filesystem::path& file);
/// The correction of such a file, or of one that has nothing else. An outline that was found and is not corrected is not in it.
/// @error notFound, notReadable, badHeader, badField, newerFormat
[[nodiscard]] Result<ScreenCorrection> readScreenCorrection(const std::filesystem::path& file);

/// How pixels under text become echoes. In a screen's boxes nothing is known; black holes would be read as echo-free tissue by what comes
/// after (level, registration), so by default they are filled smoothly from the nearest scan above, below, left and right, weighted by
/// 1 / distance: a fill that shows no grain can be told from a scan.
enum class TextFill { neighbours, black };

struct CleaningOptions {
  TextFill fill = TextFill::neighbours;
  bool keepOutside = false;   ///< leave what lies outside the outline, boxes of text excepted, and the whole image
  bool acceptsSmall = false;  ///< stored also when less than a tenth of the pixels or of the frames is kept (Retention)
};

/// Makes images clean: prepared once for a geometry, then frame after frame without allocation.
class ScreenCleaner {
 public:
  /// @param geometry with an outline, unless the outside is kept
  ScreenCleaner(const ScreenGeometry& geometry, const CleaningOptions& options);
  /// What is kept of each image.
  [[nodiscard]] const PixelRect& kept() const { return kept_; }
  [[nodiscard]] std::size_t pixelsInside() const { return inside_; }
  [[nodiscard]] std::size_t pixelsFilled() const { return filled_; }  ///< under boxes of text, inside
  /// The kept part of an image, without what is no scan. @param clean becomes kept() in size
  void clean(const GreyImage& image, GreyImage& clean) const;

 private:
  struct Fill {
    std::uint32_t to = 0;
    std::uint32_t from[4] = {};
    float weight[4] = {};
  };
  PixelRect kept_;
  GreyImage mask_;  ///< of the kept part: 1 where the image is taken
  std::vector<Fill> fills_;
  std::size_t inside_ = 0, filled_ = 0;
};

}  // namespace ew
