#pragma once

#include "ew/imaging/colour_doppler.h"
#include "ew/imaging/flow_sampler.h"
#include "ew/imaging/flow_trial.h"
#include "ew/imaging/frame.h"

/// Frames of a trial's vessel, one after another.
namespace ew::testing::colour {

struct Shot {
  TrialVessel vessel = {.angle_rad = 0.25 * 3.141592653589793};
  Knobs knobs = trialKnobs({});
  Scene scene = trialScene(60.0);
  Probe probe = trialProbe();
};

/// Makes frames of a shot and tells what was measured at a gate.
class ColourScan {
 public:
  explicit ColourScan(const Shot& shot, int threads = 1)
      : shot_(shot), maps_(mapsOf(shot.vessel)), sampler_(fieldOf(shot.vessel)), maker_(threads) {
    maker_.configure(shot.probe, shot.knobs, shot.scene, maps_.grid, 320, 320, {.tissue = true, .flow = true});
    input_.echo = VolumeView<const std::uint8_t>{maps_.level.data(), maps_.grid};
    input_.tissue = &maps_;
    input_.tissueGrid = maps_.grid;
    input_.flow = &sampler_;
  }
  DisplayImage next() {
    ++input_.number;
    input_.time_s += 0.05;
    return maker_.make(input_);
  }
  [[nodiscard]] FrameInput& input() { return input_; }
  [[nodiscard]] FrameMaker& maker() { return maker_; }
  [[nodiscard]] const FrameMaker& maker() const { return maker_; }
  [[nodiscard]] const TissueMaps& maps() const { return maps_; }
  /// Of the gate nearest to a place in the image plane.
  [[nodiscard]] PacketSums sumsAt(const glm::dvec2& p_mm) const {
    const BeamGrid& grid = maker_.colourGrid();
    const ColourMemory memory = maker_.memory().colour;
    PacketSums nearest;
    double best = 1e300;
    for (std::size_t line = 0; line < grid.lines.size(); ++line)
      for (int gate = 0; gate < grid.samples; ++gate) {
        const double away = glm::distance(grid.lines[line].origin_mm + grid.depth_mm(gate) * grid.lines[line].direction, p_mm);
        if (away >= best) continue;
        best = away;
        const float* at = memory.sums.data() + 3 * (static_cast<std::size_t>(gate) * grid.lines.size() + line);
        nearest = {static_cast<double>(at[0]), {static_cast<double>(at[1]), static_cast<double>(at[2])}};
      }
    return nearest;
  }

 private:
  Shot shot_;
  TissueMaps maps_;
  FlowSampler sampler_;
  FrameMaker maker_;
  FrameInput input_;
};

}  // namespace ew::testing::colour
