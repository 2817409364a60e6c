#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/pose.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/volume_file.h"

namespace ew {

/// A transform between two named coordinate frames as a tracker or a device set gives it ("Probe" to "Tracker").
struct FrameTransform {
  std::string from;
  std::string to;
  glm::dmat4 matrix{1.0};
  PoseStatus status = PoseStatus::ok;
  bool operator==(const FrameTransform&) const = default;
};

/// What a tracked sequence says about one frame.
struct SequenceFrame {
  std::optional<double> time_s;             ///< Timestamp; arbitrary zero, uneven, absent when the file says nothing
  PoseStatus imageStatus = PoseStatus::ok;  ///< ImageStatus, or Status in .nrrd; missing when the file says nothing about this frame
  std::vector<FrameTransform> transforms;
  std::vector<std::pair<std::string, std::string>>
      otherFields;  ///< per-frame fields the program does not know, in file order, without prefix
  bool operator==(const SequenceFrame&) const = default;
};

/// A recorded sweep: (frames x height x width) 8 bit pixels in the file's own orientation, and what each frame says.
struct Sequence {
  int width = 0;
  int height = 0;
  std::vector<SequenceFrame> frames;
  std::vector<std::uint8_t> pixels;                              ///< frames.size() * height * width, or empty for a tracker-only recording
  std::string orientation;                                       ///< UltrasoundImageOrientation: "MF", "MFA", "MN", "FM", "XX", ""
  std::string imageType;                                         ///< UltrasoundImageType: "BRIGHTNESS", "RF_REAL", ... or ""
  std::vector<std::pair<std::string, std::string>> otherFields;  ///< header fields the program does not know, in file order
  std::vector<Message> notes;                                    ///< what the reader had to decide, in sentences
  [[nodiscard]] std::span<const std::uint8_t> framePixels(std::size_t frame) const;
};

/// True when the file is a sequence rather than a volume: by `Kinds` where present, else by per-frame fields. A file whose `Kinds` end in
/// `list`, but which has a place in the world and says nothing about any frame, is a volume: such reconstructions exist.
/// @error as readSequence
[[nodiscard]] Result<bool> isSequence(const std::filesystem::path& file);

/// Whether a sequence whose pixels are not read yet is worth reading.
using SequenceCheck = std::function<Result<void>(const Sequence&)>;

/// Reads .igs.mha, .seq.mha, .mha, .mhd + raw, .igs.nrrd, .seq.nrrd, .nrrd. `beforePixels`, when given, sees what the header says and may
/// refuse before the pixels are read.
/// @error notFound, notReadable, badHeader, badField, truncated, tooLarge, unsupported, cancelled; those of `beforePixels`
[[nodiscard]] Result<Sequence> readSequence(const std::filesystem::path& file, Progress& progress = noProgress(),
                                            const ReaderLimits& limits = {}, const SequenceCheck& beforePixels = {});

/// Reads a recording of poses without pixels. Where its end is missing, because a disk was full or a program ended in the middle, the
/// frames that are whole are read, and a note says so: the last one begun may lack fields and is left out.
/// @error as readSequence; unsupported when there are pixels
[[nodiscard]] Result<Sequence> readPoseSequence(const std::filesystem::path& file, Progress& progress = noProgress(),
                                                const ReaderLimits& limits = {});

/// Writes .igs.mha (compressed), complete or not at all.
[[nodiscard]] Result<void> writeSequence(const Sequence& sequence, const std::filesystem::path& file, Progress& progress = noProgress());

/// The pixels of the next frame; empty at the end.
using NextFrame = std::function<Result<std::span<const std::uint8_t>>()>;
/// The same without all pixels in memory: they are asked for frame after frame while the file is written, and stand in it as they are.
/// @param sequence without pixels; its frames are as many as `next` will give
/// @error as above; truncated (`next` gave fewer), and those of `next`
[[nodiscard]] Result<void> writeSequence(const Sequence& sequence, const NextFrame& next, const std::filesystem::path& file,
                                         Progress& progress = noProgress());

/// What a PLUS device set says about geometry and reconstruction.
struct DeviceSet {
  std::vector<FrameTransform> transforms;  ///< CoordinateDefinitions: calibration ("Image" to "Probe") and others
  std::optional<glm::dvec3> outputSpacing_mm;
  std::optional<glm::dvec2> clipOrigin_px;
  std::optional<glm::dvec2> clipSize_px;
  std::optional<glm::dvec2> fanAngles_deg;
  std::optional<glm::dvec2> fanOrigin_px;
  std::optional<double> fanRadiusStart_px;
  std::optional<double> fanRadiusStop_px;
  std::optional<std::string> interpolation;  ///< as written: NEAREST_NEIGHBOR, LINEAR
  std::optional<std::string> compounding;    ///< as written: MEAN, MAXIMUM, LATEST (also from the older `Compounding`)
  std::vector<std::pair<std::string, std::string>>
      scanConversion;          ///< attributes of the first ScanConversion, as written: where scan lines lie
  std::string referenceFrame;  ///< ReferenceCoordinateFrame: the frame that volumes are to be made in; empty: it does not say
  std::vector<Message> notes;  ///< what was taken as not set, and what it states that is not used, in sentences
};

/// Reads a device set (PlusConfiguration), or the calibration program's result file (ProbeCalibrationResult: transforms only). Values that
/// only say that nothing is set are not values and are named in the notes: blanks and NaN, a clip rectangle without area (PLUS's own
/// default is 0 0) or without a size, two equal fan angles, a fan that ends at radius 0 or below, a spacing of 0 or below.
/// @error notFound, notReadable, tooLarge, badHeader (not XML, or neither of the two), badField
[[nodiscard]] Result<DeviceSet> readDeviceSet(const std::filesystem::path& file);

/// Several files of one recording, such as a device set and its calibration's results, as one: every transform of all of them, and of the
/// rest what the first file that has it says. Of two transforms between the same frames the earlier file's counts.
/// @error as readDeviceSet
[[nodiscard]] Result<DeviceSet> readDeviceSets(std::span<const std::filesystem::path> files);

/// What a recording itself says about its clip (ClipRectangleOrigin ... FanRadiusStopPixel of its header), in the words of a device set and
/// by the same rule of what is not set.
/// @error badField
[[nodiscard]] Result<DeviceSet> clipStatedIn(const Sequence& sequence);

/// Writes a device set with what `set` holds, complete or not at all; reading it back gives the same.
/// @error notWritable, unsupported (an ending other than .xml)
[[nodiscard]] Result<void> writeDeviceSet(const DeviceSet& set, const std::filesystem::path& file);

/// The transform from one named frame to another through any chain of the given ones (forwards or inverted); empty when there is no chain
/// of usable transforms. The shortest chain wins.
[[nodiscard]] std::optional<glm::dmat4> chain(std::span<const FrameTransform> transforms, std::string_view from, std::string_view to);

/// Names of all frames reachable from `from`, for messages.
[[nodiscard]] std::vector<std::string> reachableFrom(std::span<const FrameTransform> transforms, std::string_view from);

}  // namespace ew
