#include "bench/images/bench_flow.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <numbers>
#include <utility>

#include "bench/images/echo_subject.h"
#include "bench/tools/bench_parts.h"
#include "ew/imaging/flow_trial.h"
#include "ew/scanning/scanner.h"
#include "run/report.h"

namespace ew {
namespace {

using nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr int kFirstFrames = 10;
constexpr double kFrame_s = 0.04;
constexpr double kFramesPerSwing = 90.0;
constexpr double kColourBar_ms = 5.0, kTriplexBar_ms = 50.0, kDeviationBar = 0.15;

/// A way to set the console.
struct FlowSetting {
  const char* name;
  std::function<void(Knobs&)> apply;
};

std::vector<FlowSetting> settings() {
  const auto box = [](Knobs& knobs) {
    // A quarter of the fan: half of its width, half of its depth.
    knobs.colour = ColourDoppler{};
    knobs.colour->boxWidth = 0.5;
    knobs.colour->boxHeight_mm = 0.5 * knobs.depth_mm;
    knobs.colour->boxMiddle_mm = 0.5 * knobs.depth_mm;
  };
  const auto boxWith = [box](auto change) {
    return [box, change](Knobs& knobs) {
      box(knobs);
      change(*knobs.colour);
    };
  };
  const auto spectrum = [](Knobs& knobs) {
    knobs.mode = DisplayMode::spectrum;
    knobs.spectral.emplace();
  };
  return {{"without Doppler", [](Knobs&) {}},
          {"colour, a quarter of the fan", box},
          {"colour, every line", boxWith([](ColourDoppler& colour) { colour.everyLine = 1; })},
          {"colour, packets of 16", boxWith([](ColourDoppler& colour) { colour.packet = 16; })},
          {"colour, gain of 10 dB", boxWith([](ColourDoppler& colour) { colour.gain_db = 10.0; })},
          {"colour, the whole fan", boxWith([](ColourDoppler& colour) {
             colour.boxWidth = 1.0;
             colour.boxHeight_mm = 1000.0;
           })},
          {"spectrum", spectrum},
          {"triplex", [box, spectrum](Knobs& knobs) {
             box(knobs);
             spectrum(knobs);
           }}};
}

/// Of the case's poses the one whose box is coloured most.
Transform<frame::World, frame::Probe> poseWithBlood(const EchoSubject& subject, const FlowBenchOptions& options) {
  Scanner scanner(0);
  scanner.show(subject.subject);
  ScanState state;
  state.probe = subject.probe;
  state.scene = subject.subject.scene;
  state.knobs.depth_mm = subject.probe.defaultDepth_mm;
  settings()[1].apply(state.knobs);
  state.time_s = 0.15;
  std::ptrdiff_t most = -1;
  auto best = subject.anchors.front();
  for (const auto& anchor : subject.anchors) {
    state.pose.probeToWorld = anchor;
    const Image<Rgba> colours = copyOf(scanner.make(state, options.width_px, options.height_px).colour);
    const auto count = std::count_if(colours.pixels.begin(), colours.pixels.end(), [](const Rgba& colour) { return colour.a > 0; });
    if (count > most) best = anchor;
    most = std::max<std::ptrdiff_t>(most, count);
  }
  return best;
}

Result<std::vector<json>> timesOf(const EchoSubject& subject, const FlowBenchOptions& options, int threads, Progress& progress) {
  const std::vector<FlowSetting> all = settings();
  const Transform<frame::World, frame::Probe> begin = poseWithBlood(subject, options);
  std::vector<std::unique_ptr<Scanner>> scanners;
  std::vector<ScanState> states;
  for (const FlowSetting& setting : all) {
    scanners.push_back(std::make_unique<Scanner>(threads));
    scanners.back()->show(subject.subject);
    ScanState& state = states.emplace_back();
    state.probe = subject.probe;
    state.scene = subject.subject.scene;
    state.knobs.depth_mm = subject.probe.defaultDepth_mm;
    setting.apply(state.knobs);
  }
  std::vector<std::vector<double>> took_ms(all.size()), added_ms(all.size());
  for (int n = -kFirstFrames; n < options.frames; ++n) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
    progress.report(say<"Timing frames of Doppler">(), static_cast<double>(n + kFirstFrames) / (options.frames + kFirstFrames));
    const double phase = 2.0 * std::numbers::pi * n / kFramesPerSwing;
    for (std::size_t s = 0; s < all.size(); ++s) {
      ScanState& state = states[s];
      state.pose.probeToWorld = begin;
      state.pose.probeToWorld.matrix =
          glm::translate(state.pose.probeToWorld.matrix, {2.0 * std::sin(phase), 0.0, 2.0 * std::sin(0.7 * phase)});
      state.number = static_cast<std::uint64_t>(n + kFirstFrames);
      state.time_s = (n + kFirstFrames) * kFrame_s;
      if (subject.subject.motion) state.body = bodyAt(subject.subject.motion->rhythms, state.time_s);
      const auto start = Clock::now();
      [[maybe_unused]] const DisplayImage image = scanners[s]->make(state, options.width_px, options.height_px);
      const std::chrono::duration<double, std::milli> once = Clock::now() - start;
      if (n < 0) continue;
      took_ms[s].push_back(once.count());
      added_ms[s].push_back(took_ms[s].back() - took_ms[0].back());
    }
  }
  std::vector<json> rows;
  for (std::size_t s = 0; s < all.size(); ++s) {
    const std::string name = subject.id + "/" + all[s].name + "/" + std::to_string(threads);
    rows.push_back({{"name", name},
                    {"case", subject.id},
                    {"setting", all[s].name},
                    {"threads", threads},
                    {"median_ms", shareOf(took_ms[s], 0.5)},
                    {"p99_ms", shareOf(took_ms[s], 0.99)},
                    {"added_ms", shareOf(added_ms[s], 0.5)},
                    {"added_p99_ms", shareOf(added_ms[s], 0.99)},
                    {"median_us", 1e3 * shareOf(took_ms[s], 0.5)}});
  }
  return rows;
}

Result<json> accuracyOf(int packets, Progress& progress) {
  json rows = json::array();
  constexpr double kAngles_deg[] = {0.0, 45.0, 60.0}, kRatios_db[] = {10.0, 20.0};
  int done = 0;
  for (const double angle_deg : kAngles_deg)
    for (const double ratio_db : kRatios_db) {
      progress.report(say<"Comparing colour with moving scatterers">(), done++ / 6.0);
      if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
      const TrialVessel vessel{.angle_rad = angle_deg * std::numbers::pi / 180.0};
      const Knobs knobs = trialKnobs(vessel);
      const Scene scene = trialScene(ratio_db);
      const double nyquist_mmPerS = colourBoxOf(trialProbe(), knobs).nyquist_mmPerS;
      const TrialEstimates colour = estimatesOfColour(vessel, knobs, scene, 2 * packets);
      const TrialEstimates moved = estimatesOfScatterers(vessel, knobs, scene, {.signalToNoise = std::pow(10.0, 0.1 * ratio_db)}, packets);
      rows.push_back({{"angle_deg", angle_deg},
                      {"signal_to_noise_db", ratio_db},
                      {"truth", vessel.towards_mmPerS() / nyquist_mmPerS},
                      {"colour", colour.mean},
                      {"colour_deviation", colour.deviation},
                      {"scatterers", moved.mean},
                      {"scatterers_deviation", moved.deviation},
                      {"colour_us", colour.packet_us},
                      {"scatterers_us", moved.packet_us}});
    }
  return rows;
}

json flowBarsOf(const json& report) {
  json bars = json::array();
  const auto add = [&](const char* name, double value, double limit) {
    bars.push_back({{"name", name}, {"value", value}, {"limit", limit}, {"met", value <= limit}});
  };
  double colour_ms = 0.0, triplex_ms = 0.0, deviation = 0.0;
  for (const json& row : report["results"]) {
    if (row["threads"] != 2) continue;
    if (row["setting"] == "colour, a quarter of the fan") colour_ms = std::max(colour_ms, row["added_ms"].get<double>());
    if (row["setting"] == "triplex") triplex_ms = std::max(triplex_ms, row["p99_ms"].get<double>());
  }
  for (const json& row : report["accuracy"])
    deviation = std::max(deviation, std::abs(row["colour_deviation"].get<double>() / row["scatterers_deviation"].get<double>() - 1.0));
  add("a colour box over a quarter of the fan adds, ms", colour_ms, kColourBar_ms);
  add("99 in 100 frames of triplex take at most, ms", triplex_ms, kTriplexBar_ms);
  add("standard deviation against moving scatterers, share off", deviation, kDeviationBar);
  return bars;
}

}  // namespace

