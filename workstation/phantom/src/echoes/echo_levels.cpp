#include "echoes/echo_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ew/phantom/speckle.h"
#include "patient/anatomy.h"

namespace ew::phantom {
namespace {

constexpr double kDecibelPerLevel = 60.0 / 255.0;
constexpr double kMeanOfLog_db = 2.507;
constexpr std::uint64_t kScattererTextureSeed = 0x7465787475726521ull;  // as voxelise: the same grains
constexpr double kFineGrain = 0.35;  // a texture's finer grains: size, and strength where they stand out (small vessels, septa)
constexpr double kFineStrength = 2.2;
// A perfect mirror stands this far above full white: fat on soft tissue (reflection coefficient 0.08) is then bright, not burnt.
constexpr double kPerfectMirror = 2.7;
constexpr double kLeastReflection = 1e-4;

}  // namespace

double specklePowerAt(double level) { return std::pow(10.0, 0.1 * ((level - 255.0) * kDecibelPerLevel + kMeanOfLog_db)); }
double amplitudeAt(double level) { return std::pow(10.0, 0.05 * (level - 255.0) * kDecibelPerLevel); }
double levelOf(double amplitude) { return 255.0 + 20.0 * std::log10(amplitude) / kDecibelPerLevel; }

double tissueLevelAt(const Patient& patient, std::size_t number, const glm::dvec3& place_mm) {
  const Tissue& tissue = patient.tissues[number];
  const bool asksTheSkin = tissue.texture.level > 0.0 && tissue.texture.followsTheSkin;
  return tissueLevelAt(tissue, number, place_mm, asksTheSkin ? patient.skin->distance_mm(place_mm) : 0.0);
}

double tissueLevelAt(const Tissue& tissue, std::size_t number, const glm::dvec3& place_mm, double skin_mm) {
  const TissueTexture& texture = tissue.texture;
  if (!(texture.level > 0.0)) return tissue.echoLevel;
  const glm::dvec3 grain(place_mm.x, texture.followsTheSkin ? skin_mm : place_mm.y, place_mm.z);
  const std::uint64_t seed = 1 + kScattererTextureSeed * (number + 1);
  const double fine = valueNoise(~seed, grain / (kFineGrain * texture.scale_mm));
  return tissue.echoLevel + texture.level * (valueNoise(seed, grain / texture.scale_mm) + kFineStrength * fine * std::abs(fine));
}

double mirroredBetween(double inside_mrayl, double outside_mrayl) {
  const double reflection = std::abs(inside_mrayl - outside_mrayl) / (inside_mrayl + outside_mrayl);
  return reflection < kLeastReflection ? 0.0 : kPerfectMirror * reflection;
}

PowerOfLevel::PowerOfLevel() {
  for (std::size_t n = 1; n < powers_.size(); ++n) powers_[n] = static_cast<float>(specklePowerAt(static_cast<double>(n) / kSteps));
}

double PowerOfLevel::of(double level) const {
  return static_cast<double>(powers_[static_cast<std::size_t>(std::clamp(level * kSteps + 0.5, 0.0, 255.0 * kSteps))]);
}

int PowerOfLevel::level(double power) const {
  const auto above = std::lower_bound(powers_.begin(), powers_.end(), static_cast<float>(power));
  return std::min(255, static_cast<int>(above - powers_.begin() + kSteps / 2) / kSteps);
}

}  // namespace ew::phantom

double ew::finestGrain_mm(const TissueTexture& texture) {
  if (!(texture.level > 0.0)) return std::numeric_limits<double>::infinity();
  return phantom::kFineGrain * std::min({texture.scale_mm.x, texture.scale_mm.y, texture.scale_mm.z});
}
