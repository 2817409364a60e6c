#pragma once

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "ew/phantom/virtual_scanner.h"
#include "recipes.h"
#include "shipped_probe.h"

namespace ew::testing {

/// A patient who is a block of tissue below y = 0 with `organs` in it. Tissues: "even" (level 150, 0.5 dB/cm/MHz) all around, "brighter"
/// and "darker" by 6 dB, "water" (silent, nothing lost), "stone" (loses 30 dB on entering) and whatever `extra` adds.
inline std::shared_ptr<const Patient> blockOfTissue(const std::string& organs = "", const std::string& extra = "") {
  const std::string everything = R"({"ellipsoid": {"centre_mm": [0, 2000, 0], "radii_mm": [2000, 2000, 2000]}})";
  const std::string recipe = R"({"format": 1, "name": "block", "mannequin": "block.json",
    "box": {"lowest_mm": [-40, -5, -40], "highest_mm": [40, 75, 40]},
    "tissues": [{"name": "even", "echo_level": 150, "speckle": 1}, {"name": "brighter", "echo_level": 175.5, "speckle": 1},
      {"name": "darker", "echo_level": 124.5, "speckle": 1},
      {"name": "water", "echo_level": 0, "speckle": 0, "attenuation_db_per_cm_mhz": 0},
      {"name": "stone", "echo_level": 100, "speckle": 1, "attenuation_db_per_cm_mhz": 0, "reflection_db": 30})" +
                             (extra.empty() ? "" : ", " + extra) + R"(], "background": "even", "organs": [)" +
                             (organs.empty() ? R"({"name": "nothing", "tissue": "even",
      "shape": {"ellipsoid": {"centre_mm": [0, -900, 0], "radii_mm": [1, 1, 1]}}})"
                                             : organs) +
                             "]}";
  const Folder folder;
  folder.write("block.json", bodyRecipe(everything));
  auto patient = readPatient(folder.write("patient.json", recipe));
  if (!patient) {
    ADD_FAILURE() << patient.error();
    std::abort();
  }
  return *patient;
}

inline std::unique_ptr<VirtualScanner> scannerOf(std::shared_ptr<const Patient> patient, const Probe& probe,
                                                 const FormationOptions& options, std::uint64_t seed = 1) {
  auto scanner = makeVirtualScanner(std::move(patient), probe, options, seed);
  if (!scanner) {
    ADD_FAILURE() << scanner.error();
    std::abort();
  }
  return std::move(*scanner);
}

/// Neither losses nor noise: what is left is scatterers and the point spread function.
inline FormationOptions onlySpeckle(double depth_mm) {
  FormationOptions options;
  options.depth_mm = depth_mm;
  options.attenuation = false;
  options.specular = false;
  options.noise_db = -300.0;
  return options;
}

/// The face `lift_mm` deep in the block, moved along elevation and turned about the lateral axis.
inline Transform<frame::World, frame::Probe> held(double elevation_mm = 0.0, double rotation_rad = 0.0,
                                                  const glm::dvec3& at_mm = {0, 2, 0}) {
  Transform<frame::World, frame::Probe> probeToWorld;
  probeToWorld.matrix =
      glm::rotate(glm::translate(glm::dmat4(1.0), at_mm + glm::dvec3(0, 0, elevation_mm)), rotation_rad, glm::dvec3(1, 0, 0));
  return probeToWorld;
}

inline Image<float> envelopeOf(const VirtualScanner& scanner, const Transform<frame::World, frame::Probe>& pose = held(),
                               std::uint64_t frame = 0, const Deformation& deformation = restingBody()) {
  const auto scratch = scanner.makeScratch();
  Image<float> envelope;
  scanner.envelope(pose, deformation, frame, *scratch, envelope);
  return envelope;
}

/// Envelope values of a band of depths, all lines but `margin` at the sides.
inline std::vector<double> band(const VirtualScanner& scanner, const Image<float>& envelope, double from_mm, double to_mm, int margin = 4) {
  std::vector<double> values;
  for (int s = 0; s < envelope.height; ++s) {
    const double depth = scanner.grid().depth_mm(s);
    if (depth < from_mm || depth > to_mm) continue;
    for (int l = margin; l < envelope.width - margin; ++l)
      values.push_back(static_cast<double>(
          envelope.pixels[static_cast<std::size_t>(s) * static_cast<std::size_t>(envelope.width) + static_cast<std::size_t>(l)]));
  }
  return values;
}

struct Moments {
  double mean = 0.0;
  double deviation = 0.0;
};
inline Moments momentsOf(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0;
  for (const double value : values) sum += value, squares += value * value;
  const double count = static_cast<double>(values.size()), mean = sum / count;
  return {mean, std::sqrt(squares / count - mean * mean)};
}

inline double meanPower_db(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return 10.0 * std::log10(sum / static_cast<double>(values.size()));
}

/// Mean of the grey levels (255 for 1, 60 dB to 0), not clamped.
inline double meanLevel(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += 255.0 + 255.0 / 60.0 * 20.0 * std::log10(value);
  return sum / static_cast<double>(values.size());
}

}  // namespace ew::testing
