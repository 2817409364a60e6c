#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "ew/core/numbers.h"
#include "ew/phantom/virtual_sweep.h"
#include "recipe.h"

namespace ew {
namespace {

using phantom::FieldReader;

constexpr int kMostFrames = 20000;
constexpr std::size_t kMostStations = 200;
constexpr std::size_t kMostGains = 64;
constexpr double kLargestSeed = 9007199254740992.0;  // whole numbers of a double

constexpr std::array<std::pair<std::string_view, SweepKind>, 4> kKinds = {
    {{"freehand", SweepKind::freehand}, {"parallel", SweepKind::parallel}, {"fan", SweepKind::fan}, {"rotational", SweepKind::rotational}}};

double whole(FieldReader& reader, const nlohmann::json& object, const std::string& place, const std::string& name, double lowest,
             double highest, std::optional<double> fallback = std::nullopt) {
  const double value = reader.number(object, place, name, lowest, highest, fallback);
  if (!reader.problem() && object.contains(name) && !object.at(name).is_number_integer())
    reader.refuse(place + "." + name, object.at(name).dump(), "a whole number");
  return value;
}

std::uint64_t seedOf(FieldReader& reader, const nlohmann::json& object, const std::string& place, const std::string& name) {
  return static_cast<std::uint64_t>(whole(reader, object, place, name, 0.0, kLargestSeed, 1.0));
}

/// An object that may be absent; then every field in it has its default.
nlohmann::json partOf(FieldReader& reader, const nlohmann::json& sweep, const std::string& name, const std::set<std::string>& fields) {
  const auto found = sweep.find(name);
  if (found == sweep.end()) return nlohmann::json::object();
  reader.allow(*found, name, fields);
  return found->is_object() ? *found : nlohmann::json::object();
}

void readMachine(FieldReader& reader, const nlohmann::json& sweep, FormationOptions& options) {
  const auto machine = partOf(
      reader, sweep, "machine",
      {"depth_mm", "focus_mm", "carrier_hz", "pulse_cycles", "looks", "assumed_speed_m_per_s", "attenuation", "specular", "speed_of_sound",
       "noise_db", "dynamic_range_db", "gain_db", "tgc", "expected_db_per_cm_mhz", "largest_tgc_db", "noise_seed"});
  const auto number = [&](const char* name, double lowest, double highest, double& target) {
    target = reader.number(machine, "machine", name, lowest, highest, target);
  };
  number("depth_mm", 0.0, 1000.0, options.depth_mm);
  number("focus_mm", 0.0, 1000.0, options.focus_mm);
  number("carrier_hz", 0.0, 1e8, options.carrier_hz);
  number("pulse_cycles", 0.5, 10.0, options.pulseCycles);
  double looks = options.looks;
  number("looks", 1.0, 5.0, looks);
  if (looks != std::floor(looks)) reader.refuse("machine.looks", textOf(looks), "a whole number from 1 to 5");
  options.looks = static_cast<int>(looks);
  number("assumed_speed_m_per_s", 1000.0, 2000.0, options.assumedSpeed_mPerS);
  options.attenuation = reader.flag(machine, "machine", "attenuation", options.attenuation);
  options.specular = reader.flag(machine, "machine", "specular", options.specular);
  options.speedOfSound = reader.flag(machine, "machine", "speed_of_sound", options.speedOfSound);
  number("noise_db", -400.0, 0.0, options.noise_db);
  number("dynamic_range_db", 20.0, 120.0, options.dynamicRange_db);
  number("gain_db", -100.0, 100.0, options.gain_db);
  number("expected_db_per_cm_mhz", 0.0, 10.0, options.expected_dbPerCmMhz);
  number("largest_tgc_db", 0.0, 200.0, options.largestTgc_db);
  options.noiseSeed = seedOf(reader, machine, "machine", "noise_seed");
  if (!machine.contains("tgc")) return;
  const auto& gains = reader.list(machine, "machine", "tgc", 1, kMostGains);
  for (std::size_t n = 0; n < gains.size(); ++n) {
    const std::string place = "machine.tgc[" + std::to_string(n) + "]";
    reader.allow(gains[n], place, {"depth_mm", "gain_db"});
    if (reader.problem()) return;
    const DepthGain gain{reader.number(gains[n], place, "depth_mm", 0.0, 1000.0), reader.number(gains[n], place, "gain_db", -100.0, 150.0)};
    if (!options.tgc.empty() && gain.depth_mm <= options.tgc.back().depth_mm)
      reader.refuse(place + ".depth_mm", gains[n].at("depth_mm").dump(), "more than the depth before");
    options.tgc.push_back(gain);
  }
}

void readStations(FieldReader& reader, const nlohmann::json& sweep, SweepRecipe& recipe) {
  const auto& stations = reader.list(sweep, "sweep", "stations", 1, kMostStations);
  for (std::size_t n = 0; n < stations.size() && !reader.problem(); ++n) {
    const std::string place = "stations[" + std::to_string(n) + "]";
    reader.allow(stations[n], place, {"near_mm", "lateral", "towards_mm"});
    if (reader.problem()) return;
    SweepRecipe::Station station;
    station.near_mm = reader.vector(stations[n], place, "near_mm");
    station.lateral = reader.vector(stations[n], place, "lateral", station.lateral);
    if (!(glm::length(station.lateral) > 1e-6)) reader.refuse(place + ".lateral", "0 0 0", "a direction");
    if (stations[n].contains("towards_mm")) station.towards_mm = reader.vector(stations[n], place, "towards_mm");
    if (!recipe.onSkin && !station.towards_mm)
      reader.refuse(place + ".towards_mm", "missing", "a point to look at, as the probe is not on the skin");
    recipe.stations.push_back(station);
  }
  if (recipe.kind != SweepKind::freehand && recipe.stations.size() > 1)
    reader.refuse("stations", "a list of " + std::to_string(recipe.stations.size()) + " entries",
                  "one station, from which the motor starts");
}

void readPath(FieldReader& reader, const nlohmann::json& sweep, SweepRecipe& recipe) {
  recipe.onSkin = reader.flag(sweep, "sweep", "on_skin", true);
  readStations(reader, sweep, recipe);
  const auto onlyFor = [&](const char* field, bool fits, const char* kinds) {
    if (!fits && sweep.contains(field))
      reader.refuse(std::string("sweep.") + field, "given", std::string("nothing: only ") + kinds + " has it");
  };
  const bool hand = recipe.kind == SweepKind::freehand, parallel = recipe.kind == SweepKind::parallel, fan = recipe.kind == SweepKind::fan;
  onlyFor("extent_mm", parallel, "a parallel motor");
  onlyFor("extent_deg", fan || recipe.kind == SweepKind::rotational, "a fan or a rotational motor");
  onlyFor("axis_behind_face_mm", fan, "a fan motor");
  onlyFor("unevenness", hand, "a hand");
  onlyFor("hand_seed", hand, "a hand");
  if (parallel) recipe.extent_mm = reader.number(sweep, "sweep", "extent_mm", 0.1, 1000.0);
  if (fan) recipe.extent_deg = reader.number(sweep, "sweep", "extent_deg", 0.1, 170.0);
  if (recipe.kind == SweepKind::rotational) recipe.extent_deg = reader.number(sweep, "sweep", "extent_deg", 0.1, 360.0);
  recipe.axisBehindFace_mm = reader.number(sweep, "sweep", "axis_behind_face_mm", 0.0, 300.0, 0.0);
  recipe.unevenness = reader.number(sweep, "sweep", "unevenness", 0.0, 1.0, 0.0);
  recipe.handSeed = seedOf(reader, sweep, "sweep", "hand_seed");
  recipe.indentation_mm = reader.number(sweep, "sweep", "indentation_mm", 0.0, 60.0, 0.0);
}

void readTracker(FieldReader& reader, const nlohmann::json& sweep, SweepRecipe::Tracker& tracker) {
  const auto part =
      partOf(reader, sweep, "tracker", {"noise_mm", "noise_deg", "jitter_s", "latency_s", "drop_out_share", "calibration_error", "seed"});
  tracker.noise_mm = reader.number(part, "tracker", "noise_mm", 0.0, 100.0, 0.0);
  tracker.noise_deg = reader.number(part, "tracker", "noise_deg", 0.0, 90.0, 0.0);
  tracker.jitter_s = reader.number(part, "tracker", "jitter_s", 0.0, 1.0, 0.0);
  tracker.latency_s = reader.number(part, "tracker", "latency_s", -5.0, 5.0, 0.0);
  tracker.dropOutShare = reader.number(part, "tracker", "drop_out_share", 0.0, 1.0, 0.0);
  tracker.seed = seedOf(reader, part, "tracker", "seed");
  const auto error = part.find("calibration_error");
  if (error == part.end()) return;
  const std::string place = "tracker.calibration_error";
  reader.allow(*error, place, {"shift_mm", "turn_deg"});
  if (reader.problem()) return;
  const glm::dvec3 shift_mm = reader.vector(*error, place, "shift_mm", glm::dvec3(0.0));
  const glm::dvec3 turn_rad = std::numbers::pi / 180.0 * reader.vector(*error, place, "turn_deg", glm::dvec3(0.0));
  if (const double angle_rad = glm::length(turn_rad); angle_rad > 0.0)
    tracker.calibrationError = glm::mat4_cast(glm::angleAxis(angle_rad, turn_rad / angle_rad));
  tracker.calibrationError[3] = glm::dvec4(shift_mm, 1.0);
}

}  // namespace

Result<SweepRecipe> readSweepRecipe(const std::filesystem::path& file) {
  const auto json = phantom::readRecipe(file, "sweep file");
  if (!json) return passOn(json.error());
  FieldReader reader(file.string());
  reader.allow(*json, "sweep",
               {"format",
                "probe",
                "kind",
                "frames",
                "frames_per_second",
                "machine",
                "stations",
                "on_skin",
                "extent_mm",
                "extent_deg",
                "axis_behind_face_mm",
                "unevenness",
                "hand_seed",
                "indentation_mm",
                "breathing",
                "pulsating",
                "ecg",
                "respiration",
                "tracker",
                "scan_lines",
                "pixel_mm",
                "seed"});
  SweepRecipe recipe;
  recipe.name = reader.text(*json, "sweep", "name");
  recipe.probe = reader.text(*json, "sweep", "probe");
  if (recipe.probe.find_first_of("/\\") != std::string::npos)
    reader.refuse("sweep.probe", "\"" + recipe.probe + "\"", "the name of a shipped probe, such as convex-3.5, without folder and ending");
  const std::string kind = reader.text(*json, "sweep", "kind");
  const auto known = std::find_if(kKinds.begin(), kKinds.end(), [&](const auto& named) { return named.first == kind; });
  if (known != kKinds.end()) {
    recipe.kind = known->second;
  } else {
    reader.refuse("sweep.kind", "\"" + kind + "\"", "freehand, parallel, fan or rotational");
  }
  recipe.frames = static_cast<int>(whole(reader, *json, "sweep", "frames", 1.0, kMostFrames, recipe.frames));
  recipe.framesPerSecond = reader.number(*json, "sweep", "frames_per_second", 0.1, 1000.0, recipe.framesPerSecond);
  readMachine(reader, *json, recipe.formation);
  readPath(reader, *json, recipe);
  recipe.breathing = reader.flag(*json, "sweep", "breathing", false);
  recipe.pulsating = reader.flag(*json, "sweep", "pulsating", false);
  recipe.ecg = reader.flag(*json, "sweep", "ecg", false);
  recipe.respiration = reader.flag(*json, "sweep", "respiration", false);
  readTracker(reader, *json, recipe.tracker);
  recipe.scanLines = reader.flag(*json, "sweep", "scan_lines", false);
  recipe.pixel_mm = reader.number(*json, "sweep", "pixel_mm", 0.0, 10.0, 0.0);
  recipe.seed = seedOf(reader, *json, "sweep", "seed");
  if (reader.problem()) return passOn(*reader.problem());
  return recipe;
}

}  // namespace ew
