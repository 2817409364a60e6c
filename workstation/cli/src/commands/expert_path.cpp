#include "commands/expert_path.h"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "ew/assessment/hand_path.h"
#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/imaging/settings_json.h"
#include "ew/io/json_files.h"
#include "ew/library/case_start.h"
#include "ew/scanning/contact.h"

namespace ew::cli {
namespace {

using nlohmann::json;

constexpr std::size_t kLargestPath_bytes = 1u << 20;
constexpr std::size_t kMostStations = 200;

double radians(double degrees) { return degrees * 3.14159265358979323846 / 180.0; }

ExpertStation readStation(const JsonFields& fields, const Message& where, json& knobs) {
  fields.only({"plane", "pose", "offset", "travel_s", "stay_s", "knobs"});
  ExpertStation station;
  station.plane = fields.text("plane", std::string(), 0);
  if (const auto pose = fields.rigid("pose")) station.pose = Pose{.probeToWorld = {*pose}};
  if (station.plane.empty() != station.pose.has_value()) fields.refuse("plane", say<"given where there is no pose, and left out else">());
  const JsonFields offset = fields.object("offset");
  offset.only({"slide_mm", "rotation_deg", "tilt_deg", "rock_deg"});
  if (const auto slide = offset.numbers("slide_mm", 2, 2, -500.0, 500.0, false); slide.size() == 2) {
    station.slideLateral_mm = slide[0];
    station.slideElevational_mm = slide[1];
  }
  station.rotation_rad = radians(offset.number("rotation_deg", -180.0, 180.0, 0.0));
  station.tilt_rad = radians(offset.number("tilt_deg", -70.0, 70.0, 0.0));
  station.rock_rad = radians(offset.number("rock_deg", -70.0, 70.0, 0.0));
  station.travel_s = fields.number("travel_s", 0.1, 120.0, station.travel_s);
  station.stay_s = fields.number("stay_s", 0.0, 120.0, station.stay_s);
  if (const json* changed = fields.find("knobs")) knobs.merge_patch(*changed);
  if (auto set = knobsFromJson(knobs, where))
    station.knobs = *set;
  else
    fields.reading().refuse(set.error());
  return station;
}

Result<Hold> holdOf(const ExpertStation& station, const ExpertGround& ground) {
  std::optional<Pose> pose = station.pose;
  if (station.plane == "start") pose = ground.opened.startPose;
  std::string names = "start";
  for (const ReferencePlane& plane : ground.truth.planes) {
    names += ", " + plane.name;
    if (plane.name == station.plane) pose = Pose{.probeToWorld = plane.probeToWorld};
  }
  if (!pose)
    return failure(
        ErrorCode::badField,
        say<"The case '%1' has no plane '%2' to put the probe on; name one that it has: %3.">(ground.opened.id, station.plane, names),
        {{"field", "plane"}, {"found", station.plane}, {"expected", names}});
  Hold hold = pressedOn(*pose, ground.skin, ground.probe);
  hold = slid(hold, ground.skin, station.slideLateral_mm, station.slideElevational_mm);
  return turned(hold, station.rotation_rad, station.rock_rad, station.tilt_rad);
}

/// Frames at an even rate, one after another.
class Frames {
 public:
  Frames(const ExpertGround& ground, double rate_hz, Progress& progress) : ground_(ground), rate_hz_(rate_hz), progress_(progress) {
    state_.probe = ground.probe;
    state_.scene = ground.opened.scene;
  }

  void set(const Knobs& knobs) { state_.knobs = knobs; }

