#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "ew/library/case_truth.h"
#include "ew/scanning/preset.h"
#include "ew/scanning/recording.h"
#include "ew/tracking/hand.h"

namespace ew::cli {

inline constexpr int kExpertPathFormat = 1;

/// Where an expert's hand comes to rest for a while, how it gets there and what is changed on the console on the way.
struct ExpertStation {
  std::string plane;         ///< a target plane of the case, or "start" for its start pose; empty: `pose`
  std::optional<Pose> pose;  ///< of the probe in the world
  double slideLateral_mm = 0.0;
  double slideElevational_mm = 0.0;  ///< along the skin, as the probe lies
  double rotation_rad = 0.0;
  double tilt_rad = 0.0;
  double rock_rad = 0.0;
  double travel_s = 3.0;  ///< from the station before; the first is where the scan begins
  double stay_s = 2.0;
  Knobs knobs;  ///< from the moment the hand leaves for it
};

/// The path of an expert's scan, which is recorded without a window.
struct ExpertPath {
  std::string probe;  ///< id; empty: that of the case's start preset, or its first
  double rate_hz = 10.0;
  std::vector<ExpertStation> stations;
};

/// What the expert scans with.
struct ExpertConsole {
  const Case& opened;
  const std::vector<Probe>& probes;
  const std::vector<Preset>& presets;
};

/// {"format": 1, "probe": "convex-3.5", "rate_hz": 10, "knobs": {...}, "stations": [{"plane": "femur", "offset": {"slide_mm": [0, 20],
/// "rotation_deg": 0, "tilt_deg": 0, "rock_deg": 0}, "travel_s": 3, "stay_s": 2, "knobs": {...}}, ...]}. The scan begins with the case's
/// start preset, which "knobs" change; a station's knobs change those before it and stay changed.
/// @error badHeader, badField (field, value found, value expected), newerFormat, notRigid, as knobsFromJson
[[nodiscard]] Result<ExpertPath> readExpertPath(const std::filesystem::path& file, const ExpertConsole& console);

/// What the hand scans on.
struct ExpertGround {
  const Case& opened;
  const CaseTruth& truth;
  const Skin& skin;
  const Probe& probe;
};

/// The scan along the path: the contact slides over the skin and the angles turn with least jerk (Flash and Hogan, J. Neurosci. 5(7),
/// 1985: s = 10 t^3 - 15 t^4 + 6 t^5); the breath is held at the end of expiration, where target planes lie. The same for the same files.
/// @error badField (a plane the case does not have, with those it has; no start pose; two stations so that no way on the skin leads from
///        one to the other), cancelled
[[nodiscard]] Result<ScanRecording> recordAlong(const ExpertPath& path, const ExpertGround& ground, Progress& progress);

}  // namespace ew::cli
