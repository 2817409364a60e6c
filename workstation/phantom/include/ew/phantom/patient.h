#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/memory.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/imaging/tissue_maps.h"
#include "ew/phantom/body_shape.h"

namespace ew {

/// Slow variation of a tissue's grey level, on top of speckle.
struct TissueTexture {
  double level = 0.0;           ///< grey levels up and down
  glm::dvec3 scale_mm{10.0};    ///< size of its grains along x, y, z; with followsTheSkin along x, depth below the skin, z
  bool followsTheSkin = false;  ///< grains lie in layers parallel to the skin, as in fat and muscle
  bool operator==(const TissueTexture&) const = default;
};

/// Size of the smallest grains of a texture along its finest axis, mm; infinity without a texture. Voxels of less than half of it hold
/// the texture.
[[nodiscard]] double finestGrain_mm(const TissueTexture& texture);

/// What a tissue looks like to an ultrasound machine.
struct Tissue {
  std::string name;
  double echoLevel = 0.0;               ///< mean grey level after log compression, 0..255
  double speckle = 0.0;                 ///< 0: anechoic or specular; 1: fully developed
  double attenuation_dbPerCmMhz = 0.5;  ///< one way
  double reflection_db = 0.0;           ///< lost once, both ways together, on entering it from another tissue, 0..60
  TissueTexture texture;
  double impedance_mrayl = 1.63;                 ///< soft tissue on average (Cobbold, Foundations of Biomedical Ultrasound, 2007); 1e-4..20
  double speed_mPerS = 1540.0;                   ///< of sound, 200..6000
  std::optional<double> scatterers_perMm3 = {};  ///< number density, 0..1000; absent: as dense as the patient's field of scatterers
  bool operator==(const Tissue&) const = default;
};

/// An implicit anatomy: named organs in the order of priority (the first that contains a point owns it), with tissues.
class Patient;

/// A label volume's value of a point outside every organ is 0; organ n of the patient's list has label n + 1.
struct OrganName {
  int label = 0;
  std::string name;
};

/// The tissue that a label of voxelise stands for.
struct LabelTissue {
  int label = 0;
  std::string organ;  ///< empty for label 0, the background
  Tissue tissue;
  bool operator==(const LabelTissue&) const = default;
};

/// Values for a recipe's parameters by name; the others keep their defaults.
using ParameterValues = std::map<std::string, double>;

/// A number that whoever uses or extends the recipe may choose: the size of a finding.
struct PatientParameter {
  std::string name;
  double value = 0.0;
  double lowest = 0.0;
  double highest = 0.0;
  std::string unit;
  std::string note;
  bool operator==(const PatientParameter&) const = default;
};

/// Reads a virtual patient (resources/schemas/patient.schema.json says what it may hold). The mannequin it names gives its skin and is
/// looked for beside the recipe, in `mannequins`, in resources/mannequin of the folders above the recipe, then of $ECHOWEAVE_RESOURCES.
/// The recipe it extends is looked for in the same way, in folders named "anatomy" beside those of mannequins.
/// @error notFound, notReadable, tooLarge, badHeader, badField (organ, field, value found, expected; a parameter that is not there or out
///        of its range; recipes that extend one another in a circle; shapes that no machine could evaluate), newerFormat, cancelled
[[nodiscard]] Result<std::shared_ptr<const Patient>> readPatient(const std::filesystem::path& file,
                                                                 const std::filesystem::path& mannequins = {},
                                                                 const ParameterValues& parameters = {}, Progress& progress = noProgress());

/// The recipe's parameters by name, with the values this patient has.
[[nodiscard]] const std::vector<PatientParameter>& parametersOf(const Patient& patient);

[[nodiscard]] std::vector<OrganName> organsOf(const Patient& patient);

/// The tissues of all labels of a recipe, by rising label; nothing is built, so it is quick where the voxels are there already.
/// @error as readPatient, as far as it goes: neither shapes nor the mannequin are looked at
[[nodiscard]] Result<std::vector<LabelTissue>> readLabelTissues(const std::filesystem::path& file,
                                                                const std::filesystem::path& mannequins = {},
                                                                const ParameterValues& parameters = {});

/// The box that voxelise fills.
[[nodiscard]] Bounds boxOf(const Patient& patient);

/// The same from the recipe alone; nothing is built.
/// @error as readPatient, as far as it goes: neither anatomy nor mannequin are looked at
[[nodiscard]] Result<Bounds> readPatientBox(const std::filesystem::path& file, const std::filesystem::path& mannequins = {},
                                            const ParameterValues& parameters = {});

/// A number that changes with the recipe, what it extends, its parameters, its mannequin and the way voxels are made: the key for whoever
/// keeps voxelised patients. Reads the files without building anything.
/// @error as readPatient, as far as it goes: the fields of the anatomy are not looked at
[[nodiscard]] Result<std::uint64_t> fingerprintOfPatient(const std::filesystem::path& file, const std::filesystem::path& mannequins = {},
                                                         const ParameterValues& parameters = {});

/// Signed distance in mm (negative inside; sign exact, value first order, right near the surface) of a named organ as it was drawn,
/// without what organs of higher priority take from it. "skin surface" is the surface of the whole body.
/// @error badField when there is no such organ
[[nodiscard]] Result<double> signedDistance_mm(const Patient& patient, const std::string& organ, const glm::dvec3& p_world_mm);

/// The label voxelise gives to a voxel centred here: 0 outside every organ.
[[nodiscard]] int labelAt(const Patient& patient, const glm::dvec3& p_world_mm);

class VoxelPieces;

struct VoxeliseOptions {
  double spacing_mm = 1.0;
  std::uint64_t seed = 1;  ///< of the speckle; the same patient and seed give the same voxels on every machine and thread count
  int threads = 0;
  std::uint64_t maxBytes = kLargestVolume_bytes;
  bool maps = false;              ///< TissueMaps, too
  VoxelPieces* pieces = nullptr;  ///< of a run that was stopped, and for the next one; null: none are kept
};
struct VoxelPatient {
  Volume volume;  ///< inside the patient's stated box; coverage absent outside the skin
  std::vector<std::uint8_t> labels;
  /// When asked for: what live echoes are formed from, on the volume's grid. Reflecting surfaces are borders of organs, and boundaries of
  /// organs without one where the impedance of tissues differs enough for a grey level of 60; the skin's own surface is none of them.
  /// Distances to surfaces are right to 0.05 mm within a voxel of them; a voxel beside the rim of a surface has none.
  std::optional<TissueMaps> maps = {};
};

/// Samples the anatomy on a grid: echo with speckle, bright organ borders, shadow-free truth, and a label per voxel.
/// Speckle is the envelope of a complex scatterer field, hashed from seed and voxel, behind an isotropic point spread function of one
/// voxel standard deviation, log compressed at 60 dB over 255 grey levels (so fully developed speckle spreads by 23.7 levels).
/// Nothing casts a shadow: shadows belong to the view, not to the volume (Aiger and Cohen-Or 1998, "Shadows").
/// @error badField (spacing), tooLarge (with the forecast), cancelled (within 0.1 s)
[[nodiscard]] Result<VoxelPatient> voxelise(const Patient& patient, const VoxeliseOptions& options, Progress& progress);

/// The grid that voxelise makes of a patient: over its whole box.
[[nodiscard]] Grid voxelGridOf(const Patient& patient, double spacing_mm);

/// Bytes that voxelise holds at its peak at this spacing.
[[nodiscard]] double voxeliseForecast_bytes(const Patient& patient, double spacing_mm, bool maps = false);

}  // namespace ew
