// Long runs of the camera tracker against rendered truth. truth_run static|moving|straight|flips|corners [FRAMES] [SEED] [FIRST PART]
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
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

/// A folder for `echoweave bench tracking`: half of the sequences still, half moving.
bool writeViews(const std::filesystem::path& folder, int frames, std::uint64_t seed) {
  using nlohmann::json;
  std::filesystem::create_directories(folder);
  const CameraModel model = webcam();
  const std::vector<MarkerBody> bodies{boxBody(), boardBody()};
  json document = {{"camera", json::parse(cameraModelText(model))}, {"bodies", json::array()}, {"frames", json::array()}};
  for (const MarkerBody& body : bodies) {
    json made = {{"id", body.id},
                 {"is_board", body.isBoard},
                 {"dictionary", body.dictionary},
                 {"face_mm", {body.probeToTool.matrix[3].x, body.probeToTool.matrix[3].y, body.probeToTool.matrix[3].z}},
                 {"markers", json::array()}};
    for (const Marker& marker : body.markers) {
      json corners = json::array();
      for (const auto& corner : marker.corners_mm)
        for (int n = 0; n < 3; ++n) corners.push_back(corner[n]);
      made["markers"].push_back({{"id", marker.id}, {"corners_mm", corners}});
    }
    document["bodies"].push_back(std::move(made));
  }
  PaperCameraOptions paper;
  paper.gamma = 2.2;
  paper.curl_mm = 0.2;
  paper.superSampling = 1;
  PaperCamera camera(model, bodies, paper);
  constexpr int kEach = 10;
  for (int n = 0; n < frames; ++n) {
    const int sequence = n / kEach;
    MotionOptions motion;
    const bool moves = sequence % 2 == 1;
    if (moves) {
      motion.moves_mm = 80.0;
      motion.turns_rad = 0.5;
    }
    const TruthMotion truth(model, bodies, motion, seed * 1000003u + static_cast<std::uint64_t>(sequence));
    const double time_s = (n % kEach) / 30.0;
    PaperShot shot;
    for (int part = 0; part < (moves ? 4 : 1); ++part)
      shot.poses.push_back(truth.at(time_s + (moves ? 0.012 * ((part + 0.5) / 4.0 - 0.5) : 0.0)));
    shot.unevenLight = 0.3;
    shot.lightAngle_rad = sequence;
    shot.seed = static_cast<std::uint64_t>(n);
    const GreyImage image = camera.image(shot);
    char name[32];
    std::snprintf(name, sizeof name, "%05d.pgm", n);
    std::ofstream out(folder / name, std::ios::binary);
    out << "P5\n" << image.width << " " << image.height << "\n255\n";
    out.write(reinterpret_cast<const char*>(image.pixels.data()), static_cast<std::streamsize>(image.pixels.size()));
    json rows = json::array();
    for (const glm::dmat4& pose : truth.at(time_s))
      for (const double each : rowsOf(pose)) rows.push_back(each);
    document["frames"].push_back({{"file", name}, {"time_s", time_s}, {"sequence", sequence}, {"poses", rows}});
    if (!out) return false;
  }
  std::ofstream out(folder / "views.json");
  out << document.dump(1) << "\n";
  return out.good();
}

}  // namespace

int main(int count, char** words) {
  cv::setNumThreads(1);
  const std::string what = count > 1 ? words[1] : "";
  const int frames = count > 2 ? std::atoi(words[2]) : 300;
  const auto seed = static_cast<std::uint64_t>(count > 3 ? std::atoll(words[3]) : 1);
  if (what == "views") {
    const int wanted = count > 3 ? std::atoi(words[3]) : 200;
    if (count < 3 || !writeViews(words[2], wanted, static_cast<std::uint64_t>(count > 4 ? std::atoll(words[4]) : 1))) return 1;
  } else if (what == "static") {
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
    std::fprintf(stderr,
                 "truth_run static|moving|straight|flips|corners [FRAMES] [SEED] [FIRST PART]\ntruth_run views FOLDER [FRAMES] [SEED]\n");
    return 2;
  }
  return 0;
}
