// Long runs of the camera tracker against rendered truth. truth_run static|moving|straight|flips|corners [FRAMES] [SEED] [FIRST PART]
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <opencv2/core.hpp>
#include <string>

#include "camera_truth/truth_trial.h"

using namespace ew;
using namespace ew::camera_truth;

namespace {

void report(const char* name, const TrialOptions& options) {
  std::printf("== %s\n%s", name, textOf(runTrial(options)).c_str());
  std::fflush(stdout);
}

TrialOptions usual(int frames, std::uint64_t seed) {
  TrialOptions options;
  options.paper.gamma = 2.2;
  options.paper.curl_mm = 0.2;
  options.seed = seed;
  options.sequences = std::max(1, frames / 10);
  options.framesEach = 10;
  return options;
}

TrialOptions moving(int frames, std::uint64_t seed) {
  TrialOptions options = usual(frames, seed);
  options.motion.moves_mm = 80.0;
  options.motion.turns_rad = 0.5;
  options.exposure_s = 0.012;
  options.subFrames = 5;
  options.paper.superSampling = 1;
  options.sequences = std::max(1, frames / 30);
  options.framesEach = 30;
  return options;
}

/// Every attitude, one face straight on, a thumb, dim light, one and two bodies; no room behind, so that there are many.
void flips(int frames, std::uint64_t seed, int firstPart) {
  for (int done = 0, part = firstPart; done < frames; ++part) {
    TrialOptions options = usual(2000, seed + 1000u * static_cast<std::uint64_t>(part));
    options.paper.room = false;
    options.paper.superSampling = 1;
    options.paper.noise_grey = part % 3 == 2 ? 5.0 : 2.0;
    options.paper.curl_mm = part % 4 == 3 ? 0.6 : 0.2;
    options.paper.gamma = part % 5 == 4 ? 1.6 : 2.2;
    options.paper.seed = seed + static_cast<std::uint64_t>(part);
    options.board = part % 4 == 1;
    options.motion.straightOn = part % 2 == 0;
    options.motion.tipped_rad = std::numbers::pi;
    options.motion.far_mm = part % 3 == 1 ? 1000.0 : 700.0;
    options.motion.moves_mm = 60.0;
    options.motion.turns_rad = 0.6;
    options.motion.rate_hz = 0.7;
    options.covered = 0.25;
    options.unevenLight = part % 3 == 0 ? 0.6 : 0.3;
    options.sequences = 100;
    options.framesEach = 20;
    options.plainEvery = 10;
    const TrialResult result = runTrial(options);
    done += result.frames;
    std::printf("== part %d, %d frames in all\n%s", part, done, textOf(result).c_str());
    std::fflush(stdout);
  }
}

void corners(int frames, std::uint64_t seed) {
  for (const auto& [method, name] :
       {std::pair{CornerMethod::contour, "contour"}, {CornerMethod::subPix, "cornerSubPix"}, {CornerMethod::edges, "edges"}})
    for (const double gamma : {1.0, 2.2}) {
      TrialOptions options = usual(frames, seed);
      options.sequences = frames;
      options.framesEach = 1;
      options.paper.curl_mm = 0.0;
      options.paper.gamma = gamma;
      options.tracking.gamma = gamma;
      options.tracking.corners = method;
      options.tracking.largestRms_px = 5.0;
      report((std::string(name) + ", gamma " + std::to_string(gamma)).c_str(), options);
    }
}

}  // namespace

int main(int count, char** words) {
  cv::setNumThreads(1);
  const std::string what = count > 1 ? words[1] : "";
  const int frames = count > 2 ? std::atoi(words[2]) : 300;
  const auto seed = static_cast<std::uint64_t>(count > 3 ? std::atoll(words[3]) : 1);
  if (what == "static") {
    TrialOptions options = usual(frames, seed);
    options.plainEvery = 1;
    options.sequences = frames / 4;
    options.framesEach = 4;
    report("still, paper curled by 0.2 mm, gamma 2.2", options);
  } else if (what == "moving") {
    TrialOptions options = moving(frames, seed);
    options.plainEvery = 1;
    report("moving, 12 ms exposure", options);
  } else if (what == "straight") {
    TrialOptions options = usual(frames, seed);
    options.motion.straightOn = true;
    options.plainEvery = 1;
    report("one face straight on", options);
  } else if (what == "flips") {
    flips(frames, seed, count > 4 ? std::atoi(words[4]) : 0);
  } else if (what == "corners") {
    corners(frames, seed);
  } else {
    std::fprintf(stderr, "truth_run static|moving|straight|flips|corners [FRAMES] [SEED] [FIRST PART]\n");
    return 2;
  }
  return 0;
}
