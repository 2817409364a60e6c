#pragma once

#include <complex>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace ew::detail {

/// What moves at a place of a sample volume, seen from the probe.
struct MovingBlood {
  bool isThere = false;
  glm::dvec3 velocity_mmPerS{0.0};  ///< in the volume's axes: across the beam, along it away from the probe, and through the slice
  double turbulence_mmPerS = 0.0;   ///< standard deviation along each axis
};

/// Size of a sample volume. Standard deviations are those of the two-way amplitude.
struct VolumeSize {
  double lateralSigma_mm = 0.5, elevationalSigma_mm = 0.8, pulseSigma_mm = 0.3;
  double length_mm = 2.0;  ///< of the gate; its ends fall off as the pulse does
  double wavelength_mm = 0.3;
  double prf_hz = 4000.0;
  bool broadens = true;  ///< else scatterers keep their strength, and a line has no width of its own
  bool operator==(const VolumeSize&) const = default;
};

/// Scatterers that go where blood goes, through one sample volume: each sends exp(4 pi i r / L) back, r the way it has gone towards the
/// probe, as strong as beam and gate are where it is. What leaves comes back as another one where blood flows in, as often as it does, so
/// that they stay evenly spread. So the spectrum has the velocities of the profile, each for as long as it stays, and fades as speckle
/// does, also while all of it accelerates; nothing of that is put in. Source: scatterers that leave must come back uncorrelated (Jensen,
/// Field II flow examples); 1000 points a volume were found enough by Khoshniat et al., Ultrasound Med. Biol. 31, 2005. Ours moves 600, of
/// which those in the vessel count, and needs no broadening function.
class SampleVolume {
 public:
  static constexpr int kScatterers = 600;
  using Flow = std::function<MovingBlood(std::size_t sample, const glm::dvec3& at_mm)>;

  /// A change of size keeps where scatterers are, as shares of it. @param seed of all that is random
  void configure(const VolumeSize& size, std::uint64_t seed);
  /// Adds the next samples, one a pulse. A volume full of blood has power 1.
  /// @param flow asked every millisecond or more often, at places in the volume's axes, mm from its middle; `sample` is the first that its
  /// answer is for
  void add(const Flow& flow, std::span<std::complex<float>> samples);
  bool operator==(const SampleVolume&) const = default;
  [[nodiscard]] static std::size_t bytes();

 private:
  struct Scatterer {
    glm::vec3 at{0.0F};  ///< -1..1 of the region
    std::complex<float> phase{1.0F, 0.0F};
    glm::vec3 stirred{0.0F};  ///< by turbulence, in its standard deviations
    std::uint32_t born = 0;   ///< how often it came in anew
    bool isFresh = false;     ///< it begins without strength
    bool operator==(const Scatterer&) const = default;
  };
  [[nodiscard]] float strengthAt(const glm::vec3& at_mm) const;
  void renew(std::size_t n);
  void renewAnywhere(std::size_t n);
  /// Where blood comes into the region, as often as it does.
  void renewWhereItComesIn(std::size_t n, const Flow& flow, std::size_t sample);
  [[nodiscard]] std::uint64_t keyOf(std::size_t n) const;

  VolumeSize size_;
  std::uint64_t seed_ = 0;
  std::uint64_t steps_ = 0;
  double fastest_mmPerS_ = 0.0;  ///< of the step before
  glm::vec3 half_mm_{1.0F};
  float unit_ = 1.0F;  ///< so that a full volume has power 1
  std::vector<Scatterer> scatterers_;
};

}  // namespace ew::detail
