#include "ew/imaging/probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string_view>

#include "ew/core/contract.h"
#include "ew/core/ending.h"
#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/core/word_table.h"
#include "ew/imaging/settings_json.h"
#include "sound.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr std::uintmax_t kLargestFile_bytes = 1 << 20;
constexpr int kFormatVersion = 1;
constexpr double kDegree_rad = std::numbers::pi / 180.0;

constexpr std::size_t kMostCarriers = 8;

constexpr WordTable<ProbeKind, 5> kKinds = {{{"linear", ProbeKind::linear},
                                             {"convex", ProbeKind::convex},
                                             {"phased", ProbeKind::phased},
                                             {"endocavity", ProbeKind::endocavity},
                                             {"swept_sector", ProbeKind::sweptSector}}};

constexpr std::array<std::string_view, 14> kFieldsOfAll = {"format",
                                                           "name",
                                                           "kind",
                                                           "lines",
                                                           "carrier_hz",
                                                           "carriers_hz",
                                                           "aperture_mm",
                                                           "min_depth_mm",
                                                           "max_depth_mm",
                                                           "default_depth_mm",
                                                           "elevational_thickness_mm",
                                                           "elevational_focus_mm",
                                                           "elevational_aperture_mm",
                                                           "near_field_mm"};

bool hasField(ProbeKind kind, std::string_view field) {
  if (std::find(kFieldsOfAll.begin(), kFieldsOfAll.end(), field) != kFieldsOfAll.end()) return true;
  if (field == "width_mm") return kind == ProbeKind::linear || kind == ProbeKind::phased;
  if (field == "radius_mm") return kind != ProbeKind::linear && kind != ProbeKind::phased;
  if (field == "opening_deg") return kind != ProbeKind::linear;
  return kind == ProbeKind::linear && (field == "max_steering_deg" || field == "trapezoid_deg");
}

/// How much of the face sends at once, for files that do not say: all of a phased array, an element that fits into a dome, the usual
/// part of the longer arrays.
double usualAperture_mm(const Probe& probe) {
  switch (probe.kind) {
    case ProbeKind::phased:
      return probe.width_mm;
    case ProbeKind::sweptSector:
      return std::min(probe.radius_mm, probe.width_mm);
    case ProbeKind::linear:
    case ProbeKind::convex:
    case ProbeKind::endocavity:
      break;
  }
  return 0.4 * probe.width_mm;
}

/// The height of elements that focus to the slice thickness: thickness = wavelength * focus / aperture.
double usualElevationalAperture_mm(const Probe& probe) {
  const double wavelength_mm = detail::kSpeedOfSound_mmPerS / probe.carrier_hz;
  return std::clamp(wavelength_mm * probe.elevationalFocus_mm / probe.elevationalThickness_mm, probe.elevationalThickness_mm, 50.0);
}

/// Several frequencies, each larger than the one before, the usual one among them; none when the field is absent.
std::vector<double> risingCarriers(const JsonFields& fields, double usual_hz) {
  constexpr double kLowest_hz = 1e5, kHighest_hz = 1e8;
  const Message expected = say<"a list of 1 to %1 rising numbers from %2 to %3, %4 among them">(kMostCarriers, textOf(kLowest_hz),
                                                                                                textOf(kHighest_hz), textOf(usual_hz));
  auto values = fields.numbers("carriers_hz", 1, kMostCarriers, kLowest_hz, kHighest_hz, false, expected);
  const bool rising = std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
  if (!values.empty() && (!rising || std::find(values.begin(), values.end(), usual_hz) == values.end()))
    fields.refuse("carriers_hz", expected);
  return values;
}

