#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/compounding.h"
#include "ew/core/frames.h"
#include "ew/core/pose.h"
#include "ew/imaging/scene.h"

// A case as a value: what library reads from case.json and writes there (case.h), and what crosses the plugins' door.
namespace ew {

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
  std::string when;                      ///< in words: "two years ago"
  std::string kind;                      ///< "ultrasound", "laboratory" ...
  std::string findings;                  ///< what it said
  std::vector<std::string> images = {};  ///< files of the case folder ("media/2019-liver.png")
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
struct SealReference {
  std::string file;    ///< in the case folder: "answers.sealed"
  std::string sha256;  ///< of that file, 64 hexadecimal digits
  bool operator==(const SealReference&) const = default;
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
  std::optional<Pose> expertPose;                         ///< where an expert would have the finding in the image
  std::optional<SealReference> sealed = {};               ///< of an examination: nothing that trainees may not read is in the other fields
  nlohmann::json otherFields = nlohmann::json::object();  ///< kept as they are

  std::filesystem::path folder;  ///< where it was read from; not saved
  bool operator==(const Case&) const = default;
};

/// What a trainee reads on cards, in the header and in lists: the title for trainees, or the title when the case has none.
[[nodiscard]] const std::string& titleForTrainees(const Case& shown);

[[nodiscard]] const char* nameOf(CaseTarget::Kind kind);  ///< the word of case.json: "plane"

/// Whether a case has neither a file nor a recipe. It opens, and says that it has no volume.
[[nodiscard]] bool hasNoVolume(const Case& opened);

}  // namespace ew
