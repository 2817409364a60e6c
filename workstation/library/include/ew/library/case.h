#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/frames.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/imaging/frame.h"

namespace ew {

inline constexpr int kCaseFormat = 1;  ///< `format` of case.json; a file with a larger one is refused with newerFormat

struct CasePatient {
  std::string name;  ///< invented, never a real patient's
  std::string sex;   ///< "female", "male", "other", ""
  std::optional<int> age_years;
  bool operator==(const CasePatient&) const = default;
};

/// Where the case's volume comes from and where it lies in the mannequin.
struct CaseVolume {
  std::string file;    ///< relative to the case folder ("volumes/abdomen.mha"), or empty when a recipe makes it
  std::string labels;  ///< of a file: which tissue each voxel is (scene.tissues says what they do), on a grid of its own, or empty
  std::string recipe;  ///< virtual patient ("patient.json"), voxelised on first start into the cache; empty when there is a file
  double recipeSpacing_mm = 1.0;
  glm::dmat4 fileToWorld{1.0};  ///< rigid placement in the mannequin, mm, LPS
  bool operator==(const CaseVolume&) const = default;
};

/// The manifest of a case folder: case.json, checked against resources/schemas/case.schema.json.
struct Case {
  std::string id;  ///< UUID or slug, unique in a library
  std::string title;
  std::string region;  ///< "upper abdomen"
  CasePatient patient;
  std::string history;
  std::string indication;
  std::string diagnosis;
  CaseVolume volume;
  std::string mannequin;            ///< file in resources/mannequin or in the case folder; empty: the default
  std::vector<std::string> probes;  ///< ids; the first is the default; empty: all
  Scene scene;
  std::optional<Pose> startPose;
  nlohmann::json otherFields = nlohmann::json::object();  ///< kept as they are

  std::filesystem::path folder;  ///< where it was read from; not saved
  bool operator==(const Case&) const = default;
};

/// Opens a case folder or its case.json and checks it against the schema and every file it names.
/// @error notFound, badHeader, badField (field name, value found, value expected), newerFormat (with both version numbers), notRigid
[[nodiscard]] Result<Case> loadCase(const std::filesystem::path& folderOrManifest);

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

/// The cases in the sub-folders of `folder`, by title; folders that cannot be read come back as problems.
struct CaseList {
  std::vector<Case> cases;
  std::vector<Error> problems;
};
[[nodiscard]] CaseList listCases(const std::filesystem::path& folder);

/// What a case shows and what it is made of.
struct CaseEcho {
  Volume volume;                         ///< echo levels
  std::optional<Volume> labels;          ///< its `echo` holds a label per voxel; none when the case names no labels
  std::vector<TissueAcoustics> tissues;  ///< of the labels, by rising label, as the recipe has them; none for a label file
  std::vector<std::string> notes;
};

/// Echo and labels of a case, both placed in the world: from its files, or from its recipe by way of the cache, making them when they
/// are not there.
/// @error as readVolume, readLabelVolume, readPatient, voxelise; notWritable for the cache is recovered (noted), not an error
[[nodiscard]] Result<CaseEcho> loadCaseVolume(const Case& opened, Progress& progress);

/// The scene a case is scanned with: what its manifest says, and of each label the recipe's tissue unless the manifest has its own.
[[nodiscard]] Scene sceneWithTissues(const Scene& manifest, const std::vector<TissueAcoustics>& recipe);

/// Whether loadCaseVolume will have to make the volume first (and how long that takes is for the progress to say).
[[nodiscard]] bool caseNeedsPreparation(const Case& opened);

/// Where the program's own data are: $ECHOWEAVE_RESOURCES, beside the program, the source tree it was built from, or the installed place.
[[nodiscard]] Result<std::filesystem::path> resourceFolder();
[[nodiscard]] Result<std::filesystem::path> shippedCasesFolder();
/// $ECHOWEAVE_CACHE, else $XDG_CACHE_HOME/echoweave, else ~/.cache/echoweave.
[[nodiscard]] std::filesystem::path cacheFolder();

}  // namespace ew