Result<json> readObject(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::error_code problem;
  if (!std::filesystem::exists(file, problem))
    return failure(ErrorCode::notFound, say<"There is no probe file %1; check the name.">(name), {{"file", name}});
  const std::uintmax_t size = std::filesystem::file_size(file, problem);
  if (problem)
    return failure(ErrorCode::notReadable, say<"The probe file %1 cannot be read: %2.">(name, problem.message()), {{"file", name}});
  if (size > kLargestFile_bytes)
    return failure(ErrorCode::badHeader, say<"The file %1 is too large to be a probe; a probe is a small JSON text.">(name),
                   {{"file", name}});
  std::ifstream stream(file, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');
  if (!stream.read(text.data(), static_cast<std::streamsize>(size)))
    return failure(ErrorCode::notReadable, say<"The probe file %1 cannot be read; check its permissions.">(name), {{"file", name}});
  return parseJsonObject(text, say<"the probe file %1">(name));
}

}  // namespace

Result<Probe> probeFromJson(const json& object, const std::string& id, const Message& where) {
  if (!object.is_object())
    return failure(ErrorCode::badHeader, say<"The probe file %1 is not a JSON object; compare it with a shipped probe.">(where),
                   {{"file", where.english()}});
  JsonReading reading(say<"the probe file %1">(where));
  const JsonFields fields(object, reading);

  const auto version = fields.whole("format", 1, 1000000);
  if (fields.good() && version > kFormatVersion)
    return failure(ErrorCode::newerFormat,
                   say<"The probe file %1 has format %2, this program reads up to %3; update EchoWeave.">(where, version, kFormatVersion),
                   {{"file", where.english()}, {"found", std::to_string(version)}, {"known", std::to_string(kFormatVersion)}});

  Probe probe;
  probe.id = id;
  probe.name = fields.text("name");
  probe.kind = fields.word("kind", kKinds);
  if (!fields.good()) return passOn(*reading.problem());
  if (hasField(probe.kind, "width_mm")) probe.width_mm = fields.number("width_mm", 5.0, 300.0);
  if (hasField(probe.kind, "radius_mm")) probe.radius_mm = fields.number("radius_mm", 3.0, 300.0);
  if (hasField(probe.kind, "opening_deg")) probe.halfAngle_rad = 0.5 * kDegree_rad * fields.number("opening_deg", 5.0, 170.0);
  probe.width_mm = faceLength_mm(probe);
  if (hasField(probe.kind, "max_steering_deg")) probe.maxSteering_rad = kDegree_rad * fields.number("max_steering_deg", 0.0, 45.0, 0.0);
  if (hasField(probe.kind, "trapezoid_deg")) probe.trapezoidHalfAngle_rad = kDegree_rad * fields.number("trapezoid_deg", 0.0, 30.0, 0.0);
  probe.lines = static_cast<int>(fields.whole("lines", 2, 4096));
  probe.carrier_hz = fields.number("carrier_hz", 1e5, 1e8);
  probe.carriers_hz = risingCarriers(fields, probe.carrier_hz);
  probe.aperture_mm = fields.number("aperture_mm", 0.1, probe.width_mm, usualAperture_mm(probe));
  probe.elevationalThickness_mm = fields.number("elevational_thickness_mm", 0.05, 50.0);
  probe.minDepth_mm = fields.number("min_depth_mm", 1.0, 1000.0);
  probe.maxDepth_mm = fields.number("max_depth_mm", probe.minDepth_mm, 1000.0);
  probe.defaultDepth_mm = fields.number("default_depth_mm", probe.minDepth_mm, probe.maxDepth_mm);
  probe.elevationalFocus_mm = fields.number("elevational_focus_mm", 1.0, 1000.0, 0.5 * probe.defaultDepth_mm);
  probe.elevationalAperture_mm = fields.number("elevational_aperture_mm", 0.5, 100.0, usualElevationalAperture_mm(probe));
  probe.nearField_mm = fields.number("near_field_mm", 0.0, 20.0, probe.nearField_mm);
  for (const auto& item : object.items())
    if (!hasField(probe.kind, item.key()))
      fields.refuse(item.key(), say<"given">(),
                    say<"left out, because a probe of the kind %1 has no such field">(fields.find("kind")->dump()));
  if (reading.problem()) return passOn(*reading.problem());
  return probe;
}

Result<Probe> readProbe(const std::filesystem::path& file) {
  const auto object = readObject(file);
  if (!object) return passOn(object.error());
  return probeFromJson(*object, file.stem().string(), verbatim(file.string()));
}

