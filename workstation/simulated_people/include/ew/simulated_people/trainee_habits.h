#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace ew {

enum class SkillLevel { novice, intermediate, expert };
inline constexpr SkillLevel kSkillLevels[] = {SkillLevel::novice, SkillLevel::intermediate, SkillLevel::expert};
/// "novice", "intermediate", "expert".
[[nodiscard]] std::string_view wordOf(SkillLevel level);

/// How a simulated person moves, looks, sets the machine and answers. The defaults make no error at all; the model that these numbers act
/// in is written down in resources/docs/science/simulated-trainees.md. Standard deviations are of normal errors about what is meant.
struct TraineeHabits {
  // Movements of the hand: a first one and corrections.
  double slide_mmPerS = 30.0;   ///< mean speed over the skin of a long movement, > 0
  double turn_degPerS = 25.0;   ///< the same about the probe's axes, > 0
  double shortestMove_s = 0.4;  ///< > 0
  double pace = 0.0;            ///< standard deviation of the logarithm of a movement's time
  double overshoot = 0.0;       ///< mean share by which a first movement goes too far
  double scatter = 0.0;         ///< standard deviation of a movement's end, as a share of its length
  double wobble_s = 0.0;        ///< standard deviation of the way's sideways error at a speed of 1 mm/s, in mm
  double tremor_mm = 0.0;       ///< standard deviation along each axis of the skin, 8 to 12 Hz
  double tremor_deg = 0.0;      ///< the same about each axis of the probe
  // Search.
  double wrongWay = 0.0;        ///< probability of setting out in a wrong direction
  double searches = 0.0;        ///< mean number of looks beside the target before it is recognised
  double searchReach_mm = 0.0;  ///< standard deviation of such looks
  double searchTurn_deg = 0.0;
  double pause_s = 0.0;         ///< mean rest between two movements
  double planeError_mm = 0.0;   ///< standard deviation of the final hold from the target, along each axis of the skin
  double planeError_deg = 0.0;  ///< the same about each axis of the probe
  // Contact.
  double press = 0.0;          ///< of usualPress_mm; 0: as much as the target plane has by itself
  double pressError_mm = 0.0;  ///< standard deviation between steps
  double pressDrift_mm = 0.0;  ///< standard deviation within a step, below 0.3 Hz
  double contactLoss = 0.0;    ///< share of a step's scanning during which the probe is off the skin, 0 to 0.5
  // Settings of the machine.
  double settingLeft = 0.0;    ///< probability of leaving a setting as it is found
  double overcorrected = 0.0;  ///< probability of a setting going twice as far as needed
  double depthError = 0.0;     ///< standard deviation of the depth's logarithm
  double gainError_db = 0.0;
  double focusError = 0.0;  ///< standard deviation of the focus' logarithm
  double rangeError_db = 0.0;
  double wrongProbe = 0.0;  ///< probability of taking any other probe of the case where one is asked for
  // Answers and marks.
  double wrongAnswer = 0.0;  ///< probability
  double numberError = 0.0;  ///< standard deviation of a right number, in tolerances
  double mistaken = 0.0;     ///< probability of pointing at something else
  double pointError_mm = 0.0;
  double caliperError_mm = 0.0;  ///< of each caliper along either direction of the image
  // Survey.
  double missedTarget = 0.0;   ///< probability of not visiting a target of a free scan
  double sweep_mmPerS = 25.0;  ///< > 0
  double sweepGap = 0.0;       ///< of an image's width that is left out between two passes of a sweep
  double sweepShort = 0.0;     ///< share of a structure's length that a sweep leaves out, both ends together, 0 to 0.9
  double interruptions = 0.0;  ///< mean number of stops in one pass of a sweep
  // Time beside the scan.
  double thinking_s = 0.0;  ///< mean before a step's first movement, and before an answer
  double hints = 0.0;       ///< mean number asked for in a step that has some
  bool operator==(const TraineeHabits&) const = default;
};

/// One habit of the model: where the levels stand, and how far people of one level differ.
struct HabitRange {
  std::string_view name;  ///< as the member
  double TraineeHabits::*member = nullptr;
  double novice = 0.0;  ///< medians of the levels
  double expert = 0.0;
  double personSpread = 0.0;   ///< between persons of one level: standard deviation of the logarithm, of probabilities of the log odds
  bool isProbability = false;  ///< 0 to 1
  bool moreIsWorse = true;
};
[[nodiscard]] std::span<const HabitRange> habitRanges();

/// Where intermediates stand between novices and experts, on the scale that a habit varies on: as their ratings do, (3.3 - 1.5) / (4.4
/// - 1.5) of OSAUS in biometry (Tolsgaard et al., Ultrasound Obstet Gynecol 2014, PMID 23996613).
inline constexpr double kIntermediateShare = 0.62;
/// Correlation of any two habits of a person: who is good at one is rather good at others.
inline constexpr double kPersonCorrelation = 0.36;
/// Between attempts of one person, on the same scales.
inline constexpr double kAttemptSpread = 0.2;

/// The median person of a level.
[[nodiscard]] TraineeHabits habitsOf(SkillLevel level);
/// A person of a level; the same for the same seed.
[[nodiscard]] TraineeHabits personOf(SkillLevel level, std::uint64_t seed);
/// The person on one day.
[[nodiscard]] TraineeHabits onOneDay(const TraineeHabits& person, std::uint64_t seed);

}  // namespace ew