Result<json> benchFlow(const FlowBenchOptions& options, Progress& progress) {
  if (options.frames < 5 || options.frames > 10000)
    return failure(ErrorCode::badUsage, say<"The number of timed frames must lie between 5 and 10000.">());
  if (options.packets < 100 || options.packets > 100000)
    return failure(ErrorCode::badUsage, say<"The number of packets must lie between 100 and 100000.">());
  json report = {{"machine", machineName()},  {"frames", options.frames},    {"packets", options.packets},
                 {"width", options.width_px}, {"height", options.height_px}, {"results", json::array()}};
  const double share = 0.7 / static_cast<double>(std::max<std::size_t>(options.cases.size(), 1));
  for (std::size_t n = 0; n < options.cases.size(); ++n) {
    const double begin = share * static_cast<double>(n);
    PartOfProgress reading(progress, begin, begin + 0.3 * share), alone(progress, begin + 0.3 * share, begin + 0.7 * share),
        both(progress, begin + 0.7 * share, begin + share);
    auto subject = readEchoSubject(options.cases[n], reading);
    if (!subject) return passOn(subject.error());
    if (!subject->subject.showsColour())
      return failure(ErrorCode::badUsage,
                     say<"%1 does not say how blood flows; name a case whose recipe has a section \"flow\".">(options.cases[n].id));
    for (const auto& [threads, part] : {std::pair<int, Progress*>{1, &alone}, {2, &both}}) {
      auto rows = timesOf(*subject, options, threads, *part);
      if (!rows) return passOn(rows.error());
      for (json& row : *rows) report["results"].push_back(std::move(row));
    }
  }
  PartOfProgress comparing(progress, 0.7, 1.0);
  auto accuracy = accuracyOf(options.packets, comparing);
  if (!accuracy) return passOn(accuracy.error());
  report["accuracy"] = std::move(*accuracy);
  report["must_show"] = flowBarsOf(report);
  return report;
}

}  // namespace ew
