#pragma once

#include <cmath>
#include <memory>
#include <numbers>

#include "ew/scanning/replay.h"

namespace ew::test {

/// 60 mm of waves around the world's origin without any symmetry.
inline std::shared_ptr<const Volume> waves(int side = 40) {
  auto volume = std::make_shared<Volume>();
  volume->grid.dims = glm::ivec3(side);
  volume->grid.spacing_mm = glm::dvec3(60.0 / side);
  volume->grid.origin_mm = glm::dvec3(-30.0);
  volume->echo.resize(volume->grid.voxelCount());
  std::size_t n = 0;
  for (int k = 0; k < side; ++k)
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i)
        volume->echo[n++] = static_cast<std::uint8_t>(110.0 + 60.0 * std::sin(0.4 * i + 0.1 * k) + 40.0 * std::cos(0.3 * j - 0.2 * k));
  return volume;
}

/// The waves as tissue, which breathes and pulses.
inline ScanSubject livingSubject() {
  ScanSubject subject = subjectOf(ScanVoxels::asStored(waves()), "living waves");
  auto tissue = std::make_shared<TissueMaps>();
  tissue->grid = subject.voxels.grid();
  tissue->level = subject.voxels.volume()->echo;
  auto motion = std::make_shared<TissueMotion>();
  motion->rhythms.breathing = BodyRhythms::Breathing{};
  motion->rhythms.pulse = Rhythm{0.9, 0.1};
  for (const auto kind : {TissueMotion::Kind::breath, TissueMotion::Kind::pulse}) {
    TissueMotion::Mode& mode = motion->modes.emplace_back();
    mode.kind = kind;
    mode.grid.dims = glm::ivec3(13);
    mode.grid.spacing_mm = glm::dvec3(5.0);
    mode.grid.origin_mm = glm::dvec3(-30.0);
    for (int k = 0; k < 13; ++k)
      for (int j = 0; j < 13; ++j)
        for (int i = 0; i < 13; ++i)
          mode.shift_mm.push_back(kind == TissueMotion::Kind::breath ? glm::vec3(0.2F * i, 2.0F, -0.3F * k)
                                                                     : glm::vec3(0.0F, 0.05F * j, 0.0F));
  }
  subject.tissue = std::move(tissue);
  subject.motion = std::move(motion);
  subject.place({});
  return subject;
}

inline Probe smallProbe() {
  Probe probe;
  probe.id = "small";
  probe.name = "Small test probe";
  probe.width_mm = 40.0;
  probe.lines = 64;
  probe.aperture_mm = 16.0;
  probe.elevationalFocus_mm = 30.0;
  probe.elevationalAperture_mm = 6.0;
  probe.minDepth_mm = 20.0;
  probe.maxDepth_mm = 60.0;
  probe.defaultDepth_mm = 50.0;
  return probe;
}

inline ScanSubject waveSubject() { return subjectOf(ScanVoxels::asStored(waves()), "waves"); }

/// The n-th state of a scan that slides, rocks and changes its settings as it goes.
inline ScanState movingState(int n) {
  ScanState state;
  state.probe = smallProbe();
  state.knobs.gain = 0.8 + 0.05 * (n / 4 % 9);
  state.knobs.persistence = n / 50 % 2 == 0 ? 0.4 : 0.0;
  state.knobs.mode = n / 200 % 3 == 1 ? DisplayMode::both : DisplayMode::bMode;
  state.scene.gainAndDgc = true;
  state.scene.noise.emplace();
  if (n / 300 % 2 == 1) state.scene.contact.emplace();
  const double t = n / 30.0;
  glm::dmat4& matrix = state.pose.probeToWorld.matrix;
  const double rock = 0.3 * std::sin(0.7 * t);
  matrix[0] = {std::cos(rock), std::sin(rock), 0.0, 0.0};
  matrix[1] = {-std::sin(rock), std::cos(rock), 0.0, 0.0};
  matrix[3] = {4.0 * std::sin(0.9 * t), -28.0, 6.0 * std::sin(0.31 * t), 1.0};
  if (state.scene.contact) {
    state.gaps_mm.assign(17, -1.0F);
    for (std::size_t i = 12; i < 17; ++i) state.gaps_mm[i] = 1.1F * static_cast<float>(i - 10);
  }
  if (n % 7 != 0) state.body = {0.5 + 0.5 * std::sin(0.6 * t), 0.5 - 0.5 * std::cos(6.1 * t), 0.01 * (n % 100)};
  state.time_s = 100.0 + t;
  state.number = static_cast<std::uint64_t>(n) + 7;
  return state;
}

}  // namespace ew::test
