#include "event_json.h"

#include <utility>

#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/core/word_table.h"
#include "ew/imaging/settings_json.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr std::size_t kMostGapsOfFrame = 4096;
constexpr std::size_t kLongestGaps_bytes = 32 * kMostGapsOfFrame;
constexpr WordTable<PoseStatus, 3> kPoseStatusWords{
    {{"ok", PoseStatus::ok}, {"invalid", PoseStatus::invalid}, {"missing", PoseStatus::missing}}};

json jsonOf(const FrameMade& made) {
  json pose = json::array();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) pose.push_back(made.pose.probeToWorld.matrix[column][row]);
  // A gap may be endless, which JSON has no number for.
  std::string gaps;
  for (const float gap_mm : made.gaps_mm) gaps += (gaps.empty() ? "" : " ") + textOf(static_cast<double>(gap_mm));
  json frame = {{"number", made.number}, {"probe_to_world", std::move(pose)}, {"status", wordIn(kPoseStatusWords, made.pose.status)}};
  if (!gaps.empty()) frame["gaps_mm"] = std::move(gaps);
  if (!(made.body == BodyState{})) frame["body"] = {made.body.breath, made.body.pulse, made.body.bowel};
  return frame;
}

FrameMade frameOf(const JsonFields& frame) {
  constexpr double kFarthest_mm = 1e9, kHighestNumber = 9007199254740991.0;  // 2^53 - 1
  FrameMade made;
  made.number = static_cast<std::uint64_t>(frame.whole("number", 0, static_cast<long long>(kHighestNumber)));
  const auto pose = frame.numbers("probe_to_world", 16, 16, -kFarthest_mm, kFarthest_mm);
  for (std::size_t n = 0; n < pose.size(); ++n) made.pose.probeToWorld.matrix[static_cast<int>(n % 4)][static_cast<int>(n / 4)] = pose[n];
  made.pose.status = frame.word("status", kPoseStatusWords);
  if (const std::string gaps = frame.text("gaps_mm", "", 0, kLongestGaps_bytes); !gaps.empty()) {
    const auto numbers = parseNumbers(gaps);
    if (!numbers || numbers->size() > kMostGapsOfFrame)
      frame.refuse("gaps_mm", say<"distances in mm">());
    else
      for (const double gap_mm : *numbers) made.gaps_mm.push_back(static_cast<float>(gap_mm));
  }
  if (const auto body = frame.numbers("body", 3, 3, 0.0, 1.0, false); body.size() == 3) made.body = {body[0], body[1], body[2]};
  return made;
}

}  // namespace

json jsonOf(const ScanEvent& event) {
  json object = {{"time_s", event.time_s}};
  if (const auto* made = std::get_if<FrameMade>(&event.what)) {
    object["frame"] = jsonOf(*made);
    return object;
  }
  if (const auto* chosen = std::get_if<ProbeChosen>(&event.what)) {
    object["probe"] = toJson(chosen->probe);
    object["probe_id"] = chosen->probe.id;
  } else if (const auto* settings = std::get_if<SettingsChanged>(&event.what)) {
    object["settings"] = toJson(settings->knobs);
    if (!(settings->pan == Pan{})) object["pan_mm"] = {settings->pan.lateral_mm, settings->pan.axial_mm};
  } else if (const auto* scene = std::get_if<SceneChanged>(&event.what)) {
    object["scene"] = toJson(scene->scene);
  } else if (const auto* freeze = std::get_if<FreezeChanged>(&event.what)) {
    object["frozen"] = freeze->isFrozen;
  } else if (const auto* note = std::get_if<Note>(&event.what)) {
    object["note"] = note->kind;
    object["what"] = note->what;
  }
  return object;
}

Result<ScanEvent> eventOf(const json& object, const Message& where) {
  constexpr double kLongest_s = 1e9, kFarthestPan_mm = 1e6;
  JsonReading reading(where);
  const JsonFields fields(object, reading);
  ScanEvent event{fields.number("time_s", -kLongest_s, kLongest_s), Note{}};
  if (!reading.good()) return passOn(*reading.problem());
  if (fields.has("frame")) {
    auto frame = frameOf(fields.object("frame"));
    if (reading.problem()) return passOn(*reading.problem());
    event.what = std::move(frame);
  } else if (fields.has("probe")) {
    auto probe = probeFromJson(*fields.find("probe"), fields.text("probe_id", "", 0), where);
    if (!probe) return passOn(probe.error());
    event.what = ProbeChosen{std::move(*probe)};
  } else if (fields.has("settings")) {
    auto knobs = knobsFromJson(*fields.find("settings"), where);
    if (!knobs) return passOn(knobs.error());
    SettingsChanged settings{*knobs, {}};
    if (const auto pan = fields.numbers("pan_mm", 2, 2, -kFarthestPan_mm, kFarthestPan_mm, false); !pan.empty())
      settings.pan = {pan[0], pan[1]};
    event.what = settings;
  } else if (fields.has("scene")) {
    auto scene = sceneFromJson(*fields.find("scene"), where);
    if (!scene) return passOn(scene.error());
    event.what = SceneChanged{std::move(*scene)};
  } else if (fields.has("frozen")) {
    event.what = FreezeChanged{fields.flag("frozen")};
  } else {
    if (!fields.has("note")) fields.refuseWhole(shown(object), say<"an event that this program knows">());
    event.what = Note{fields.text("note", "", 0), fields.has("what") ? *fields.find("what") : json()};
  }
  if (reading.problem()) return passOn(*reading.problem());
  return event;
}

}  // namespace ew
