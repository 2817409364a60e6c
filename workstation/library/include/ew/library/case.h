#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/acquisition/reconstruct.h"
#include "ew/core/fingerprint.h"
#include "ew/core/frames.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/tissue_maps.h"
#include "ew/imaging/tissue_motion.h"
#include "ew/library/folders.h"
#include "ew/stitching/join.h"

namespace ew {

class FrameStack;

/// A hidden folder of the case's own, for files that were taken out of it (case_contents.h): not published, not exported, not copied with
/// the case, and never emptied here.
inline constexpr const char* kWithdrawnFiles = ".withdrawn";

/// `format` of case.json. A file with a larger one is refused with newerFormat; one with a smaller is read as if it had been written today,
/// and saved so. 2: laboratory findings are a list of their own (1: examinations of the kind "laboratory"). 3: examinations, whose answers
/// are sealed; other cases are saved with 2, so that programs that know no examinations go on reading them.
inline constexpr int kCaseFormat = 3;
inline constexpr int kOpenCaseFormat = 2;

struct CasePatient {
  std::string name;  ///< invented, never a real patient's
  std::string sex;   ///< "female", "male", "other", ""
  std::optional<int> age_years;
  bool operator==(const CasePatient&) const = default;
};

/// How the virtual sweeps of a case become its volume: each is reconstructed as a user's recording is, then they are joined by the chain of
/// stitching (ew/stitching/chain.h).
struct CaseReconstruction {
  // What a case leaves open is answered as for a user's recording (defaultsFor).
  std::optional<double> spacing_mm = {};  ///< of the volume, 0.1 to 10
  std::optional<Interpolation> interpolation = {};
  std::optional<Compounding> compounding = {};  ///< weighted: by beam-wise confidence
  std::optional<double> fillReach_mm = {};      ///< holes between measured voxels at most this far apart are filled, 0 to 30
  stitching::SeamMethod seam = stitching::SeamMethod::feather;  ///< how sweeps are joined where they overlap (decision 0027)
  double feather_mm = 10.0;       ///< of SeamMethod::feather: over which a sweep fades in from its border, 0 to 100
  double labelsSpacing_mm = 1.6;  ///< of the label volume, which comes from the patient's truth, 0.1 to 10
  bool operator==(const CaseReconstruction&) const = default;
};

/// Where the case's volume comes from and where it lies in the mannequin.
struct CaseVolume {
  std::string file;    ///< relative to the case folder ("volumes/abdomen.mha"), or empty when a recipe makes it
  std::string labels;  ///< of a file: which tissue each voxel is (scene.tissues says what they do), on a grid of its own, or empty
  std::string frames;  ///< of a file: the recorded images it was made of (.igs.mha), so that slices are as sharp as they, or empty
  std::string level;   ///< of a file: the mean echo of its tissue (imaging/tissue_level.h), on a grid of its own, or empty: no live echoes
  std::string recipe;  ///< virtual patient ("patient.json"), made into a volume on first start, in the cache; empty when there is a file
  double recipeSpacing_mm = 1.0;    ///< of a recipe without sweeps: it is voxelised as it is, without views, shadows or speckle of a probe
  std::vector<std::string> sweeps;  ///< virtual sweeps of the recipe ("sweeps/subcostal.json"), recorded, reconstructed and stitched
  CaseReconstruction reconstruct;
  Transform<frame::World, frame::File> fileToWorld = {};  ///< rigid placement in the mannequin, mm, LPS
  bool operator==(const CaseVolume&) const = default;
};

/// What was examined before this examination.
struct CaseExamination {
  std::string when;                        ///< in words: "two years ago"
  std::string kind;                        ///< "ultrasound", "laboratory" ...
  std::string findings;                    ///< what it said
  std::vector<std::string> pictures = {};  ///< files of the case folder ("media/2019-liver.png")
  nlohmann::json otherFields = nlohmann::json::object();
  bool operator==(const CaseExamination&) const = default;
};

/// Values from the laboratory.
struct CaseLaboratory {
  std::string when;      ///< in words: "last month"
  std::string findings;  ///< "Bilirubin 12 umol/l"
  nlohmann::json otherFields = nlohmann::json::object();
  bool operator==(const CaseLaboratory&) const = default;
};

/// What a trainee is to find. Points and planes are in the world of the patient or file, before file_to_world.
struct CaseTarget {
  enum class Kind { point, plane, structure };
  Kind kind = Kind::structure;
  std::string name;
  std::optional<glm::dvec3> at_mm = {};                                  ///< of a point
  std::optional<double> tolerance_mm = {};                               ///< of a point
  std::optional<Transform<frame::File, frame::Probe>> probeToFile = {};  ///< of a plane; absent: the patient's standard plane of that name
  std::optional<double> positionTolerance_mm = {};                       ///< of a plane; absent: the standard plane's
  std::optional<double> angleTolerance_deg = {};                         ///< of a plane; absent: the standard plane's
  std::string organ = {};                                                ///< of a structure: an organ of the patient
  std::optional<int> label = {};                                         ///< of a structure: its number in volume.labels, 1 to 255
  bool revealsFinding = false;  ///< its name gives a finding away: a trainee sees it with the findings
  nlohmann::json otherFields = nlohmann::json::object();
  bool operator==(const CaseTarget&) const = default;
};

/// A measurement that is expected of a trainee. Its value stands in the case, or a virtual patient knows it (see CaseTruth).
struct CaseMeasurement {
  std::string name;                        ///< without a value: of a measurement of the patient
  std::optional<double> tolerance = {};    ///< in the measurement's unit
  std::optional<double> value = {};        ///< in `unit`, as the author measured it; absent: the patient's
  std::string kind = {};                   ///< with a value: "distance", "circumference", "area", "angle"
  std::string unit = {};                   ///< with a value: "mm", "cm2", "deg" ...
  std::vector<glm::dvec3> points_mm = {};  ///< where the author's calipers stood, before file_to_world
  bool revealsFinding = false;             ///< its name gives a finding away: a trainee sees it with the findings
  nlohmann::json otherFields = nlohmann::json::object();
  bool operator==(const CaseMeasurement&) const = default;
};

/// Of an examination: where everything is that its trainees may not read (sealed_answers.h).
struct SealedReference {
  std::string file;    ///< in the case folder: "answers.sealed"
  std::string sha256;  ///< of that file, 64 hexadecimal digits
  bool operator==(const SealedReference&) const = default;
};

/// The manifest of a case folder: case.json, checked against resources/schemas/case.schema.json.
struct Case {
  std::string id;                ///< UUID or slug, unique in a library
  std::string title;             ///< for authors and instructors: may name the finding
  std::string titleForTrainees;  ///< what a trainee may read before the examination ("Upper abdomen, pain after meals"); empty: the title
  std::string region;            ///< "upper abdomen"
  CasePatient patient;
  std::string complaint;  ///< why the patient came, in the patient's words
  std::string history;
  std::string indication;
  std::vector<CaseExamination> previousExaminations;
  std::vector<CaseLaboratory> laboratory;
  std::vector<std::string> findings;  ///< what a good report of this examination says, a sentence each
  std::string diagnosis;
  std::vector<std::string> differential;  ///< what else it could have been, likeliest first
  std::optional<int> difficulty;          ///< 1 (first steps) to 5 (examination)
  std::vector<std::string> tags;          ///< by which it is found; a trainee may read them
  std::vector<CaseTarget> targets;
  std::vector<CaseMeasurement> measurements;
  CaseVolume volume;
  std::string mannequin;            ///< file in resources/mannequin or in the case folder; empty: the default
  std::vector<std::string> probes;  ///< ids; the first is the default; empty: all
  Scene scene;
  std::optional<Pose> startPose;                          ///< where a trainee begins; gives no finding away
  std::optional<Pose> expertPose;                         ///< where an expert would have the finding in the picture
  std::optional<SealedReference> sealed = {};             ///< of an examination: nothing that trainees may not read is in the other fields
  nlohmann::json otherFields = nlohmann::json::object();  ///< kept as they are

