#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ew/acquisition/import.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/library/case.h"
#include "ew/library/file_import.h"
#include "ew/library/placing.h"
#include "ew/library/probe_side.h"

namespace ew {

/// A volume in a file: .mha, .mhd, .nrrd, .nii, DICOM, Kretz, images; whatever importFile reads.
struct VolumeFile {
  std::filesystem::path file;
  ImportAnswers answers = {};                ///< what the file does not say (askedFor tells what is missing)
  std::optional<VolumeSide> probeSide = {};  ///< from which it was scanned, in the file's own frame; absent: nobody said it
};

/// A tracked recording, which is reconstructed as the window's import does it, with the confidence in its echoes.
struct SweepFile {
  std::filesystem::path file;
  std::optional<double> spacing_mm = {};   ///< of a voxel, 0.1 to 10; absent: as fine as the frames carry
  std::filesystem::path calibration = {};  ///< device set; empty: the recording says everything itself
  std::optional<Clip> clip = {};           ///< which pixels are image; absent: as device set or recording say
  bool acceptsSmall = false;               ///< makes it also when there is something to ask about it (checkMeant)
  int framesEvery = 0;                     ///< keeps every so many of its images beside the volume, as sharp as they were; 0: none
  bool looksForFan = true;                 ///< when nobody says it: the fan that is found in the images (fanOf); else whole frames
};

/// A stitch project (.json), which is stitched, or what stitching made of one: its folder, or the volume.mha in it.
struct StitchingResult {
  std::filesystem::path file;
  std::optional<VolumeSide> probeSide = {};  ///< as of VolumeFile
};

/// A volume that was made here and lies in no file yet: what is on screen.
struct VolumeAtHand {
  std::shared_ptr<const Volume> volume;      ///< in its own frame; not null
  std::optional<SweepAxes> axes = {};        ///< of the recording it was made of
  std::optional<VolumeSide> probeSide = {};  ///< as of VolumeFile, where `axes` does not say it
};

/// monostate: a case without a volume, which can be given one later.
using CaseSource = std::variant<std::monostate, VolumeFile, SweepFile, StitchingResult, VolumeAtHand>;

/// What a file is as a source of a case: a sweep, a stitching result, or a volume.
/// @error as kindOfFile; unsupported for what is none of them
[[nodiscard]] Result<CaseSource> sourceOf(const std::filesystem::path& file);

/// What a new case is made of.
struct NewCase {
  std::string title;
  std::string titleForTrainees;
  std::string region;
  std::string templateId;  ///< of listTemplates(); empty: none. What is empty or absent here is taken from it
  CaseSource source;
  /// Where the volume lies; absent: at the usual place of the region on the mannequin (firstPlacement), or as its file says where the
  /// mannequin has no named places.
  std::optional<Transform<frame::World, frame::File>> fileToWorld;
  std::string mannequin;  ///< empty: the template's, or the default
  std::string attribution;
  std::string licence;
  bool makesLevel = true;  ///< for live echoes; false: the image stays the recorded one
};

struct NewCasePlan {
  Grid grid;                 ///< of the volume in its own file; no voxels when there is no volume, or for a project that is to be stitched
  SweepAxes axes;            ///< of the recording; SweepAxes' own where nobody knows them
  bool asksForSide = false;  ///< nobody says from which side the volume was scanned
  std::optional<ProbeSide> proposedSide = {};  ///< then: what its voxels suggest; absent where it is too large to be looked at before
  Volume seen = {};                            ///< then: its voxels thinned to at most 96 along each edge, for middleImage
  std::uint64_t bytes = 0;                     ///< memory at the peak
  std::uint64_t disk_bytes = 0;                ///< that the case may take at most; volumes are compressed
  double seconds = 0.0;                        ///< about, on this machine
  std::vector<Message> notes = {};
};

/// What making a case will take, before it is made. Reads headers, and of a sweep its frames.
/// @error as makeCase, as far as it goes
[[nodiscard]] Result<NewCasePlan> planCase(const NewCase& wanted, Progress& progress = noProgress());

/// The same of a source alone, before anybody has said what the case is about. @error as planCase
[[nodiscard]] Result<NewCasePlan> planOfSource(const CaseSource& source, Progress& progress = noProgress());

/// A case that was made, and what is to be told about it.
struct CaseCreation {
  Case made;  ///< with its folder
  std::vector<Message> notes = {};
  std::optional<SweepCounts> frames = {};  ///< of a sweep
  std::optional<Contact> contact = {};     ///< of the placed volume with the mannequin's skin, where both are known
};

/// Makes a case folder with case.json, its volume and the level for live echoes. The folder appears complete or not at all, also when the
/// program is killed meanwhile.
/// @param folder new, or empty; the case's id is made from its name
/// @error notWritable (the folder holds something), badField (no title, an unknown template, a licence or attribution that is too long),
///        as openSweep and importSweep, importFile, addVolumeFile, runChain, levelOf; tooLarge; cancelled within 0.5 s
[[nodiscard]] Result<CaseCreation> makeCase(const NewCase& wanted, const std::filesystem::path& folder, Progress& progress = noProgress());

/// A case with another volume. case.json is not written: whoever edits the case saves it, or leaves it.
struct VolumeReplacement {
  Case edited;                       ///< the same case; targets and measurements that only the old volume knew are left out
  std::size_t lostTargets = 0;       ///< that were left out
  std::size_t lostMeasurements = 0;  ///< the same of measurements
  std::vector<Message> notes = {};
};

/// Puts a volume into the folder of a case, beside what is there (files are named by their content), for a case that has none or that is
/// to have another. The placement stays when there was a volume; else it is as makeCase chooses it.
/// @param opened with its folder, which is the author's own
/// @error as makeCase; badUsage (a source without a volume)
[[nodiscard]] Result<VolumeReplacement> giveVolume(const Case& opened, const CaseSource& source, Progress& progress = noProgress());

/// Whom to name for the recording, and under which licence it may be passed on; they stand in Case::otherFields.
struct RecordingRights {
  std::string attribution;
  std::string licence;
  bool operator==(const RecordingRights&) const = default;
};
[[nodiscard]] RecordingRights rightsOf(const Case& opened);
[[nodiscard]] Case withRights(Case edited, const RecordingRights& rights);

}  // namespace ew
