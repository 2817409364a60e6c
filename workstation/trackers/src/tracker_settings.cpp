#include "ew/trackers/tracker_settings.h"

#include <algorithm>
#include <cctype>

namespace ew {

TrackerList usualTrackers() {
  TrackerList list;
  CameraSource camera;
  camera.camera.device = "0";
  list.trackers = {{.id = "plus", .name = "PLUS", .source = IgtlSettings{}},
                   {.id = "camera", .name = "Camera", .source = camera},
                   {.id = "spacemouse", .name = "SpaceMouse", .source = HandControllerSettings{}},
                   {.id = "game-controller",
                    .name = "Game controller",
                    .source = HandControllerSettings{.kind = HandControllerKind::gameController, .hand = gameControllerOptions()}}};
  return list;
}

std::string newTrackerId(const TrackerList& list, const std::string& name) {
  std::string id;
  for (const char c : name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80U && std::isalnum(byte) != 0)
      id += static_cast<char>(std::tolower(byte));
    else if (!id.empty() && id.back() != '-')
      id += '-';
  }
  id = id.substr(0, 40);
  while (!id.empty() && id.back() == '-') id.pop_back();
  if (id.empty()) id = "tracker";
  const auto isTaken = [&](const std::string& wanted) {
    return std::any_of(list.trackers.begin(), list.trackers.end(), [&](const TrackerSettings& each) { return each.id == wanted; });
  };
  if (!isTaken(id)) return id;
  int number = 2;
  while (isTaken(id + "-" + std::to_string(number))) ++number;
  return id + "-" + std::to_string(number);
}

namespace {

Result<std::optional<MarkerBody>> bodyCalled(const std::string& id, std::span<const MarkerBody> bodies) {
  if (id.empty()) return std::optional<MarkerBody>();
  const auto found = std::find_if(bodies.begin(), bodies.end(), [&](const MarkerBody& each) { return each.id == id; });
  if (found == bodies.end())
    return failure(ErrorCode::notFound,
                   say<"The marker body '%1' is not there any more; choose another one in the settings of the camera.">(id),
                   {{"body", id}});
  return std::optional(*found);
}

Result<std::unique_ptr<TrackerDevice>> cameraOf(const CameraSource& source, std::span<const MarkerBody> bodies) {
  CameraSettings settings = source.camera;
  const auto probe = bodyCalled(source.probeBody, bodies);
  if (!probe) return passOn(probe.error());
  const auto board = bodyCalled(source.boardBody, bodies);
  if (!board) return passOn(board.error());
  settings.probe = *probe;
  settings.board = *board;
  return makeCamera(settings);
}

}  // namespace

Result<std::unique_ptr<TrackerDevice>> makeDevice(const TrackerSettings& settings, std::span<const MarkerBody> bodies) {
  if (const auto* igtl = std::get_if<IgtlSettings>(&settings.source)) return makeIgtlClient(*igtl);
  if (const auto* camera = std::get_if<CameraSource>(&settings.source)) return cameraOf(*camera, bodies);
  if (const auto* sequence = std::get_if<SequenceSettings>(&settings.source)) return makeSequenceDevice(*sequence);
  return failure(ErrorCode::badUsage,
                 say<"'%1' moves the probe on the skin and measures no place; it is used without calibration.">(settings.name));
}

TrackedProbeOptions probeOptionsOf(const TrackerSettings& settings) {
  TrackedProbeOptions options = settings.probe;
  if (const auto* camera = std::get_if<CameraSource>(&settings.source)) {
    options.tool = camera->probeBody;
    options.reference = camera->boardBody;
  }
  return options;
}

}  // namespace ew
