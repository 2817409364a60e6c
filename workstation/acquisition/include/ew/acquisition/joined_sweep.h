#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/io/sequence.h"
#include "ew/io/volume_file.h"

namespace ew {

// A recording whose images and poses lie in two files, as a film and the log of a tracker.

/// The poses: a table (.csv, .tsv, .txt, see readPoseTable), else a tracked sequence, whose own images are not used.
/// @error as readPoseTable and readSequence; noValidPose (a sequence without transforms); unsupported (another ending)
[[nodiscard]] Result<Sequence> readPoses(const std::filesystem::path& file, Progress& progress = noProgress(),
                                         const ReaderLimits& limits = {});

/// Refuses poses that lead from Image without scaling, as those of quaternions do, beside a device set that says how large a pixel is: they
/// come before its calibration, and would make each pixel 1 mm.
/// @param name of the poses' file, for sentences
/// @error badField
[[nodiscard]] Result<void> checkPixelsOf(const Sequence& poses, const DeviceSet& device, const std::filesystem::path& name);

/// The images: a sequence, a film, a DICOM cine, a TIFF, a folder of images, or a volume, each slice of which is an image. Films and
/// images come upright and with square pixels, grey; a sequence comes as it is, with the poses it may have.
/// @param rate_hz      of the images, in place of the times that the file states; a sequence may be without both
/// @param beforePixels of a sequence, see readSequence
/// @error as readSequence, readVolume and CineReader; badField (no times and no rate; "ask": "rate"), tooLarge, cancelled
[[nodiscard]] Result<Sequence> readImages(const std::filesystem::path& file, const std::optional<double>& rate_hz,
                                          Progress& progress = noProgress(), const ReaderLimits& limits = {},
                                          const SequenceCheck& beforePixels = {});

/// Times the images evenly from 0 on. @param rate_hz above 0
void timeEvenly(Sequence& images, double rate_hz);

/// Gives each image the poses of its moment: the image of time t has those of t + offset_s, read between two neighbours (places along a
/// line, attitudes by the shortest way), never across more than three usual steps or a pose that is not valid. Images for which there is
/// none have their pose marked invalid. Of transforms that both state, those of `poses` count.
/// @param offset_s by which the poses' clock is ahead, so by how much poses lag behind images; positive: an image has a later pose
/// @param name     of the poses' file, for sentences
/// @return notes: what was joined, how many images have no pose and why
/// @error badField (an image or a pose without a time, times of poses that run backwards, poses around an image that lie more than 1 s and
///        more than ten steps of the images apart), noValidPose (no moment in common; both ranges
///        are named, "ask": "time-offset")
[[nodiscard]] Result<std::vector<Message>> joinPoses(Sequence& images, const Sequence& poses, double offset_s,
                                                     const std::filesystem::path& name);

}  // namespace ew