json toJson(const Probe& probe) {
  json object = {{"format", kFormatVersion},
                 {"name", probe.name},
                 {"kind", wordIn(kKinds, probe.kind)},
                 {"lines", probe.lines},
                 {"carrier_hz", probe.carrier_hz},
                 {"aperture_mm", probe.aperture_mm},
                 {"min_depth_mm", probe.minDepth_mm},
                 {"max_depth_mm", probe.maxDepth_mm},
                 {"default_depth_mm", probe.defaultDepth_mm},
                 {"elevational_thickness_mm", probe.elevationalThickness_mm},
                 {"elevational_focus_mm", probe.elevationalFocus_mm},
                 {"elevational_aperture_mm", probe.elevationalAperture_mm},
                 {"near_field_mm", probe.nearField_mm}};
  if (!probe.carriers_hz.empty()) object["carriers_hz"] = probe.carriers_hz;
  const std::pair<const char*, double> ofSome[] = {{"width_mm", probe.width_mm},
                                                   {"radius_mm", probe.radius_mm},
                                                   {"opening_deg", factorGiving(probe.halfAngle_rad, 0.5 * kDegree_rad)},
                                                   {"max_steering_deg", factorGiving(probe.maxSteering_rad, kDegree_rad)},
                                                   {"trapezoid_deg", factorGiving(probe.trapezoidHalfAngle_rad, kDegree_rad)}};
  for (const auto& [field, value] : ofSome)
    if (hasField(probe.kind, field)) object[field] = value;
  return object;
}

double faceLength_mm(const Probe& probe) {
  const bool isCurved = isSector(probe.kind) && probe.radius_mm > 0.0;
  return isCurved ? 2.0 * probe.radius_mm * probe.halfAngle_rad : probe.width_mm;
}

double faceHalfWidth_mm(const Probe& probe) {
  if (!isSector(probe.kind) || probe.kind == ProbeKind::phased) return 0.5 * probe.width_mm;
  return probe.radius_mm * std::sin(probe.halfAngle_rad);
}

double faceSagitta_mm(const Probe& probe) { return isSector(probe.kind) ? probe.radius_mm * (1.0 - std::cos(probe.halfAngle_rad)) : 0.0; }

std::vector<glm::dvec3> facePoints_mm(const Probe& probe, int count) {
  EW_EXPECTS(count >= 2);
  const bool straight = !isSector(probe.kind) || probe.kind == ProbeKind::phased;
  std::vector<glm::dvec3> points;
  points.reserve(static_cast<std::size_t>(count));
  for (int n = 0; n < count; ++n) {
    const double across = 2.0 * n / (count - 1) - 1.0;
    const double angle_rad = across * probe.halfAngle_rad;
    if (straight)
      points.emplace_back(across * 0.5 * probe.width_mm, 0.0, 0.0);
    else
      points.emplace_back(probe.radius_mm * std::sin(angle_rad), probe.radius_mm * (std::cos(angle_rad) - 1.0), 0.0);
  }
  return points;
}

Result<std::vector<Probe>> readProbes(const std::filesystem::path& folder) {
  std::error_code problem;
  std::filesystem::directory_iterator entries(folder, problem);
  if (problem)
    return failure(ErrorCode::notFound, say<"The folder of probes %1 cannot be opened: %2.">(folder.string(), problem.message()),
                   {{"folder", folder.string()}});
  std::vector<Probe> probes;
  for (; entries != std::filesystem::directory_iterator(); entries.increment(problem)) {
    if (problem)
      return failure(ErrorCode::notReadable, say<"The folder of probes %1 cannot be read: %2.">(folder.string(), problem.message()),
                     {{"folder", folder.string()}});
    if (!hasEnding(entries->path(), ".json")) continue;
    auto probe = readProbe(entries->path());
    if (!probe) return passOn(probe.error());
    probes.push_back(std::move(*probe));
  }
  std::sort(probes.begin(), probes.end(), [](const Probe& a, const Probe& b) { return a.name < b.name; });
  return probes;
}

}  // namespace ew
