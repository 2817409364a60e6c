#include <nlohmann/json.hpp>
#include <set>

#include "ew/core/data_file.h"
#include "ew/core/foreign_json.h"
#include "ew/core/json_fields.h"
#include "ew/core/word_table.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"
#include "ew/trackers/tracker_settings.h"

namespace ew {

namespace {

using nlohmann::json;

constexpr std::size_t kLongestPath = 4096;

enum class SourceKind { igtl, camera, recording, spaceMouse, gameController };
constexpr WordTable<SourceKind, 5> kSourceWords{{{"openigtlink", SourceKind::igtl},
                                                 {"camera", SourceKind::camera},
                                                 {"recording", SourceKind::recording},
                                                 {"space_mouse", SourceKind::spaceMouse},
                                                 {"game_controller", SourceKind::gameController}}};
constexpr WordTable<FilterKind, 4> kFilterWords{
    {{"automatic", FilterKind::automatic}, {"none", FilterKind::none}, {"kalman", FilterKind::kalman}, {"one_euro", FilterKind::oneEuro}}};
constexpr WordTable<RateMode, 2> kModeWords{{{"rate", RateMode::rate}, {"spring_back", RateMode::springBack}}};
constexpr WordTable<CornerMethod, 3> kCornerWords{
    {{"contour", CornerMethod::contour}, {"sub_pixel", CornerMethod::subPix}, {"edges", CornerMethod::edges}}};

// What is not filled in yet may be kept: the device says what is missing.
IgtlSettings igtlIn(const JsonFields& fields) {
  fields.only({"host", "port", "checks_sums", "speaks_version_3"});
  IgtlSettings read;
  read.host = fields.text("host", read.host, 0, 255);
  read.port = static_cast<int>(fields.whole("port", 1, 65535, read.port));
  read.checksSums = fields.flag("checks_sums", read.checksSums);
  read.speaksVersion3 = fields.flag("speaks_version_3", read.speaksVersion3);
  return read;
}

json jsonOf(const IgtlSettings& igtl) {
  return {{"host", igtl.host}, {"port", igtl.port}, {"checks_sums", igtl.checksSums}, {"speaks_version_3", igtl.speaksVersion3}};
}

CameraTrackingOptions cameraTrackingIn(const JsonFields& fields) {
  fields.only({"corners", "most_markers", "half_search", "follows_regions", "search_every_s", "smallest_marker_px", "largest_rms_px",
               "largest_spread_mm", "largest_spread_rad", "readout_s"});
  CameraTrackingOptions read;
  read.corners = fields.word("corners", kCornerWords, std::optional(read.corners));
  read.mostMarkers = static_cast<int>(fields.whole("most_markers", 1, 64, read.mostMarkers));
  read.halfSearch = fields.flag("half_search", read.halfSearch);
  read.followsRegions = fields.flag("follows_regions", read.followsRegions);
  read.searchEvery_s = fields.number("search_every_s", 0.0, 60.0, read.searchEvery_s);
  read.smallestMarker_px = fields.number("smallest_marker_px", 4.0, 500.0, read.smallestMarker_px);
  read.largestRms_px = fields.number("largest_rms_px", 0.05, 50.0, read.largestRms_px);
  read.largestSpread_mm = fields.number("largest_spread_mm", 0.01, 100.0, read.largestSpread_mm);
  read.largestSpread_rad = fields.number("largest_spread_rad", 1e-4, 1.0, read.largestSpread_rad);
  read.readout_s = fields.number("readout_s", 0.0, 0.1, read.readout_s);
  return read;
}

json jsonOf(const CameraTrackingOptions& tracking) {
  return {{"corners", wordIn(kCornerWords, tracking.corners)},
          {"most_markers", tracking.mostMarkers},
          {"half_search", tracking.halfSearch},
          {"follows_regions", tracking.followsRegions},
          {"search_every_s", tracking.searchEvery_s},
          {"smallest_marker_px", tracking.smallestMarker_px},
          {"largest_rms_px", tracking.largestRms_px},
          {"largest_spread_mm", tracking.largestSpread_mm},
          {"largest_spread_rad", tracking.largestSpread_rad},
          {"readout_s", tracking.readout_s}};
}

CameraSource cameraIn(const JsonFields& fields) {
  fields.only({"device", "width", "height", "frames_hz", "model", "probe_body", "board_body", "tracking", "film_loops", "film_speed"});
  CameraSource read;
  read.camera.device = fields.text("device", "0", 0, kLongestPath);
  read.camera.width = static_cast<int>(fields.whole("width", 64, 8192, read.camera.width));
  read.camera.height = static_cast<int>(fields.whole("height", 64, 8192, read.camera.height));
  read.camera.frames_hz = fields.number("frames_hz", 1.0, 1000.0, read.camera.frames_hz);
  if (const json* model = fields.find("model"); model != nullptr && fields.good()) {
    auto parsed = parseCameraModel(model->dump(), fields.reading().where());
    if (parsed)
      read.camera.model = *parsed;
    else
      fields.reading().refuse(parsed.error());
  }
  read.probeBody = fields.text("probe_body", read.probeBody, 0);
  read.boardBody = fields.text("board_body", read.boardBody, 0);
  read.camera.tracking = cameraTrackingIn(fields.object("tracking"));
  read.camera.filmLoops = fields.flag("film_loops", read.camera.filmLoops);
  read.camera.filmSpeed = fields.number("film_speed", 0.0, 100.0, read.camera.filmSpeed);
  return read;
}

json jsonOf(const CameraSource& source) {
  const CameraSettings& camera = source.camera;
  json made = {{"device", camera.device},
               {"width", camera.width},
               {"height", camera.height},
               {"frames_hz", camera.frames_hz},
               {"probe_body", source.probeBody},
               {"board_body", source.boardBody},
               {"tracking", jsonOf(camera.tracking)},
               {"film_loops", camera.filmLoops},
               {"film_speed", camera.filmSpeed}};
  if (camera.model) made["model"] = jsonOrNull(cameraModelText(*camera.model));
  return made;
}

SequenceSettings recordingIn(const JsonFields& fields) {
  fields.only({"file", "speed", "loops"});
  SequenceSettings read;
  read.file = fields.text("file", {}, 0, kLongestPath);
  read.speed = fields.number("speed", 0.1, 10.0, read.speed);
  read.loops = fields.flag("loops", read.loops);
  return read;
}

json jsonOf(const SequenceSettings& recording) {
  return {{"file", recording.file.string()}, {"speed", recording.speed}, {"loops", recording.loops}};
}

HandControllerSettings controllerIn(const JsonFields& fields, HandControllerKind kind) {
  fields.only({"mode", "dead_zone", "curve", "axes"});
  const RateMode mode = fields.word("mode", kModeWords, std::optional(RateMode::rate));
  HandControllerSettings read;
  read.kind = kind;
  read.hand = kind == HandControllerKind::spaceMouse ? spaceMouseOptions(mode) : gameControllerOptions(mode);
  read.hand.deadZone = fields.number("dead_zone", 0.0, 0.9, read.hand.deadZone);
  read.hand.curve = fields.number("curve", 1.0, 4.0, read.hand.curve);
  if (!fields.has("axes")) return read;
  const auto axes = fields.objects("axes", kHandMotions, kHandMotions);
  for (std::size_t n = 0; n < axes.size(); ++n) {
    axes[n].only({"axis", "reversed", "full"});
    read.hand.axes[n] = {.axis = static_cast<int>(axes[n].whole("axis", -1, 63)),
                         .reversed = axes[n].flag("reversed", false),
                         .full = axes[n].number("full", 0.0, 1000.0)};
  }
  return read;
}

json jsonOf(const HandControllerSettings& controller) {
  json axes = json::array();
  for (const RateAxis& axis : controller.hand.axes) axes.push_back({{"axis", axis.axis}, {"reversed", axis.reversed}, {"full", axis.full}});
  return {{"mode", wordIn(kModeWords, controller.hand.mode)},
          {"dead_zone", controller.hand.deadZone},
          {"curve", controller.hand.curve},
          {"axes", std::move(axes)}};
}

SourceKind kindOf(const TrackerSettings& tracker) {
  if (std::holds_alternative<IgtlSettings>(tracker.source)) return SourceKind::igtl;
  if (std::holds_alternative<CameraSource>(tracker.source)) return SourceKind::camera;
  if (std::holds_alternative<SequenceSettings>(tracker.source)) return SourceKind::recording;
  const bool isSpaceMouse = std::get<HandControllerSettings>(tracker.source).kind == HandControllerKind::spaceMouse;
  return isSpaceMouse ? SourceKind::spaceMouse : SourceKind::gameController;
}

TrackedProbeOptions probeIn(const JsonFields& fields) {
  fields.only({"tool", "reference", "filter", "predict", "stale_after_s", "well_measured_mm"});
  TrackedProbeOptions read;
  read.tool = fields.text("tool", read.tool, 0);
  read.reference = fields.text("reference", read.reference, 0);
  read.filter = fields.word("filter", kFilterWords, std::optional(read.filter));
  read.predict = fields.flag("predict", read.predict);
  read.staleAfter_s = fields.number("stale_after_s", 0.1, 10.0, read.staleAfter_s);
  read.wellMeasured_mm = fields.number("well_measured_mm", 0.1, 1000.0, read.wellMeasured_mm);
  return read;
}

json jsonOf(const TrackedProbeOptions& probe) {
  return {{"tool", probe.tool},       {"reference", probe.reference},        {"filter", wordIn(kFilterWords, probe.filter)},
          {"predict", probe.predict}, {"stale_after_s", probe.staleAfter_s}, {"well_measured_mm", probe.wellMeasured_mm}};
}

bool isTrackerId(const std::string& id) {
  return !id.empty() && id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-") == std::string::npos;
}

TrackerSettings trackerIn(const JsonFields& fields) {
  fields.only({"id", "name", "source", "settings", "probe"});
  TrackerSettings read;
  read.id = fields.text("id", {}, 1, 60);
  if (fields.good() && !isTrackerId(read.id)) fields.refuse("id", say<"of lower-case letters, digits and hyphens">());
  read.name = fields.text("name", {}, 1);
  const JsonFields settings = fields.object("settings");
  switch (fields.word("source", kSourceWords)) {
    case SourceKind::igtl:
      read.source = igtlIn(settings);
      break;
    case SourceKind::camera:
      read.source = cameraIn(settings);
      break;
    case SourceKind::recording:
      read.source = recordingIn(settings);
      break;
    case SourceKind::spaceMouse:
      read.source = controllerIn(settings, HandControllerKind::spaceMouse);
      break;
    case SourceKind::gameController:
      read.source = controllerIn(settings, HandControllerKind::gameController);
      break;
  }
  read.probe = probeIn(fields.object("probe"));
  return read;
}

}  // namespace

Result<TrackerList> trackersFromJson(const json& document, const Message& where) {
  JsonReading reading(where, {"note"});
  const JsonFields fields(document, reading);
  requireFormat(fields, TrackerList::kFormat);
  fields.only({"format", "trackers", "chosen", "starts_on", "sounds_lost", "serves", "serve_port", "serves_network"});
  TrackerList read;
  std::set<std::string> ids;
  for (const JsonFields& each : fields.objects("trackers", 0, TrackerList::kMost)) {
    read.trackers.push_back(trackerIn(each));
    if (each.good() && !ids.insert(read.trackers.back().id).second) each.refuse("id", say<"one that no other tracker of the list has">());
  }
  read.chosen = fields.text("chosen", read.chosen, 0, 60);
  if (fields.good() && !read.chosen.empty() && !ids.contains(read.chosen)) fields.refuse("chosen", say<"the id of one of the trackers">());
  read.startsOn = fields.flag("starts_on", read.startsOn);
  read.soundsLost = fields.flag("sounds_lost", read.soundsLost);
  read.serves = fields.flag("serves", read.serves);
  read.servesNetwork = fields.flag("serves_network", read.servesNetwork);
  read.servePort = static_cast<int>(fields.whole("serve_port", 1, 65535, read.servePort));
  if (reading.problem()) return passOn(*reading.problem());
  return read;
}

json toJson(const TrackerList& list) {
  json trackers = json::array();
  for (const TrackerSettings& each : list.trackers)
    trackers.push_back({{"id", each.id},
                        {"name", each.name},
                        {"source", wordIn(kSourceWords, kindOf(each))},
                        {"settings", std::visit([](const auto& source) { return jsonOf(source); }, each.source)},
                        {"probe", jsonOf(each.probe)}});
  return {{"format", TrackerList::kFormat}, {"trackers", std::move(trackers)},     {"chosen", list.chosen},
          {"starts_on", list.startsOn},     {"sounds_lost", list.soundsLost},      {"serves", list.serves},
          {"serve_port", list.servePort},   {"serves_network", list.servesNetwork}};
}

Result<TrackerList> readTrackers(const std::filesystem::path& file) {
  const Message where = say<"the list of trackers %1">(file.string());
  const auto document = readJsonFile(file, where);
  if (!document) return passOn(document.error());
  return trackersFromJson(*document, where);
}

Result<void> writeTrackers(const TrackerList& list, const std::filesystem::path& file) {
  if (list.trackers.size() > TrackerList::kMost)
    return failure(ErrorCode::badField,
                   say<"A list of trackers holds at most %1; remove those that are not used any more.">(TrackerList::kMost),
                   {{"field", "trackers"}});
  return writeFileSafely(file, toJson(list).dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

}  // namespace ew