  std::filesystem::path folder;  ///< where it was read from; not saved
  bool operator==(const Case&) const = default;
};

/// What a trainee reads on cards, in the header and in lists: the title for trainees, or the title when the case has none.
[[nodiscard]] const std::string& titleForTrainees(const Case& shown);

/// Opens a case folder or its case.json and checks it against the schema and every file it names.
/// @error notFound, badHeader, badField (field name, value found, value expected), newerFormat (with both version numbers), notRigid
[[nodiscard]] Result<Case> loadCase(const std::filesystem::path& folderOrManifest);

/// A case and what its case.json held when it was read: whoever edits it for a while can tell whether somebody else has saved it since.
struct CaseAsRead {
  Case opened;
  Fingerprint manifest;
};
/// @error as loadCase
[[nodiscard]] Result<CaseAsRead> readCase(const std::filesystem::path& folderOrManifest);

/// What case.json of a case holds now. @error notFound, notReadable, tooLarge
[[nodiscard]] Result<Fingerprint> manifestFingerprint(const std::filesystem::path& folderOrManifest);

/// All problems of a case at once, each a sentence; empty when it is valid.
[[nodiscard]] std::vector<Error> validateCase(const std::filesystem::path& folderOrManifest);

/// A case from the JSON of its manifest, with the checks of loadCase.
/// @param folder the case folder, against which named files are checked; empty: no file is looked for (a new case, not saved yet)
/// @error badField, newerFormat, notRigid, notFound
[[nodiscard]] Result<Case> caseFromManifest(const nlohmann::json& manifest, const std::filesystem::path& folder);

/// The manifest of a case, unknown fields included: caseFromManifest(manifestOf(c), c.folder) == c.
[[nodiscard]] nlohmann::json manifestOf(const Case& edited);

/// All problems of a manifest at once, each a sentence with the context "field"; empty when caseFromManifest takes it.
[[nodiscard]] std::vector<Error> checkManifest(const nlohmann::json& manifest, const std::filesystem::path& folder);

/// A relative path of a manifest as a path on disk.
/// @param field how the sentences call it ("volume.file")
/// @error badField when it is empty, absolute, contains "..", or leaves the folder through a symbolic link; notFound
[[nodiscard]] Result<std::filesystem::path> fileOfCase(const std::filesystem::path& folder, const std::string& relative,
                                                       const std::string& field);

/// Saves case.json, aside first, synced, renamed: a crash leaves the old or the new one, never half of one. When `folder` is not the
/// folder the case came from, everything in that folder is copied first; the new folder appears complete or not at all.
/// @error notWritable (also when `folder` holds something else already), badField (what loadCase would refuse)
[[nodiscard]] Result<void> saveCase(const Case& edited, const std::filesystem::path& folder);

/// A good id for a case that is saved as `folder`: the folder's name in small letters, with '-' for what an id may not hold, and a number
/// behind it when a case beside it has that id already.
[[nodiscard]] std::string idForFolder(const std::filesystem::path& folder);

/// The cases in the sub-folders of `folder`, by title; folders that cannot be read come back as problems, each with its name.
struct CaseList {
  std::vector<Case> cases;
  std::vector<Error> problems;
  std::vector<std::filesystem::path> noCases;  ///< sub-folders without a case.json, but for hidden ones; sorted
};
[[nodiscard]] CaseList listCases(const std::filesystem::path& folder);

/// What a case shows and what it is made of.
struct CaseEcho {
  Volume volume;                         ///< echo levels
  std::optional<Volume> labels;          ///< its `echo` holds a label per voxel; none when the case names no labels
  std::shared_ptr<TissueMaps> tissue;    ///< what live echoes are formed from; null for a file without a level
  std::shared_ptr<TissueMotion> motion;  ///< of that tissue; null where the patient does not move
  std::vector<TissueAcoustics> tissues;  ///< of the labels, by rising label, as the recipe has them; none for a label file
  std::vector<Message> notes;
  std::shared_ptr<const FrameStack> frames = {};  ///< recorded images, among the voxels of `volume`; null: there are none
  bool isDraft = false;                           ///< coarser than the case asks for; see PreparationOptions::draft
};

struct PreparationOptions {
  int threads = 0;                        ///< 0: all cores; the voxels do not depend on it
  std::uint64_t maxBytes = 8ull << 30;    ///< that a step may hold
  std::filesystem::path keepSweeps = {};  ///< a folder for the recordings (NAME.igs.mha) of the sweeps that are made; empty: not kept
  /// A case whose volume would have to be made first (mayBeDrafted) comes within seconds, and nothing is kept: volume and labels with
  /// voxels kDraftCoarseness times as wide, the maps of tissue from those on the case's own grid, so that the same place has the same
  /// speckle once they are made. For pictures until then, and never to be judged by.
  bool draft = false;
};
inline constexpr int kDraftCoarseness = 3;
/// Whether a draft comes sooner than the volume itself: a recipe without sweeps that is not prepared and takes its time.
[[nodiscard]] bool mayBeDrafted(const Case& opened);

/// Echo, labels and maps of tissue of a case, all placed in the world: from its files, or from its recipe by way of the cache, making them
/// when they are not there (see preparation.h).
/// @error as readVolume, readLabelVolume, readPatient, voxelise, readSweepRecipe, recordSweep, openSweep, makeSweepVolume, runChain;
/// cancelled (within 0.5 s);
///        notWritable for the cache is recovered (noted), not an error
[[nodiscard]] Result<CaseEcho> loadCaseVolume(const Case& opened, Progress& progress, const PreparationOptions& options = {});

/// The labels alone, as loadCaseVolume has them: of a recipe without sweeps they are made without its echoes, in seconds, and kept in the
/// cache; of one with sweeps the volume is made first. Empty: the case has none.
/// @error as loadCaseVolume
[[nodiscard]] Result<std::optional<Volume>> loadCaseLabels(const Case& opened, Progress& progress, const PreparationOptions& options = {});

/// The scene a case is scanned with: what its manifest says, and of each label the recipe's tissue unless the manifest has its own.
[[nodiscard]] Scene sceneWithTissues(const Scene& manifest, const std::vector<TissueAcoustics>& recipe);

/// Whether loadCaseVolume will have to make the volume first; estimatePreparation says how long that takes.
[[nodiscard]] bool caseNeedsPreparation(const Case& opened);

}  // namespace ew
