#pragma once

#include <array>
#include <span>
#include <vector>

#include "echo_layout.h"
#include "echo_motion.h"
#include "ew/imaging/bands.h"
#include "ew/imaging/slice_source.h"
#include "label_rows.h"

namespace ew::detail {

/// Sound that goes to and fro, in the field of live echoes. Behind a place at the range R where a line enters gas or aerated lung, whose
/// front echoes with the amplitude F there (losses included, 1 full white at neutral gain):
///   gas    ring-down, F 10^((ringDown_db - ringDownFall_dbPerMm d) / 20) at d behind the front: noise in stripes of 1 to 3 mm, the same
///          across a patch of 3 mm of the front, some of which ring louder, and under it stray sound that fades more slowly; so the
///          shadow of gas is dirty
///   lung   comet tails at one patch in nine, shorter and fainter; what lies in front, mirrored: field(R - d) at R + d, mirrorLoss_db below
///   both   what lies between face and front once more, n times: F field(s) at s + n R, n loss_dbPerBounce below; the front itself comes
///          back as lines at 2 R, 3 R (A-lines); 8 dB less behind gas, whose front is rough
/// and everywhere copies of the line 3.1 to 13.7 mm deeper, clutter_db below, falling by 1 dB a mm: layers of the body's wall, seen in
/// what is dark behind them. They waver from line to line by up to 1.1 mm and 10 dB: a bright line has no ladder of itself below it.
/// And everywhere a haze of sound that wandered about between the layers in front: noise whose power is the mean of the line's so far,
/// shadowHaze_db below it. What lies square to the beam sends its sound straight back, where it does not wander: a piece of the line
/// counts at most 6 dB above the mean before it. Shadows fill with the haze; it changes with the probe's place and stands where that
/// stands.
/// Patches are fixed in the tissue. A line is made from itself alone, so pixels do not depend on threads.
/// Source: ring-down, comet tails, A-lines and mirror images as Kremkau, Sonography: Principles and Instruments (chapter on artifacts) and
/// Lichtenstein, Whole Body Ultrasonography in the Critically Ill (2010) describe them; the formulas and figures are ours.
class EchoReverberation {
 public:
  /// What a label is to sound that comes back from it.
  enum class Aerated { no, gas, lung };
  [[nodiscard]] static Aerated aeratedOf(const TissueAcoustics& tissue);

  void configure(const EchoLayout& layout, const Scene& scene);
  /// Where each line first enters gas or lung.
  /// @param labels on a grid of their own
  /// @param motion of the body, in which the labels' tissue has gone elsewhere
  void find(const SliceSource& labels, const Transform<frame::Voxel, frame::Probe>& probeToLabel, const EchoMotion& motion, Bands& bands);
  /// How a patch rings, column by column behind its front, for whatever echo set it off: noise of its own, in stripes.
  struct Ring {
    std::uint32_t key = 0;
    double sampleSpacing_mm = 0.0;
    std::vector<float> wave;  ///< complex numbers, as far as it was asked for
  };
  /// One for each thread: the line as it was, and rings of patches, which neighbouring lines and the next frames share.
  struct Scratch {
    std::vector<float> before, amplitudes;
    std::array<Ring, 32> rings;
    Ring own;
  };
  /// Adds what comes back to a line of the field, after its losses.
  /// @param field 2 x columns, complex numbers
  void add(int line, std::span<float> field, Scratch& scratch) const;

 private:
  struct Front {
    double range_mm = -1.0;  ///< none below 0
    bool isLung = false;
    std::uint32_t patch = 0;  ///< hash of the piece of tissue it lies in
  };
  struct Echo {
    int column = 0;
    float amplitude = 0.0F;
  };
  void findFronts(const LabelBlend& blend, const EchoMotion& motion, int first, int count);
  [[nodiscard]] Echo frontEcho(const Front& front, const float* before, std::vector<float>& amplitudes) const;
  void ringDown(int line, const Echo& echo, Scratch& scratch, std::span<float> field) const;
  /// How fast a ring dies away: behind gas, in a comet tail, of stray sound.
  enum class Fall { gas, tail, stray };
  /// One patch, from the front on: `first` of its echo, falling.
  void addRing(std::uint32_t key, double first, Fall kind, const Echo& echo, Ring& ring, std::span<float> field) const;
  void layFalls();
  void bounce(const Front& front, const Echo& echo, const float* before, std::span<float> field) const;
  void mirror(const Echo& echo, const float* before, std::span<float> field) const;
  void layClutter();
  void clutter(int line, const float* before, std::span<float> field) const;
  void haze(int line, const float* before, std::span<float> field) const;

  const EchoLayout* layout_ = nullptr;
  ReverberationEffect effect_;
  float noiseScale_ = 1.0F;  ///< of one part of complex white noise whose power is 1 behind the pulse's filter
  std::array<float, 256> isGas_{};
  std::array<float, 256> isLung_{};
  bool hasAerated_ = false;
  std::uint32_t place_ = 0;  ///< hash of where the probe is
  std::vector<Front> fronts_;
  struct Copy {
    int delay = 0;  ///< columns
    float weight = 0.0F;
    int quarter = 0;  ///< of a turn
  };
  std::vector<Copy> copies_;                 ///< by line, the copies of clutter one after another; none where there is none
  std::array<std::vector<float>, 3> falls_;  ///< by Fall, by columns from the front on
  LineWays ways_;                            ///< scratch: in voxels of the labels
  std::vector<glm::vec3> back_;              ///< scratch: as EchoMotion::rowsOf gives it
};

}  // namespace ew::detail
