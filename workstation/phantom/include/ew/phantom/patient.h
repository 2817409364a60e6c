#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/core/volume.h"
#include "ew/phantom/body_shape.h"

namespace ew {

/// What a tissue looks like to an ultrasound machine.
struct Tissue {
  std::string name;
  double echoLevel = 0.0;  ///< mean grey level after log compression, 0..255
  double speckle = 0.0;    ///< 0: anechoic or specular; 1: fully developed
  double attenuation_dbPerCmMhz = 0.5;
  bool operator==(const Tissue&) const = default;
};

/// An implicit anatomy: named organs in the order of priority (the first that contains a point owns it), with tissues.
class Patient;

/// A label volume's value of a point outside every organ is 0; organ n of the patient's list has label n + 1.
struct OrganName {
  int label = 0;
  std::string name;
};

/// @error notFound, badHeader, badField (organ, field, value found, expected), newerFormat
[[nodiscard]] Result<std::shared_ptr<const Patient>> readPatient(const std::filesystem::path& file);

[[nodiscard]] std::vector<OrganName> organsOf(const Patient& patient);

/// Signed distance in mm (negative inside, exact near the surface within the blend radius) of a named organ, for tests and lessons.
[[nodiscard]] Result<double> signedDistance_mm(const Patient& patient, const std::string& organ, const glm::dvec3& p_world_mm);

struct VoxeliseOptions {
  double spacing_mm = 1.0;
  std::uint64_t seed = 1;  ///< of the speckle; the same patient and seed give the same voxels on every machine and thread count
  int threads = 0;
  std::uint64_t maxBytes = 16ull << 30;
};
struct VoxelisedPatient {
  Volume volume;  ///< inside the patient's stated box; coverage absent outside the skin
  std::vector<std::uint8_t> labels;
};

/// Samples the anatomy on a grid: echo with speckle, bright organ borders, shadow-free truth, and a label per voxel.
/// @error tooLarge (with the forecast), cancelled
[[nodiscard]] Result<VoxelisedPatient> voxelise(const Patient& patient, const VoxeliseOptions& options, Progress& progress);

}  // namespace ew
