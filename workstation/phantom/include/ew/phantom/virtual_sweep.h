#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/pose.h"
#include "ew/imaging/probe.h"
#include "ew/io/sequence.h"
#include "ew/phantom/motion.h"
#include "ew/phantom/patient.h"
#include "ew/phantom/virtual_scanner.h"

namespace ew {

enum class SweepKind {
  freehand,   ///< over the skin along a path of points, leaning by hand
  parallel,   ///< a motor pushes the probe straight on, frames parallel
  fan,        ///< a motor tilts the image plane about the face's lateral axis
  rotational  ///< a motor turns the image plane about the beam axis
};

/// What a sweep file (resources/schemas/sweep.schema.json) says: probe, path, machine settings, tracker and errors.
struct SweepRecipe {
  std::string name;
  std::string probe;  ///< id of a file in resources/probes
  SweepKind kind = SweepKind::freehand;
  int frames = 100;
  double framesPerSecond = 20.0;
  FormationOptions formation;

  /// freehand: the face's centre over the skin, with which way the image looks; joined by a smooth curve.
  /// The others: one station, from which the motor starts.
  struct Station {
    glm::dvec3 near_mm{0.0};                    ///< a point near the skin: the face is put on the skin next to it
    glm::dvec3 lateral{1.0, 0.0, 0.0};          ///< world direction of the image's x axis, made square to the beam
    std::optional<glm::dvec3> towards_mm = {};  ///< a point the central beam runs to; absent: straight into the skin
    bool operator==(const Station&) const = default;
  };
  std::vector<Station> stations;
  double extent_mm = 0.0;   ///< parallel: way of the motor, along the probe's z
  double extent_deg = 0.0;  ///< fan, rotational: angle of the motor, half to either side (rotational: from 0)
  double unevenness = 0.0;  ///< freehand: how much speed and lean of the hand vary, 0..1

  double indentation_mm = 0.0;  ///< how deep the face presses into the skin; the tissue below gives way
  bool breathing = false;       ///< tissue moves with the patient's breath while recording
  bool pulsating = false;
  bool ecg = false;          ///< record the electrocardiogram with each frame
  bool respiration = false;  ///< record the breath with each frame

  struct Tracker {
    double noise_mm = 0.0;             ///< standard deviation of each coordinate
    double noise_deg = 0.0;            ///< standard deviation about each axis
    double jitter_s = 0.0;             ///< standard deviation of the time between image and pose
    double latency_s = 0.0;            ///< poses lag behind images by this much
    double dropOutShare = 0.0;         ///< of the frames, in runs: marked INVALID
    glm::dmat4 calibrationError{1.0};  ///< rigid: what the written calibration is off by, in the probe frame
    std::uint64_t seed = 1;
    bool operator==(const Tracker&) const = default;
  } tracker;

  bool scanLines = false;  ///< write scan lines (orientation FM) instead of converted images
  double pixel_mm = 0.0;   ///< of converted images; 0: about one sample in four
  std::uint64_t seed = 1;  ///< of scatterers; the same for every sweep of one patient
  bool operator==(const SweepRecipe&) const = default;
};

/// @error notFound, notReadable, tooLarge, badHeader, badField (place, value found, value expected), newerFormat
[[nodiscard]] Result<SweepRecipe> readSweepRecipe(const std::filesystem::path& file);

/// What recording will make and take.
struct SweepForecast {
  int frames = 0;
  int width_px = 0;
  int height_px = 0;
  std::uint64_t bytes = 0;  ///< at the peak, the patient not counted
};

/// A recorded sweep with the truth beside it.
struct VirtualSweep {
  Sequence sequence;  ///< PLUS: ProbeToReference (or to Tracker) per frame, statuses, times, ECG and respiration as fields, calibration
  std::vector<Transform<frame::World, frame::Probe>> trueProbeToWorld;  ///< one per frame, where the probe really was
  std::vector<BodyState> trueState;
  glm::dmat4 imageToProbe{1.0};  ///< the true calibration: pixel to probe frame, mm; as written it has the tracker's calibration error
};

/// @error badField (no station, a station whose skin is not found, a probe that does not fit), tooLarge
[[nodiscard]] Result<SweepForecast> forecastSweep(const Patient& patient, const Probe& probe, const SweepRecipe& recipe);

/// Records a sweep. Frames are made in parallel and do not depend on the number of threads.
/// World frame = the sequence's "Reference".
/// @error as forecastSweep and makeVirtualScanner, cancelled (within 0.5 s)
[[nodiscard]] Result<VirtualSweep> recordSweep(std::shared_ptr<const Patient> patient, const Probe& probe, const SweepRecipe& recipe,
                                               int threads, Progress& progress, std::uint64_t maxBytes = 16ull << 30);

}  // namespace ew