  /// Everything from the last frame until `end_s`. @param poseAt of a share of that time
  template <class PoseAt>
  Result<void> until(double end_s, PoseAt poseAt) {
    for (; time_s() < end_s - 1e-9; ++state_.number) {
      if (progress_.cancelRequested()) return failure(ErrorCode::cancelled, ew::say<"Recording the expert's scan was stopped.">());
      state_.time_s = time_s();
      state_.pose = poseAt((time_s() - begin_s_) / (end_s - begin_s_));
      state_.pose.time_s = state_.time_s;
      if (state_.scene.contact) state_.gaps_mm = shortened(gapsToSkin_mm(state_.probe, state_.pose, ground_.skin));
      log.addFrame(state_);
    }
    begin_s_ = end_s;
    return {};
  }
  [[nodiscard]] double begin_s() const { return begin_s_; }

  ScanLog log;

 private:
  [[nodiscard]] double time_s() const { return static_cast<double>(state_.number) / rate_hz_; }

  const ExpertGround& ground_;
  double rate_hz_;
  Progress& progress_;
  ScanState state_;
  double begin_s_ = 0.0;
};

}  // namespace

Result<ExpertPath> readExpertPath(const std::filesystem::path& file, const ExpertConsole& console) {
  const Message where = verbatim(file.filename().string());
  const auto document = readJsonFile(file, where, kLargestPath_bytes);
  if (!document) return passOn(document.error());
  JsonReading reading(where, {"note"});
  const JsonFields fields(*document, reading);
  requireFormat(fields, kExpertPathFormat);
  fields.only({"format", "probe", "rate_hz", "knobs", "stations"});
  ExpertPath path;
  path.probe = fields.text("probe", std::string(), 0);
  path.rate_hz = fields.number("rate_hz", 1.0, 60.0, path.rate_hz);
  const auto isWanted = [&](const Probe& each) { return path.probe.empty() || each.id == path.probe; };
  std::vector<Probe> usable = usableOf(console.opened.probes, console.probes);
  std::erase_if(usable, std::not_fn(isWanted));
  json knobs = json::object();
  if (const Preset* start = startPreset(presetsOf(console.opened), console.presets, usable)) {
    path.probe = start->probe;
    knobs = toJson(start->knobs);
  }
  knobs.merge_patch(fields.object("knobs").value());
  for (const JsonFields& each : fields.objects("stations", 1, kMostStations)) path.stations.push_back(readStation(each, where, knobs));
  if (reading.problem()) return passOn(*reading.problem());
  return path;
}

Result<ScanRecording> recordAlong(const ExpertPath& path, const ExpertGround& ground, Progress& progress) {
  Frames frames(ground, path.rate_hz, progress);
  std::optional<Hold> before;
  for (std::size_t n = 0; n < path.stations.size(); ++n) {
    const ExpertStation& station = path.stations[n];
    const auto hold = holdOf(station, ground);
    if (!hold) return passOn(hold.error());
    frames.set(station.knobs);
    if (before) {
      const auto way = HandPath::between(*before, *hold, ground.skin);
      if (!way)
        return failure(ErrorCode::badField,
                       say<"No way on the skin leads straight from station %1 to station %2; put a station between them.">(
                           std::to_string(n), std::to_string(n + 1)),
                       {{"field", "stations[" + std::to_string(n) + "]"}});
      const auto moved =
          frames.until(frames.begin_s() + station.travel_s, [&](double share) { return way->at(leastJerk(share), ground.skin); });
      if (!moved) return passOn(moved.error());
    }
    // The last station is seen for at least one image.
    const double stay_s = n + 1 < path.stations.size() ? station.stay_s : std::max(station.stay_s, 1.0 / path.rate_hz);
    const Pose still = poseOf(*hold);
    if (const auto stayed = frames.until(frames.begin_s() + stay_s, [&](double) { return still; }); !stayed) return passOn(stayed.error());
    before = *hold;
    progress.report(say<"Recording the expert's scan">(), static_cast<double>(n + 1) / static_cast<double>(path.stations.size()));
  }
  ScanRecording recording;
  recording.caseId = ground.opened.id;
  recording.title = titleForTrainees(ground.opened);
  recording.log = std::move(frames.log);
  return recording;
}

}  // namespace ew::cli
