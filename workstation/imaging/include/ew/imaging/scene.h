#pragma once

#include <optional>
#include <string>
#include <vector>

namespace ew {

/// How sound behaves in the tissue that a label stands for.
struct TissueAcoustics {
  int label = 0;  ///< value in the label volume
  std::string name;
  double attenuation_dbPerCmMhz = 0.5;  ///< one way
  double reflection_db =
      0.0;  ///< lost once, both ways together, on entering the tissue from another one: 0 soft tissue, 20 and more stone, bone, gas
  double impedance_mrayl = 1.6;  ///< acoustic impedance: below 0.05 gas, below 0.5 aerated lung, behind which live echoes reverberate
  bool operator==(const TissueAcoustics&) const = default;
};

/// effects/focus.h: lateral resolution that depends on depth and on the focus marks.
struct FocusEffect {
  double strength = 1.0;  ///< scales the width the beam has beyond the recorded volume's own; 0..3
  bool operator==(const FocusEffect&) const = default;
};

/// effects/slice_thickness.h: the image is an average over the beam's elevational width.
struct SliceThicknessEffect {
  double scale = 1.0;  ///< of the probe's own thickness, 0.1..4
  bool operator==(const SliceThicknessEffect&) const = default;
};

/// effects/attenuation.h: shadow behind what takes sound away, enhancement behind what takes less than the machine expects.
struct AttenuationEffect {
  double expected_dbPerCmMhz = 0.5;    ///< what the machine's own compensation removes
  double interfaceLevel = 215.0;       ///< grey levels from here on reflect, when no labels say what they are
  double interface_dbPerMm = 6.0;      ///< loss, both ways, in each mm of such grey
  double fluidLevel = 8.0;             ///< smoothed grey levels up to here take nothing, when no labels say what they are
  double largestEnhancement_db = 9.0;  ///< the machine's amplifier ends here
  bool operator==(const AttenuationEffect&) const = default;
};

/// effects/reverberation.h: repeated echoes between the face and strong interfaces, and mirror images beyond them. Of live echoes, whose
/// tissues are known, gas and lung are the interfaces, whatever their level: ring-down, comet tails, A-lines, mirrored liver; and clutter.
struct ReverberationEffect {
  double interfaceLevel = 200.0;   ///< grey levels from here on are strong interfaces
  double loss_dbPerBounce = 14.0;  ///< of each way there and back
  int bounces = 3;                 ///< 1..6
  bool mirror = true;              ///< mirror images beyond smooth strong interfaces
  double mirrorLoss_db = 12.0;
  double ringDown_db = -8.0;           ///< live echoes: ring-down of gas where it begins, below the front's echo, -60 (none)..20
  double ringDownFall_dbPerMm = 0.65;  ///< live echoes: its fall, 0.05..10
  double clutter_db = -22.0;           ///< live echoes: copies of layers a few mm deeper, -60 (none)..0
  double shadowHaze_db = -14.0;        ///< live echoes: sound that wandered about, below the mean of what lies in front, -60 (none)..0
  bool operator==(const ReverberationEffect&) const = default;
};

/// effects/noise.h: electronic noise, which the machine's own depth compensation makes grow with depth.
struct NoiseEffect {
  double atFace_db = -105.0;       ///< noise level below full white at the face
  double growth_dbPerCmMhz = 0.5;  ///< of the compensation: both ways, times frequency
  double largest_db = -44.0;       ///< noise level where the compensation ends
  bool operator==(const NoiseEffect&) const = default;
};

/// effects/contact.h: parts of the face off the skin go dark and ring down.
struct ContactEffect {
  double gel_mm = 3.0;      ///< gaps up to here are filled by gel
  double ringDown_mm = 12;  ///< length of the bright lines under a face in air
  bool operator==(const ContactEffect&) const = default;
};

/// effects/live_echoes.h: echoes formed anew for each frame from what is known of the tissue; acts on subjects with tissue maps alone.
/// Of a recorded volume (TissueMaps::isRecorded) texture and fragments are left out: it has its own.
struct LiveEchoesEffect {
  int looks = 3;  ///< sub-bands of the pulse whose envelopes are averaged, 1..5: less grain, a pulse (looks + 1) / 2 times as long
  double pulseCycles = 2.15;       ///< length of the whole pulse (full width at half maximum of its amplitude), in periods, 0.5..6
  double scatterersPerCell = 3.5;  ///< in the smallest resolution cell, 1..10; below 3 speckle is no longer fully developed
  double samplesPerPulse = 6.0;    ///< along a line, within the pulse's full width at half maximum, 3..10
  double reach = 2.2;             ///< of the elevational beam, in standard deviations, 1..3: what lies farther beside the slice is left out
  double apertureShare = 0.75;    ///< of the probe's widest aperture that is active, 0.2..1
  double receiveFNumber = 2.0;    ///< depth over aperture on reception, at least: near the face the aperture opens with depth, 1..4
  double lineFilterWidth = 1.0;   ///< how much neighbouring lines, added up, widen the beam, 1..3
  double lineAverage = 0.25;      ///< what each neighbouring line adds to the envelope of a line, 0..0.3
  double gain_db = 9.0;           ///< between the levels of the maps and those of the image, -30..30
  double texture_db = 1.2;        ///< scatter of the scatterers' strength beside speckle, standard deviation of a normal one, 0..6
  double fragmentsPerCm3 = 37.0;  ///< little walls and fissures too small for maps, of all directions, 0..37; few are seen from one side
  double fragment_db = 16.0;      ///< their echo above the tissue around them, where they lie square to the beam, -20..40
  double speckleReduction = 0.3;  ///< by how much the machine's filter flattens grain about the mean of 2 mm, 0 (no filter)..0.8
  double haze_db = -29.0;         ///< side lobes' echo of everything at the same depth within 8 mm, below its own, -80 (none)..-10
  double ownGrain = 0.8;          ///< of a recorded volume: how much of its own grain is kept, 0 (all grain is formed anew)..1 (its slice)
  bool operator==(const LiveEchoesEffect&) const = default;
};

/// imaging/tissue_motion.h: the patient breathes, the pulse beats, the gut moves; acts on live echoes of subjects whose motion is known.
struct MotionEffect {
  double strength = 1.0;  ///< of the patient's own motion, 0..1
  bool operator==(const MotionEffect&) const = default;
};

/// What a case says its scene calls for; the plan runs nothing else. An effect that is absent costs nothing.
struct Scene {
  bool gainAndDgc = true;
  std::optional<LiveEchoesEffect> liveEchoes = std::nullopt;
  double recordedDynamicRange_db = 60.0;  ///< what 0..255 of the volume span, 20..120
  std::optional<FocusEffect> focus = std::nullopt;
  std::optional<SliceThicknessEffect> sliceThickness = std::nullopt;
  std::optional<AttenuationEffect> attenuation = std::nullopt;
  std::optional<ReverberationEffect> reverberation = std::nullopt;
  std::optional<NoiseEffect> noise = std::nullopt;
  std::optional<ContactEffect> contact = std::nullopt;
  std::optional<MotionEffect> motion = std::nullopt;
  std::vector<TissueAcoustics> tissues = {};  ///< of the label volume, when the case has one
  bool operator==(const Scene&) const = default;
};

/// Every effect at its usual strength: what the workstation offers for a volume without a case.
[[nodiscard]] Scene sceneWithEverything();

/// The nearest scene that every step can work with: each number brought into its range (those of settings_json.h), one that is not a
/// number to the default.
[[nodiscard]] Scene limited(const Scene& scene);

}  // namespace ew
