#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "files.h"

namespace ew::test {

/// A Kretz volume as its layout is known, for tests.
struct KretzOf {
  int samples = 40, beams = 30, planes = 20;
  double step_mm = 0.5, start_mm = 30.0, axisDepth_mm = 10.0;
  double beamsHalf_rad = 0.5, planesHalf_rad = 0.4;
  std::string data;
  std::string several;  ///< D600/0001
  std::string extra;    ///< items after the others
  int angles = -1;      ///< written for the beams when not -1
  bool cartesian = false;
  double aside_rad = 0.0;  ///< of a single beam or plane

  [[nodiscard]] double theta(int j) const { return beams < 2 ? aside_rad : beamsHalf_rad * (2.0 * j / (beams - 1) - 1.0); }
  [[nodiscard]] double phi(int k) const { return planes < 2 ? aside_rad : planesHalf_rad * (2.0 * k / (planes - 1) - 1.0); }
  [[nodiscard]] std::array<double, 3> place(int i, int j, int k) const {
    const double r = start_mm + step_mm * i, d = r * std::cos(theta(j)), R = axisDepth_mm;
    return {r * std::sin(theta(j)), R * (1 - std::cos(phi(k))) + d * std::cos(phi(k)), (d - R) * std::sin(phi(k))};
  }
  [[nodiscard]] std::size_t index(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(beams) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(samples) +
           static_cast<std::size_t>(i);
  }
  void fill(const std::function<double(double, double, double)>& level) {
    data.assign(static_cast<std::size_t>(samples) * static_cast<std::size_t>(beams) * static_cast<std::size_t>(planes), '\0');
    for (int k = 0; k < planes; ++k)
      for (int j = 0; j < beams; ++j)
        for (int i = 0; i < samples; ++i) {
          const auto [x, y, z] = place(i, j, k);
          data[index(i, j, k)] = static_cast<char>(std::lround(level(x, y, z)));
        }
  }
};

inline std::string kretzItem(std::uint16_t group, std::uint16_t element, const std::string& value) {
  return bytesOf(std::vector<std::uint16_t>{group, element}) +
         bytesOf(std::vector<std::uint32_t>{static_cast<std::uint32_t>(value.size())}) + value;
}

inline std::string kretzFile(const KretzOf& of) {
  const auto word = [](int value) { return bytesOf(std::vector<std::uint16_t>{static_cast<std::uint16_t>(value)}); };
  const auto real = [](double value) { return bytesOf(std::vector<double>{value}); };
  std::string bytes = "KRETZFILE 1.0   ";
  bytes += kretzItem(0x0110, 0x0002, "DOE^JANE 4711");
  bytes += kretzItem(0xC000, 1, word(of.samples)) + kretzItem(0xC000, 2, word(of.beams)) + kretzItem(0xC000, 3, word(of.planes));
  bytes += kretzItem(0xC100, 1, real(of.step_mm / 1000.0));
  if (!of.cartesian) {
    bytes += kretzItem(0xC200, 1, real(of.start_mm / of.step_mm)) + kretzItem(0xC200, 2, real(-of.axisDepth_mm / of.step_mm));
    std::vector<double> theta, phi;
    for (int j = 0; j < (of.angles < 0 ? of.beams : of.angles); ++j) theta.push_back(std::numbers::pi / 2 + of.theta(j));
    for (int k = 0; k < of.planes; ++k) phi.push_back(std::numbers::pi / 2 + of.phi(k));
    bytes += kretzItem(0xC300, 1, bytesOf(phi)) + kretzItem(0xC300, 2, bytesOf(theta));
  }
  if (!of.data.empty()) bytes += kretzItem(0xD000, 1, of.data);
  if (!of.several.empty()) bytes += kretzItem(0xD600, 1, of.several);
  return bytes + of.extra + kretzItem(0xFFFF, 0xFFFF, "");
}

}  // namespace ew::test
