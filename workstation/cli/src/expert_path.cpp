#include "expert_path.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/imaging/settings_json.h"
#include "ew/io/safe_file.h"
#include "ew/scanning/contact.h"

namespace ew::cli {
namespace {

using nlohmann::json;

constexpr std::size_t kLargestPath_bytes = 1u << 20;
constexpr std::size_t kMostStations = 200;
constexpr int kWayPoints = 96;           // of a way between two stations, before it is walked evenly
constexpr double kFarthestJump_mm = 25;  // between two of them: more, and the nearest skin has changed sides

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

/// As firmly as in the window, where a plane may only touch the skin; where the probe leans that moves the plane, so it is slid back.
Hold pressedOn(const Pose& pose, const ExpertGround& ground) {
  Hold hold = holdFor(pose, ground.skin);
  hold.press_mm = std::max(hold.press_mm, usualPress_mm(ground.probe));
  const glm::dmat4& wanted = pose.probeToWorld.matrix;
  const glm::dvec3 away_mm(wanted[3] - poseOf(hold).probeToWorld.matrix[3]);
  const glm::dmat4 upright = uprightPoseOf(hold).probeToWorld.matrix;
  const glm::dvec3 across_mm = away_mm - glm::dot(away_mm, glm::dvec3(wanted[1])) * glm::dvec3(wanted[1]);
  return slid(hold, ground.skin, glm::dot(across_mm, glm::dvec3(upright[0])), glm::dot(across_mm, glm::dvec3(upright[2])));
}

Result<Hold> holdOf(const ExpertStation& station, const ExpertGround& ground) {
  std::optional<Pose> pose = station.pose;
  if (station.plane == "start") pose = ground.opened.startPose;
  std::string names = "start";
  for (const ExpectedPlane& plane : ground.truth.planes) {
    names += ", " + plane.name;
    if (plane.name == station.plane) pose = Pose{.probeToWorld = plane.probeToWorld};
  }
  if (!pose)
    return failure(
        ErrorCode::badField,
        say<"The case '%1' has no plane '%2' to put the probe on; name one that it has: %3.">(ground.opened.id, station.plane, names),
        {{"field", "plane"}, {"found", station.plane}, {"expected", names}});
  Hold hold = pressedOn(*pose, ground);
  hold = slid(hold, ground.skin, station.slideLateral_mm, station.slideElevational_mm);
  return turned(hold, station.rotation_rad, station.rock_rad, station.tilt_rad);
}

glm::dquat turnOf(const Pose& pose) { return glm::normalize(glm::quat_cast(glm::dmat3(pose.probeToWorld.matrix))); }

/// The way of a hand from one hold to another: the contact along the skin below the straight line, the hint carried along without
/// twisting, the probe turning evenly against it.
class Way {
 public:
  static std::optional<Way> between(const Hold& from, const Hold& to, const Skin& skin) {
    Way way;
    Hold carried = from;
    carried.rotation_rad = carried.rock_rad = carried.tilt_rad = 0.0;
    for (int n = 0; n <= kWayPoints; ++n) {
      const double share = static_cast<double>(n) / kWayPoints;
      const Skin::Contact contact = n == 0            ? from.contact
                                    : n == kWayPoints ? to.contact
                                                      : skin.nearest(glm::mix(from.contact.point_mm, to.contact.point_mm, share));
      const double step_mm = glm::distance(contact.point_mm, carried.contact.point_mm);
      if (step_mm > kFarthestJump_mm) return std::nullopt;
      carried = movedTo(carried, contact);
      way.length_mm_.push_back(n == 0 ? 0.0 : way.length_mm_.back() + step_mm);
      way.holds_.push_back(carried);
    }
    way.press_mm_ = {from.press_mm, to.press_mm};
    way.turn_ = {glm::inverse(turnOf(poseOf(way.holds_.front()))) * turnOf(poseOf(from)),
                 glm::inverse(turnOf(poseOf(way.holds_.back()))) * turnOf(poseOf(to))};
    return way;
  }

  /// @param share of the way, 0 to 1
  [[nodiscard]] Pose at(double share, const Skin& skin) const {
    const double wanted_mm = share * length_mm_.back();
    const auto next =
        std::clamp<std::ptrdiff_t>(std::upper_bound(length_mm_.begin(), length_mm_.end(), wanted_mm) - length_mm_.begin(), 1, kWayPoints);
    const auto before = static_cast<std::size_t>(next - 1);
    const double step_mm = length_mm_[before + 1] - length_mm_[before];
    const double within = step_mm > 0.0 ? std::clamp((wanted_mm - length_mm_[before]) / step_mm, 0.0, 1.0) : 0.0;
    Hold here = holds_[before];
    if (within > 0.0) here = movedTo(here, skin.nearest(glm::mix(here.contact.point_mm, holds_[before + 1].contact.point_mm, within)));
    here.press_mm = glm::mix(press_mm_[0], press_mm_[1], share);
    Pose pose = poseOf(here);
    const glm::dmat3 turn = glm::mat3_cast(glm::normalize(turnOf(pose) * glm::slerp(turn_[0], turn_[1], share)));
    for (int column = 0; column < 3; ++column) pose.probeToWorld.matrix[column] = glm::dvec4(turn[column], 0.0);
    return pose;
  }

 private:
  std::vector<Hold> holds_;
  std::vector<double> length_mm_;
  std::array<double, 2> press_mm_{};
  std::array<glm::dquat, 2> turn_{};
};

/// To sixteenths of a mm, which are written in a few digits: a recording is a fifth shorter, and gel fills gaps fifty times as wide.
std::vector<float> shortened(std::vector<float> gaps_mm) {
  for (float& gap_mm : gaps_mm) gap_mm = std::round(16.0F * gap_mm) / 16.0F;
  return gaps_mm;
}

double leastJerk(double t) { return t * t * t * (10.0 + t * (-15.0 + 6.0 * t)); }

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

Result<ExpertPath> readExpertPath(const std::filesystem::path& file) {
  const auto text = readTextFile(file, kLargestPath_bytes);
  if (!text) return passOn(text.error());
  const Message where = verbatim(file.filename().string());
  const auto document = parseJsonObject(*text, where);
  if (!document) return passOn(document.error());
  JsonReading reading(where, {"note"});
  const JsonFields fields(*document, reading);
  requireFormat(fields, kExpertPathFormat);
  fields.only({"format", "probe", "rate_hz", "knobs", "stations"});
  ExpertPath path;
  path.probe = fields.text("probe", std::string(), 0);
  path.rate_hz = fields.number("rate_hz", 1.0, 60.0, path.rate_hz);
  json knobs = fields.object("knobs").value();
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
      const auto way = Way::between(*before, *hold, ground.skin);
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
