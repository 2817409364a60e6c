#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "ew/core/memory.h"
#include "ew/core/pose.h"
#include "ew/imaging/probe.h"
#include "ew/io/sequence.h"
#include "ew/phantom/deformation.h"
#include "ew/phantom/motion.h"
#include "ew/phantom/patient.h"
#include "ew/phantom/virtual_scanner.h"

namespace ew {

enum class SweepKind {
  freehand,   ///< over the skin along a path of points, leaning by hand
  parallel,   ///< a motor pushes the probe straight on, frames parallel
  fan,        ///< a motor tilts the image plane about the face's lateral axis, or one parallel to it behind the face
  rotational  ///< a motor turns the image plane about the central beam
};

/// What a sweep file (resources/schemas/sweep.schema.json) says: probe, path, machine settings, tracker and errors.
struct SweepRecipe {
  std::string name;
  std::string probe;  ///< id of a file in resources/probes
  SweepKind kind = SweepKind::freehand;
  int frames = 100;  ///< the first at the path's beginning, the last at its end
  double framesPerSecond = 20.0;
  FormationOptions formation;

  /// freehand: the face's centre over the skin, with which way the image looks; joined by a smooth curve. One alone: held still.
  /// The others: one station; a parallel motor starts there, a fan's middle image and a rotation's first one are there.
  struct Station {
    glm::dvec3 near_mm{0.0};                    ///< a point near the skin: the face is put on the skin next to it
    glm::dvec3 lateral{1.0, 0.0, 0.0};          ///< world direction of the image's x axis, made square to the beam
    std::optional<glm::dvec3> towards_mm = {};  ///< a point the central beam runs to; absent: straight into the skin
    bool operator==(const Station&) const = default;
  };
  std::vector<Station> stations;
  bool onSkin = true;              ///< false: the face's centre is at near_mm itself, wherever that is (inside the body, in a bath)
  double extent_mm = 0.0;          ///< parallel: way of the motor, along the probe's z
  double extent_deg = 0.0;         ///< fan: angle of the motor, half to either side; rotational: from 0
  double axisBehindFace_mm = 0.0;  ///< fan: how far behind the face the motor's axis lies
  double unevenness = 0.0;         ///< freehand: how much speed and lean of the hand vary, 0..1
  std::uint64_t handSeed = 1;      ///< of the unevenness

  double indentation_mm = 0.0;  ///< how deep the face presses into the skin; the tissue below gives way
  bool breathing = false;       ///< tissue moves with the patient's breath while recording
  bool pulsating = false;
  bool ecg = false;          ///< record the electrocardiogram with each frame
  bool respiration = false;  ///< record the breath with each frame

  struct Tracker {
    double noise_mm = 0.0;             ///< standard deviation of each coordinate
    double noise_deg = 0.0;            ///< standard deviation about each axis
    double jitter_s = 0.0;             ///< standard deviation of the time between image and pose, and of unfiltered timestamps
    double latency_s = 0.0;            ///< poses lag behind images by this much: with an image comes the pose of so long before
    double dropOutShare = 0.0;         ///< of the frames, in runs: marked INVALID, with plausible numbers in them
    glm::dmat4 calibrationError{1.0};  ///< rigid: what the written calibration is off by, in the probe frame
    std::uint64_t seed = 1;
    bool operator==(const Tracker&) const = default;
  } tracker;

  bool scanLines = false;  ///< write scan lines (orientation FM, one a row) instead of converted images (orientation MF)
  double pixel_mm = 0.0;   ///< of converted images, and distance of samples along written lines; 0: depth / 512, of lines depth / 1024
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
  /// PLUS: per frame ProbeToReference and ImageToProbe, statuses, times; further fields as in ew/io/gating_fields.h. So it can be
  /// reconstructed as it is; a device set, where one is given, takes the place of its calibration.
  Sequence sequence;
  /// What a calibrated laboratory would have beside the recording: ImageToProbe as written, and the sector of the image as clip.
  DeviceSet deviceSet;
  std::vector<Transform<frame::World, frame::Probe>> trueProbeToWorld;  ///< one per frame, where the probe really was
  std::vector<double> trueTime_s;                                       ///< one per frame, from the beginning of the sweep
  std::vector<BodyState> trueState;
  /// The true calibration: pixel to probe frame, mm; as written it has the tracker's calibration error. Of scan lines: of the image they
  /// are meant to become.
  glm::dmat4 imageToProbe{1.0};
};

/// @error badField (no station, a station whose skin is not found, a probe that does not fit), tooLarge
[[nodiscard]] Result<SweepForecast> forecastSweep(const Patient& patient, const Probe& probe, const SweepRecipe& recipe);

/// Records a sweep. Frames are made in parallel and do not depend on the number of threads.
/// World frame = the sequence's "Reference".
/// @error as forecastSweep and makeVirtualScanner, cancelled (within 0.5 s)
[[nodiscard]] Result<VirtualSweep> recordSweep(const std::shared_ptr<const Patient>& patient, const Probe& probe, const SweepRecipe& recipe,
                                               int threads, Progress& progress, std::uint64_t maxBytes = kLargestVolume_bytes);

/// How the body is deformed at one moment of a recording: its own motion as far as the recipe asks for it, and the face's push. With what a
/// VirtualSweep holds of a frame it says where the tissue rests that the frame shows. The patient must outlive the result.
/// @param probeToWorld where the face is, pressed in
[[nodiscard]] std::unique_ptr<Deformation> deformationOf(const Patient& patient, const Probe& probe, const SweepRecipe& recipe,
                                                         const Transform<frame::World, frame::Probe>& probeToWorld, const BodyState& state);

}  // namespace ew
