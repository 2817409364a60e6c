#pragma once

#include <optional>
#include <vector>

#include "ew/imaging/flow_field.h"
#include "ew/phantom/patient.h"

namespace ew {

/// What the recipe's "flow" says of a narrowed vessel: how far the lumen is narrowed as it is drawn, and how far as blood goes through it.
/// They differ where the recipe gives a peak velocity: flow falls behind a narrow place, and profiles flatten, so that velocities by
/// continuity alone are far above those that are measured. Velocities are the truth of Doppler, the drawn lumen that of a diameter.
struct TrueStenosis {
  int stream = 0;  ///< of the flow field
  glm::dvec3 at_mm{0.0};
  double diameterLost = 0.0;      ///< share of the diameter, as the recipe says it; 0..0.95
  double diameterLostToFlow = 0;  ///< share of the diameter, by the velocity in it
  double peak_mmPerS = 0.0;       ///< the greatest velocity of a beat on its axis, without breath
};

/// What a Doppler examination of a section should find over one beat of the rhythm's own length, without breath. Velocities are along the
/// vessel, positive the way its line goes, and those of its fastest layer unless they say mean.
struct TrueWaveform {
  int stream = 0;  ///< of the flow field
  glm::dvec3 at_mm{0.0};
  double radius_mm = 0.0;
  double flow_mm3PerS = 0.0;           ///< on average
  double peakSystolic_mmPerS = 0.0;    ///< farthest from 0
  double endDiastolic_mmPerS = 0.0;    ///< just before the next upstroke: the least of the 0.4 of a beat before the peak
  double least_mmPerS = 0.0;           ///< of the envelope, against the peak's direction: on the other side of 0 flow reverses
  double timeAverageMax_mmPerS = 0.0;  ///< TAMX: of the envelope, where flow reverses with its sign
  double timeAverageMean_mmPerS = 0.0;
  [[nodiscard]] double resistiveIndex() const;  ///< (PSV - EDV) / PSV; 0 without flow
  /// (PSV - EDV) / TAMX, of flow that reverses (PSV - least) / TAMX (Gosling); empty where TAMX is below a twentieth of the peak.
  [[nodiscard]] std::optional<double> pulsatilityIndex() const;
};
/// Where the line of a stream is nearest to a place; empty without such a stream.
[[nodiscard]] std::optional<TrueWaveform> waveformNear(const FlowTruth& truth, int stream, const glm::dvec3& p_mm);

/// Blood as the recipe's "flow" describes it, in the body at rest; without streams where it says nothing.
[[nodiscard]] const FlowField& flowOf(const Patient& patient);
[[nodiscard]] const std::vector<TrueStenosis>& stenosesOf(const Patient& patient);

/// The same from the recipe alone. Where it says nothing of blood nothing is built, else all of the patient.
/// @error as readPatient
[[nodiscard]] Result<FlowField> readPatientFlow(const std::filesystem::path& file, const std::filesystem::path& mannequins = {},
                                                const ParameterValues& parameters = {}, Progress& progress = noProgress());

}  // namespace ew
