#include <algorithm>
#include <array>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

#include "ew/phantom/virtual_sweep.h"
#include "patient/recipe.h"

namespace ew {
namespace {

constexpr int kMostFrames = 20000;
constexpr std::size_t kMostStations = 200;
constexpr std::size_t kMostGains = 64;
constexpr long long kLargestSeed = 1LL << 53;  // whole numbers of a double

constexpr std::array<std::pair<std::string_view, SweepKind>, 4> kKinds = {
    {{"freehand", SweepKind::freehand}, {"parallel", SweepKind::parallel}, {"fan", SweepKind::fan}, {"rotational", SweepKind::rotational}}};

std::uint64_t seedOf(const JsonFields& object, const char* name) {
  return static_cast<std::uint64_t>(object.whole(name, 0, kLargestSeed, 1));
}

void readMachine(const JsonFields& machine, FormationOptions& options) {
  machine.only({"depth_mm", "focus_mm", "carrier_hz", "pulse_cycles", "looks", "assumed_speed_m_per_s", "attenuation", "penumbra",
                "specular", "speed_of_sound", "noise_db", "dynamic_range_db", "gain_db", "tgc", "expected_db_per_cm_mhz", "largest_tgc_db",
                "noise_seed"});
  const auto number = [&](const char* name, double lowest, double highest, double& target) {
    target = machine.number(name, lowest, highest, target);
  };
  number("depth_mm", 0.0, 1000.0, options.depth_mm);
  number("focus_mm", 0.0, 1000.0, options.focus_mm);
  number("carrier_hz", 0.0, 1e8, options.carrier_hz);
  number("pulse_cycles", 0.5, 10.0, options.pulseCycles);
  options.looks = static_cast<int>(machine.whole("looks", 1, 5, options.looks));
  number("assumed_speed_m_per_s", 1000.0, 2000.0, options.assumedSpeed_mPerS);
  options.attenuation = machine.flag("attenuation", options.attenuation);
  options.penumbra = machine.flag("penumbra", options.penumbra);
  options.specular = machine.flag("specular", options.specular);
  options.speedOfSound = machine.flag("speed_of_sound", options.speedOfSound);
  number("noise_db", -400.0, 0.0, options.noise_db);
  number("dynamic_range_db", 20.0, 120.0, options.dynamicRange_db);
  number("gain_db", -100.0, 100.0, options.gain_db);
  number("expected_db_per_cm_mhz", 0.0, 10.0, options.expected_dbPerCmMhz);
  number("largest_tgc_db", 0.0, 200.0, options.largestTgc_db);
  options.noiseSeed = seedOf(machine, "noise_seed");
  if (!machine.has("tgc")) return;
  for (const JsonFields& each : machine.objects("tgc", 1, kMostGains)) {
    each.only({"depth_mm", "gain_db"});
    const DepthGain gain{each.number("depth_mm", 0.0, 1000.0), each.number("gain_db", -100.0, 150.0)};
    if (!options.tgc.empty() && gain.depth_mm <= options.tgc.back().depth_mm) each.refuse("depth_mm", say<"more than the depth before">());
    options.tgc.push_back(gain);
  }
}

void readStations(const JsonFields& sweep, SweepRecipe& recipe) {
  for (const JsonFields& each : sweep.objects("stations", 1, kMostStations)) {
    each.only({"near_mm", "lateral", "towards_mm"});
    SweepRecipe::Station station;
    station.near_mm = each.point("near_mm", phantom::kFarthest_mm);
    station.lateral = each.point("lateral", phantom::kFarthest_mm, station.lateral);
    if (!(glm::length(station.lateral) > 1e-6)) each.refuse("lateral", say<"a direction">());
    if (each.has("towards_mm")) station.towards_mm = each.point("towards_mm", phantom::kFarthest_mm);
    if (!recipe.onSkin && !station.towards_mm) each.refuse("towards_mm", say<"a point to look at, as the probe is not on the skin">());
    recipe.stations.push_back(station);
  }
  if (recipe.kind != SweepKind::freehand && recipe.stations.size() > 1)
    sweep.refuse("stations", say<"a list of %1">(recipe.stations.size()), say<"one station, from which the motor starts">());
}

void readPath(const JsonFields& sweep, SweepRecipe& recipe) {
  recipe.onSkin = sweep.flag("on_skin", true);
  readStations(sweep, recipe);
  const auto onlyFor = [&](const char* field, bool fits, const Message& expected) {
    if (!fits && sweep.has(field)) sweep.refuse(field, say<"given">(), expected);
  };
  const bool hand = recipe.kind == SweepKind::freehand, parallel = recipe.kind == SweepKind::parallel, fan = recipe.kind == SweepKind::fan;
  onlyFor("extent_mm", parallel, say<"left out: only a parallel motor has it">());
  onlyFor("extent_deg", fan || recipe.kind == SweepKind::rotational, say<"left out: only a fan or a rotational motor has it">());
  onlyFor("axis_behind_face_mm", fan, say<"left out: only a fan motor has it">());
  onlyFor("unevenness", hand, say<"left out: only a hand has it">());
  onlyFor("hand_seed", hand, say<"left out: only a hand has it">());
  if (parallel) recipe.extent_mm = sweep.number("extent_mm", 0.1, 1000.0);
  if (fan) recipe.extent_deg = sweep.number("extent_deg", 0.1, 170.0);
  if (recipe.kind == SweepKind::rotational) recipe.extent_deg = sweep.number("extent_deg", 0.1, 360.0);
  recipe.axisBehindFace_mm = sweep.number("axis_behind_face_mm", 0.0, 300.0, 0.0);
  recipe.unevenness = sweep.number("unevenness", 0.0, 1.0, 0.0);
  recipe.handSeed = seedOf(sweep, "hand_seed");
  recipe.indentation_mm = sweep.number("indentation_mm", 0.0, 60.0, 0.0);
}

void readTracker(const JsonFields& part, SweepRecipe::Tracker& tracker) {
  part.only({"noise_mm", "noise_deg", "jitter_s", "latency_s", "drop_out_share", "calibration_error", "seed"});
  tracker.noise_mm = part.number("noise_mm", 0.0, 100.0, 0.0);
  tracker.noise_deg = part.number("noise_deg", 0.0, 90.0, 0.0);
  tracker.jitter_s = part.number("jitter_s", 0.0, 1.0, 0.0);
  tracker.latency_s = part.number("latency_s", -5.0, 5.0, 0.0);
  tracker.dropOutShare = part.number("drop_out_share", 0.0, 1.0, 0.0);
  tracker.seed = seedOf(part, "seed");
  const JsonFields error = part.object("calibration_error");
  error.only({"shift_mm", "turn_deg"});
  const glm::dvec3 shift_mm = error.point("shift_mm", phantom::kFarthest_mm, glm::dvec3(0.0));
  const glm::dvec3 rotation_rad = std::numbers::pi / 180.0 * error.point("turn_deg", phantom::kFarthest_mm, glm::dvec3(0.0));
  if (const double angle_rad = glm::length(rotation_rad); angle_rad > 0.0)
    tracker.calibrationError = glm::mat4_cast(glm::angleAxis(angle_rad, rotation_rad / angle_rad));
  tracker.calibrationError[3] = glm::dvec4(shift_mm, 1.0);
}

}  // namespace

Result<SweepRecipe> readSweepRecipe(const std::filesystem::path& file) {
  const auto json = phantom::readRecipe(file, say<"sweep file">());
  if (!json) return passOn(json.error());
  JsonReading reading = phantom::readingOf(file);
  const JsonFields sweep(*json, reading);
  sweep.only({"format",
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
  recipe.name = sweep.text("name");
  recipe.probe = sweep.text("probe");
  if (recipe.probe.find_first_of("/\\") != std::string::npos)
    sweep.refuse("probe", say<"the name of a shipped probe, such as convex-3.5, without folder and ending">());
  recipe.kind = sweep.word("kind", kKinds);
  recipe.frames = static_cast<int>(sweep.whole("frames", 1, kMostFrames, recipe.frames));
  recipe.framesPerSecond = sweep.number("frames_per_second", 0.1, 1000.0, recipe.framesPerSecond);
  readMachine(sweep.object("machine"), recipe.formation);
  readPath(sweep, recipe);
  recipe.breathing = sweep.flag("breathing", false);
  recipe.pulsating = sweep.flag("pulsating", false);
  recipe.ecg = sweep.flag("ecg", false);
  recipe.respiration = sweep.flag("respiration", false);
  readTracker(sweep.object("tracker"), recipe.tracker);
  recipe.scanLines = sweep.flag("scan_lines", false);
  recipe.pixel_mm = sweep.number("pixel_mm", 0.0, 10.0, 0.0);
  recipe.seed = seedOf(sweep, "seed");
  if (reading.problem()) return passOn(*reading.problem());
  return recipe;
}

}  // namespace ew
