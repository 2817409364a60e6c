#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/fingerprint.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/imaging/flow_field.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/tissue_maps.h"
#include "ew/imaging/tissue_motion.h"
#include "ew/library/case_values.h"
#include "ew/library/folders.h"

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

/// Opens a case folder or its case.json and checks it against the schema and every file it names. Not on a ResponsiveThread.
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

/// The same of a case, in the same sentences, without its manifest being made: what an edit is checked with. Named files are looked for in
/// `edited.folder`; empty: no file is looked for.
[[nodiscard]] std::vector<Error> checkCase(const Case& edited);

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
  std::shared_ptr<const FlowField> flow = {};     ///< blood of that tissue; null where nobody says how it flows
  std::shared_ptr<const FrameStack> frames = {};  ///< recorded images, among the voxels of `volume`; null: there are none
  bool isDraft = false;                           ///< coarser than the case asks for; see PreparationOptions::draft
};

struct PreparationOptions {
  int threads = 0;                        ///< 0: all cores; the voxels do not depend on it
  std::uint64_t maxBytes = 8ull << 30;    ///< that a step may hold
  std::filesystem::path keepSweeps = {};  ///< a folder for the recordings (NAME.igs.mha) of the sweeps that are made; empty: not kept
  /// A case whose volume would have to be made first (mayBeDrafted) comes within seconds, and nothing is kept: volume and labels with
  /// voxels kDraftCoarseness times as wide, the maps of tissue from those on the case's own grid, so that the same place has the same
  /// speckle once they are made. For images until then, and never to be judged by.
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
