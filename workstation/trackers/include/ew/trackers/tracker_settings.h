#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "ew/core/result.h"
#include "ew/trackers/camera_device.h"
#include "ew/trackers/hand_controller.h"
#include "ew/trackers/igtl_client.h"
#include "ew/trackers/marker_body.h"
#include "ew/trackers/sequence_device.h"
#include "ew/tracking/tracked_probe.h"

namespace ew {

/// A camera as it is kept: bodies by their ids, since their files may change.
struct CameraSource {
  CameraSettings camera;  ///< its `probe` and `board` are not kept
  std::string probeBody = "box-60";
  std::string boardBody = "mannequin-board";  ///< empty: the camera stands still
  bool operator==(const CameraSource&) const = default;
};

/// One tracker of the user's list.
struct TrackerSettings {
  std::string id{};    ///< of lower-case letters, digits and hyphens; no other in the list has it; calibrations name it as their source
  std::string name{};  ///< as shown
  std::variant<IgtlSettings, CameraSource, SequenceSettings, HandControllerSettings> source{};
  TrackedProbeOptions probe{};  ///< of a hand controller: unused
  bool operator==(const TrackerSettings&) const = default;
};

/// The user's trackers: resources/schemas/trackers.schema.json.
struct TrackerList {
  static constexpr int kFormat = 1;
  static constexpr std::size_t kMost = 50;  ///< trackers in a list that can be written and read
  std::vector<TrackerSettings> trackers;
  std::string chosen;       ///< id; empty: the mouse
  bool startsOn = false;    ///< the chosen one was in use when the program ended
  bool soundsLost = false;  ///< a sound when the probe is lost
  bool serves = false;      ///< the scan is sent to others over OpenIGTLink
  int servePort = 18944;
  bool servesNetwork = false;  ///< computers of the network may connect too; otherwise programs of this one alone
  bool operator==(const TrackerList&) const = default;
};

/// PLUS on this computer, the first camera, a SpaceMouse and a game controller, none of them in use.
[[nodiscard]] TrackerList usualTrackers();
/// An id for a new tracker: made of its name, unlike those there are.
[[nodiscard]] std::string newTrackerId(const TrackerList& list, const std::string& name);

/// @param where how sentences name the document @error badField, newerFormat
[[nodiscard]] Result<TrackerList> trackersFromJson(const nlohmann::json& document, const Message& where);
/// trackersFromJson(toJson(list), where) == list
[[nodiscard]] nlohmann::json toJson(const TrackerList& list);
/// @error notFound, notReadable, tooLarge, badHeader (not JSON), otherwise as trackersFromJson
[[nodiscard]] Result<TrackerList> readTrackers(const std::filesystem::path& file);
/// Whole or not at all. @error notWritable
[[nodiscard]] Result<void> writeTrackers(const TrackerList& list, const std::filesystem::path& file);

/// The device of a tracker, not started.
/// @param bodies among which a camera finds those it is set to
/// @error notFound (a body that is not there); badUsage for a hand controller, which is no tracker: makeHandController()
[[nodiscard]] Result<std::unique_ptr<TrackerDevice>> makeDevice(const TrackerSettings& settings, std::span<const MarkerBody> bodies);
/// How the probe is followed: a camera's tool and reference are its bodies, whatever the options name.
[[nodiscard]] TrackedProbeOptions probeOptionsOf(const TrackerSettings& settings);

}  // namespace ew
