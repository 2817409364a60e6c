#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ew/acquisition/confidence.h"
#include "ew/acquisition/motor_sweep.h"
#include "ew/acquisition/reconstruct.h"
#include "ew/acquisition/temporal_offset.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/io/retention.h"
#include "ew/io/sequence.h"
#include "ew/io/sweep.h"

namespace ew {

/// For SweepImportOptions::motor: the fields of the recording itself describe the motor.
inline constexpr const char* kRecordedMotor = "recorded";

/// Which choices of a reconstruction nobody made: they are the recording's own, see defaultsFor. The window, the command, stitching and
/// whoever else makes a volume of a recording leave them to it.
struct SweepDefaults {
  bool spacing = false;
  bool interpolation = false;
  bool compounding = false;
  bool fillReach = false;
};

/// How a recorded sweep becomes a volume. The defaults need no knowledge of the recording; what a device set says about geometry is used
/// where the switches below allow it, and what was used is in the plan.
struct SweepImportOptions {
  std::vector<std::filesystem::path> calibrations;  ///< device sets (.xml) of the recording; none: the recording says everything itself
  std::string toFrame;                              ///< the file's name of the frame that becomes the world; empty: see sweepPoses
  ReconstructOptions reconstruct = {};              ///< its clip is replaced when the device set has one and clipFromCalibration is on
  bool clipFromCalibration = true;                  ///< clip rectangle and fan of the device set
  bool looksForFan = false;                         ///< in the images themselves, when nobody says which part of them is image
  SweepDefaults usual = {};                         ///< what is taken from defaultsFor instead of from `reconstruct`
  std::optional<int> fillReach_voxels;              ///< voxels of the spacing that will be used; replaces reconstruct.fillReach_mm
  ConfidenceOptions confidence = {};                ///< with Compounding::weighted: how the weight of each pixel is found
  std::string motor = {};                      ///< where poses come from a motor: its file, or kRecordedMotor; empty: the tracker's poses
  std::optional<MotorSweep> statedMotor = {};  ///< the motor as a person said it, in place of a file
  std::filesystem::path poses = {};            ///< where poses lie in a file of their own (readPoses); they are joined by time (joinPoses)
  std::optional<double> imageRate_hz = {};     ///< with `poses`: images a second, in place of the times that they state
  std::optional<double> poseDelay_s = {};      ///< poses lag behind images by this much; they are moved in time (see posesDelayedBy)
  bool acceptsSmall = false;       ///< a volume is made also when there is something to ask about it (ImportPlan::smallQuestion)
  bool estimatePoseDelay = false;  ///< find that out; when nobody can tell, poses stay, and the plan says so
};

struct SweepCounts {
  std::size_t total = 0;    ///< frames in the file
  std::size_t used = 0;     ///< frames with a usable pose
  std::size_t invalid = 0;  ///< frames whose image or pose is marked invalid or cannot be used
  std::size_t missing = 0;  ///< frames about which the file does not say enough
};

/// What an import will make, known before any large memory is taken.
struct ImportPlan {
  Grid grid;
  std::uint64_t bytes = 0;       ///< at the peak: frames, confidence maps, volume, coverage and what the reconstruction needs beside them
  std::uint64_t frameBytes = 0;  ///< of these: the frames
  bool fits = true;              ///< bytes <= reconstruct.maxBytes; importSweep refuses otherwise
  SweepCounts frames;
  std::string toFrame;             ///< the frame of the recording that becomes the world
  ReconstructOptions reconstruct;  ///< as it will be done, after what the device set said
  ConfidenceOptions confidence;    ///< used when reconstruct.compounding is weighted
  std::vector<Message> notes;      ///< what had to be decided, in sentences
  Retention kept = {};             ///< pixels of the clip, frames with a pose
  Message smallQuestion = {};      ///< what there is to ask about `kept`, or about sizes that can hardly be meant, before the volume
                                   ///< is made; empty: nothing
  bool acceptsSmall = false;       ///< a person said yes to it; without, importSweep and weighedFrames refuse
  std::optional<PoseDelay> poseDelay = {};  ///< when it was asked for: given, or estimated with its uncertainty and verdict
};

/// A sweep that has been read and planned, but not yet reconstructed, so that a user can be asked before a huge one.
struct SweepInput {
  Sequence sequence;  ///< images turned to orientation MF: x towards the marker, y away from the probe
  SweepPoses poses;
  ImportPlan plan;
  double readSeconds = 0.0;
  std::filesystem::path sweep = {};            ///< the file
  std::vector<Message> readNotes = {};         ///< of the file, what it holds and what was converted
  std::vector<Message> turnNotes = {};         ///< how its images were turned
  std::optional<Clip> sectorOfScanLines = {};  ///< when the file holds scan lines: the part of the images they were converted to
  std::vector<SequenceFrame> ownFrames = {};   ///< as the file of the images has them, where poses of another were joined; else empty
};

struct SweepImport {
  ReconstructResult reconstruction;  ///< the volume, its coverage, counts of voxels and pixels, seconds of pasting and filling
  ImportPlan plan;
};

/// The fan that the images of a recording fill, found in them (see findScreen); nothing where they fill their frames, or are too dark or
/// too still to tell. Looks at 60 frames at most.
/// @param sequence turned to MF, with pixels
/// @error cancelled (within 0.5 s)
[[nodiscard]] Result<std::optional<ClipFan>> fanOf(const Sequence& sequence, Progress& progress = noProgress());

/// Reads a sweep, its poses and, where given, its device set, and works out grid and memory. With `options.poses` the images may be of any
/// kind that readImages knows, and their poses are joined by time.
/// Images recorded mirrored or upside down (UN, MN, ...) are turned to MF, with a note; clip and calibration count pixels in MF.
/// @error as readSequence, readDeviceSet, sweepPoses and gridFor (but a volume over maxBytes is not an error here: see `fits`);
///        readImages, readPoses and joinPoses; badUsage (poses of a file and of a motor);
///        unsupported (no images, RF data), lineGeometryOf (scan lines, which are
///        converted to images first); badField (an OutputSpacing, interpolation or compounding of the
///        device set that cannot be used)
[[nodiscard]] Result<SweepInput> openSweep(const std::filesystem::path& sweep, const SweepImportOptions& options, Progress& progress);

/// Poses, delay, grid and memory of an opened sweep anew, with other options, without reading the file again. After an error `opened` has
/// its frames and can be planned once more; importSweep needs a plan that succeeded.
/// @param opened not of scan lines, whose images depend on the calibration: such a sweep is opened again (sectorOfScanLines says so)
/// @error as openSweep, but for reading
[[nodiscard]] Result<void> planAgain(SweepInput& opened, const SweepImportOptions& options, Progress& progress);

/// The one answer to how a recording becomes a volume when nobody says: for each choice of `usual` what the device set says (OutputSpacing,
/// Interpolation, CompoundingMode), else what the frames carry (carriedSpacing_mm), linear and mean; holes as far as usualFillReach_mm.
/// @param frames      of the recording, those with a pose
/// @param calibration its device set; null: there is none
/// @param said        what was chosen; returned with the choices of `usual` made
/// @error badField (an OutputSpacing, interpolation or compounding of the device set that cannot be used, when it is asked for)
[[nodiscard]] Result<ReconstructOptions> defaultsFor(std::span<const TrackedFrame> frames, const DeviceSet* calibration,
                                                     const SweepDefaults& usual, const ReconstructOptions& said,
                                                     std::vector<Message>& notes);

/// The frames of an opened sweep that have a pose, in order; they look into its pixels.
[[nodiscard]] std::vector<TrackedFrame> posedFrames(const SweepInput& opened);

/// Refuses a sweep about which there is something to ask (ImportPlan::smallQuestion) that nobody said yes to.
/// @error unsupported, with the context entry "ask": "accept-small"
[[nodiscard]] Result<void> checkMeant(const SweepInput& opened);

/// Frames as the plan wants them: with Compounding::weighted each looks into the map of its confidence, which lives beside it. May be
/// moved, but a copy would look into the maps of the original.
struct ConfidenceFrames {
  std::vector<TrackedFrame> frames;
  std::vector<Image<std::uint8_t>> confidence;  ///< one for each frame, or none
};

/// The frames of posedFrames, weighed by confidence when the plan's compounding is weighted.
/// @error as confidenceOfFrames and checkMeant
[[nodiscard]] Result<ConfidenceFrames> weighedFrames(const SweepInput& opened, Progress& progress);

/// Bytes at the peak of an import of the plan's sweep onto `grid` with `options`, as ImportPlan::bytes counts them.
[[nodiscard]] std::uint64_t importBytes(const ImportPlan& plan, const Grid& grid, const ReconstructOptions& options);

/// Reconstructs an opened sweep. The sweep is given up, so that its frames are freed with it.
/// @error as reconstruct and weighedFrames; tooLarge when the plan does not fit
[[nodiscard]] Result<SweepImport> importSweep(SweepInput opened, Progress& progress);

}  // namespace ew
