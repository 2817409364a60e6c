#pragma once

#include "ew/imaging/echo_quality.h"
#include "ew/imaging/effects/beam_gain.h"
#include "ew/imaging/effects/gain.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/tissue_level.h"

namespace ew::detail {

/// How much of everything a frame has to do: what estimates count.
struct FrameSize {
  double pixels = 0.0;  ///< inside the fan
  int lines = 0;        ///< of the beam grid
  int samples = 0;
};

/// Sample distance along beams, mm: a pixel of the image or half of the volume's finest voxel, whichever is larger, but 200 to 1200
/// samples to the depth. Finer than that, a volume has nothing to show.
[[nodiscard]] double beamSpacing_mm(const DisplayGeometry& geometry, const Grid& grid);

/// The scene without what cannot be done for want of tissue maps, or of a recorded volume's grain; and without the little walls and the
/// texture of drawn tissue where tissue was recorded, which has its own, as it has the brightness of its machine. Live echoes are as good
/// as the knobs ask; of harmonics, less reaches the side lobes and all of them are nearer to the noise.
[[nodiscard]] Scene knownScene(Scene scene, const FrameParts& parts, const Knobs& knobs);
/// The knobs without what this scene cannot do: harmonics and compounding are of echoes formed anew, compounding of linear and convex
/// probes that send parallel or radial lines, and not of the fast quality; colour is of blood that is known.
/// @param scene as knownScene gave it
[[nodiscard]] Knobs knownKnobs(Knobs knobs, const Probe& probe, const Scene& scene, const FrameParts& parts);
/// Whether live echoes take up the grain of the recorded volume.
[[nodiscard]] inline bool keepsOwnGrain(const Scene& scene) { return scene.liveEchoes && scene.liveEchoes->ownGrain > 0.0; }
/// Sample distance of live echoes, mm: as their pulse asks for.
[[nodiscard]] double liveSpacing_mm(const Probe& probe, const Knobs& knobs, const Scene& scene, double depth_mm);

/// echoWorkOf for what was brought within limits already, with the quality the knobs ask for in the scene.
[[nodiscard]] EchoWork knownEchoWork(const Probe& probe, const Knobs& knobs, const Scene& scene, double depth_mm);

/// Everything there is to sample for an image.
/// @param spacing_mm of samples along beams
[[nodiscard]] FrameSize frameSizeOf(const Probe& probe, const DisplayGeometry& geometry, double spacing_mm, const Spans& spans);

/// The knobs with a carrier the probe has: the nearest one to what was asked, its own when nothing was.
[[nodiscard]] Knobs withCarrierOf(const Probe& probe, const Knobs& knobs);

/// What acts on beams, in decibels; neutral by the paper's law.
[[nodiscard]] BeamGainSetting beamGainOf(const Knobs& knobs, const Scene& scene);

/// The dynamic range and grey map that follow gain and DGC; in decibels the range is on beams already.
[[nodiscard]] Tone toneOf(const Knobs& knobs, const Scene& scene);

/// Whether the paper's gain and DGC act.
[[nodiscard]] bool hasPaperGain(const Knobs& knobs, const Scene& scene);

/// makePlan for what was brought within limits and counted already.
/// @param hasGaps whether parts of the face are off the skin
[[nodiscard]] Plan planOf(const Probe& probe, const Knobs& knobs, const Scene& scene, const DisplayGeometry& geometry, const Grid& grid,
                          const FrameSize& size, bool hasLabels, bool hasGaps);

}  // namespace ew::detail
