#pragma once

#include <glm/glm.hpp>
#include <string>

#include "ew/io/sequence.h"

namespace ew::test {

struct EvenSweep {
  int width = 20;
  int height = 16;
  int frames = 4;
  std::string from = "Probe";
  std::string to = "Reference";
};

/// A sweep whose frames lie a millimetre apart along z. @param grey what pixel p of frame n shows: grey(n, p)
template <class Grey>
Sequence evenSweep(const EvenSweep& asked, const Grey& grey) {
  Sequence sweep;
  sweep.width = asked.width;
  sweep.height = asked.height;
  sweep.orientation = "MF";
  sweep.imageType = "BRIGHTNESS";
  for (int n = 0; n < asked.frames; ++n) {
    SequenceFrame frame;
    frame.time_s = n * 0.1;
    glm::dmat4 pose(1.0);
    pose[3] = glm::dvec4(0.0, 0.0, n, 1.0);
    frame.transforms.push_back({asked.from, asked.to, pose, PoseStatus::ok});
    sweep.frames.push_back(frame);
    for (int p = 0; p < asked.width * asked.height; ++p) sweep.pixels.push_back(static_cast<std::uint8_t>(grey(n, p)));
  }
  return sweep;
}

}  // namespace ew::test
