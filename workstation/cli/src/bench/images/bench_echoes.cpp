#include "bench/images/bench_echoes.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <memory>
#include <numbers>
#include <utility>

#include "bench/images/echo_measures.h"
#include "bench/images/echo_subject.h"
#include "bench/tools/bench_parts.h"
#include "ew/core/memory_watch.h"
#include "ew/core/numbers.h"
#include "ew/scanning/scanner.h"
#include "run/report.h"

namespace ew {
namespace {

using nlohmann::json;
using ProbeToWorld = Transform<frame::World, frame::Probe>;

constexpr std::array<std::pair<Quality, const char*>, 3> kQualities{
    {{Quality::weave, "fast"}, {Quality::linear, "default"}, {Quality::cubic, "fine"}}};
constexpr std::size_t kEveryView = 3;  // poses of which views are correlated, and the model is formed with other scatterers
constexpr int kEnoughPatches = 12;     // for a figure of a band
constexpr int kEnoughViews = 12;       // patches, for a correlation of views
constexpr double kPivotShare = 0.45;   // of the depth: rotations are about the middle of the image
constexpr int kWarmFrames = 10;
constexpr double kDarkest_db = -70.0;  // of a shadow: the image's black and 10 dB below it; how black it is beyond that is all the same

/// The bars of issue "Quality has settings with a price"; time on two threads.
constexpr double kLevelBar_db = 1.0, kSnrBar_percent = 3.0, kLengthBar_percent = 10.0, kViewBar = 0.05, kShadowBar_db = 2.0,
                 kFrameBar_ms = 12.0, kP99Bar_ms = 16.0;

json figureOr(const std::vector<double>& values, double figure) { return values.empty() ? json() : json(figure); }

/// A way to move the probe between two views.
struct ViewMotion {
  const char* kind;
  double amount;
  glm::dmat4 step;  ///< of the probe, in its own frame
};
std::vector<ViewMotion> motionsAt(double pivot_mm) {
  std::vector<ViewMotion> motions;
  for (const double angle_deg : {1.0, 3.0, 5.0, 8.0}) {
    glm::dmat4 step = glm::translate(glm::dmat4(1.0), {0.0, pivot_mm, 0.0});
    step = glm::rotate(step, angle_deg * std::numbers::pi / 180.0, glm::dvec3(0.0, 0.0, 1.0));
    motions.push_back({"rotation, degrees", angle_deg, glm::translate(step, {0.0, -pivot_mm, 0.0})});
  }
  for (const double shift_mm : {0.5, 1.0, 1.5})
    motions.push_back({"elevation, mm", shift_mm, glm::translate(glm::dmat4(1.0), {0.0, 0.0, shift_mm})});
  for (const double slide_mm : {0.5, 1.0, 2.0})
    motions.push_back({"slide, mm", slide_mm, glm::translate(glm::dmat4(1.0), {slide_mm, 0.0, 0.0})});
  return motions;
}

/// What one engine's frames gave.
struct Figures {
  SpeckleSums speckle;
  std::vector<ViewCorrelation> views;  ///< by motion
};
/// What live echoes of one quality gave, against the model.
struct Compared {  // NOLINT(bugprone-exception-escape): JSON is moved without an exception
  Figures own;
  std::vector<double> level_db, shadow_db;
  std::array<std::vector<double>, kEchoBands> band_db;
  std::array<std::vector<double>, 2> time_ms;  ///< of whole frames, on one thread and on two
  json held_mib;  ///< by the scanner on two threads after its frames: its tables, and what it keeps between frames
};

std::vector<double> absolute(std::vector<double> values) {
  for (double& value : values) value = std::abs(value);
  return values;
}

/// One case, pose after pose.
class CaseBench {
 public:
  CaseBench(const EchoSubject& subject, const EchoBenchOptions& options) : subject_(subject), options_(options) {}
  [[nodiscard]] Result<void> compare(Progress& progress);
  [[nodiscard]] Result<void> time(Progress& progress);
  [[nodiscard]] std::vector<json> rows() const;
  void addSteps(json& steps) const;

  json case_mib;  ///< what reading the case took and keeps

 private:
  [[nodiscard]] Result<void> prepare();
  void comparePose(const ProbeToWorld& pose, bool hasOther);
  void compareViews(const ProbeToWorld& pose);
  [[nodiscard]] json rowOf(std::size_t quality) const;
  [[nodiscard]] int bandOf(const EchoPatch& patch) const;

  const EchoSubject& subject_;
  const EchoBenchOptions& options_;
  std::unique_ptr<EchoTruth> truth_;
  std::unique_ptr<ForwardEngine> forward_, other_, still_;  ///< of the case; of other scatterers; without losses
  std::vector<std::unique_ptr<LiveEngine>> live_, liveStill_;
  std::vector<double> elevationalSigma_mm_, lateralWidth_mm_;
  double axialWidth_mm_ = 0.0, depth_mm_ = 0.0;
  std::vector<ViewMotion> motions_;
  Figures model_;
  std::array<Compared, kQualities.size()> compared_;
  std::vector<double> floor_db_, forward_ms_;
  json forward_mib_;
  int openPatches_ = 0, evenPatches_ = 0;
};

Result<void> CaseBench::prepare() {
  const auto engine = [&](bool loses, std::uint64_t seed) -> Result<std::unique_ptr<ForwardEngine>> {
    auto made = ForwardEngine::of(subject_, subject_.probe, loses, seed);
    if (!made) return passOn(made.error());
    return std::make_unique<ForwardEngine>(std::move(*made));
  };
  for (auto& [kept, loses, seed] : {std::tuple{&forward_, true, 1U}, std::tuple{&other_, true, 2U}, std::tuple{&still_, false, 1U}}) {
    const MemoryWatch memory;
    auto made = engine(loses, seed);
    if (!made) return passOn(made.error());
    *kept = std::move(*made);
    if (kept == &forward_) forward_mib_ = heldOf(memory);
  }
  truth_ = std::make_unique<EchoTruth>(subject_.truth());
  const VirtualScanner& scanner = forward_->scanner();
  depth_mm_ = scanner.options().depth_mm;
  axialWidth_mm_ = scanner.pointSpreadAt(depth_mm_).axial_mm;
  constexpr double kFwhmOfSigma = 2.3548;
  for (double depth = 0.5; depth < depth_mm_ + 2.0; depth += 1.0) {
    const PointSpread spread = scanner.pointSpreadAt(depth);
    elevationalSigma_mm_.push_back(spread.elevational_mm / kFwhmOfSigma);
    lateralWidth_mm_.push_back(spread.lateral_mm);
  }
  motions_ = motionsAt(kPivotShare * depth_mm_);
  model_.views.resize(motions_.size());
  for (std::size_t q = 0; q < kQualities.size(); ++q) {
    live_.push_back(std::make_unique<LiveEngine>(subject_, subject_.probe, kQualities[q].first, true));
    liveStill_.push_back(std::make_unique<LiveEngine>(subject_, subject_.probe, kQualities[q].first, false));
    compared_[q].own.views.resize(motions_.size());
  }
  return {};
}

Result<void> CaseBench::compare(Progress& progress) {
  if (auto ready = prepare(); !ready) return ready;
  const auto poses = echoPoses(subject_, options_.poses, options_.seed);
  for (std::size_t n = 0; n < poses.size(); ++n) {
    progress.report(say<"Comparing live echoes with the forward model">(), static_cast<double>(n) / static_cast<double>(poses.size()));
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
    comparePose(poses[n], n % kEveryView == 0);
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
    if (n % kEveryView == 0) compareViews(poses[n]);
  }
  return {};
}

int CaseBench::bandOf(const EchoPatch& patch) const {
  return std::clamp(static_cast<int>(kEchoBands * patch.middle_mm() / depth_mm_), 0, kEchoBands - 1);
}

void CaseBench::comparePose(const ProbeToWorld& pose, bool hasOther) {
  const auto patches = patchesOf(*truth_, forward_->scanner().grid(), elevationalSigma_mm_, pose);
  const EchoFrame model = forward_->frameAt(pose);
  forward_ms_.push_back(forward_->last_ms());
  const auto width = [&](const EchoPatch& patch) { return lateralWidth_mm_[static_cast<std::size_t>(patch.middle_mm())]; };
  for (const EchoPatch& patch : patches) {
    if (patch.isOpen) ++openPatches_;
    if (!patch.isEven) continue;
    ++evenPatches_;
    model_.speckle.add(model, patch, axialWidth_mm_, width(patch));
  }
  if (hasOther) {
    const EchoFrame other = other_->frameAt(pose);
    for (const EchoPatch& patch : patches)
      if (patch.isOpen) floor_db_.push_back(levelOf_db(other, patch) - levelOf_db(model, patch));
  }
  for (std::size_t q = 0; q < kQualities.size(); ++q) {
    const EchoFrame live = live_[q]->frameAt(pose);
    Compared& compared = compared_[q];
    for (const EchoPatch& patch : patches) {
      if (!patch.isOpen && !patch.isShaded) continue;
      const double live_db = levelOf_db(live, patch), model_db = levelOf_db(model, patch), off_db = live_db - model_db;
      if (patch.isShaded && std::max(live_db, model_db) > kDarkest_db)
        compared.shadow_db.push_back(std::max(live_db, kDarkest_db) - std::max(model_db, kDarkest_db));
      if (!patch.isOpen) continue;
      compared.level_db.push_back(off_db);
      compared.band_db[static_cast<std::size_t>(bandOf(patch))].push_back(off_db);
      if (patch.isEven) compared.own.speckle.add(live, patch, axialWidth_mm_, width(patch));
    }
  }
}

void CaseBench::compareViews(const ProbeToWorld& pose) {
  const BeamGrid& grid = still_->scanner().grid();
  auto patches = patchesOf(*truth_, grid, elevationalSigma_mm_, pose);
  // Around the pivot: the same place in every view, seen at nearly the same depth.
  const double pivot_mm = kPivotShare * depth_mm_;
  std::erase_if(patches, [&](const EchoPatch& patch) {
    const auto middle = static_cast<std::size_t>(patch.firstLine + patch.lines / 2);
    const glm::dvec2 p = grid.lines[middle].origin_mm + patch.middle_mm() * grid.lines[middle].direction;
    return !patch.isEven || std::abs(patch.middle_mm() - pivot_mm) > 0.22 * depth_mm_ || std::abs(p.x) > 0.35 * depth_mm_;
  });
  if (patches.empty()) return;
  const EchoFrame model = still_->frameAt(pose);
  std::vector<EchoFrame> live;
  for (const auto& engine : liveStill_) live.push_back(engine->frameAt(pose));
  for (std::size_t m = 0; m < motions_.size(); ++m) {
    ProbeToWorld moved;
    moved.matrix = pose.matrix * motions_[m].step;
    const Transform<frame::Probe, frame::Probe> stillToMoved{glm::inverse(motions_[m].step)};
    const EchoFrame movedModel = still_->frameAt(moved);
    for (const EchoPatch& patch : patches) model_.views[m].add(model, movedModel, patch, stillToMoved, subject_.probe);
    for (std::size_t q = 0; q < kQualities.size(); ++q) {
      const EchoFrame movedLive = liveStill_[q]->frameAt(moved);
      for (const EchoPatch& patch : patches) compared_[q].own.views[m].add(live[q], movedLive, patch, stillToMoved, subject_.probe);
    }
  }
}

/// Whole frames as the window makes them, the probe rocking and sliding about the case's start: a new pose for each.
Result<void> CaseBench::time(Progress& progress) {
  constexpr double kFramesPerSwing = 90.0;
  const auto poseOf = [&](int n) {
    const double phase = 2.0 * std::numbers::pi * n / kFramesPerSwing;
    Pose pose;
    pose.probeToWorld = subject_.anchors.front();
    glm::dmat4& matrix = pose.probeToWorld.matrix;
    matrix = glm::translate(matrix, {10.0 * std::sin(phase), 0.0, 15.0 * std::sin(0.7 * phase)});
    matrix = glm::rotate(matrix, 0.35 * std::sin(1.3 * phase), glm::dvec3(0.0, 1.0, 0.0));
    matrix = glm::rotate(matrix, 0.15 * std::sin(0.9 * phase), glm::dvec3(1.0, 0.0, 0.0));
    return pose;
  };
  int part = 0;
  for (std::size_t threads = 1; threads <= 2; ++threads)
    for (std::size_t q = 0; q < kQualities.size(); ++q, ++part) {
      progress.report(say<"Timing frames of live echoes">(), part / 6.0);
      const MemoryWatch memory;
      Scanner scanner(static_cast<int>(threads));
      scanner.show(subject_.subject);
      ScanState state;
      state.probe = subject_.probe;
      state.scene = subject_.subject.scene;
      state.knobs.quality = kQualities[q].first;
      for (int n = -kWarmFrames; n < options_.frames; ++n) {
        if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
        state.pose = poseOf(n);
        state.number = static_cast<std::uint64_t>(n + kWarmFrames);
        const auto start = std::chrono::steady_clock::now();
        [[maybe_unused]] const DisplayImage image = scanner.make(state, options_.width_px, options_.height_px);
        const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
        if (n >= 0) compared_[q].time_ms[threads - 1].push_back(took.count());
      }
      compared_[q].held_mib = heldOf(memory);
    }
  return {};
}

/// The worst of the bands whose lengths both engines could tell, in percent; NaN without one.
template <class Length>
double worstLength_percent(const SpeckleSums& live, const SpeckleSums& model, const Length& length) {
  double worst = std::nan("");
  for (int band = 0; band < kEchoBands; ++band) {
    const auto a = live.lengths(band), b = model.lengths(band);
    if (b.patches < kEnoughPatches || !(length(a) > 0.0 && length(b) > 0.0)) continue;
    const double off = 100.0 * (length(a) / length(b) - 1.0);
    if (std::isnan(worst) || std::abs(off) > std::abs(worst)) worst = off;
  }
  return worst;
}
json known(double value) { return std::isnan(value) ? json() : json(value); }

json CaseBench::rowOf(std::size_t quality) const {
  const Compared& compared = compared_[quality];
  const SpeckleSums &live = compared.own.speckle, &model = model_.speckle;
  json row = {{"name", subject_.id + "/" + kQualities[quality].second},
              {"case", subject_.id},
              {"quality", kQualities[quality].second},
              {"probe", subject_.probe.id},
              {"looks", subject_.scene.liveEchoes->looks},
              {"patches", openPatches_},
              {"even_patches", evenPatches_}};
  const double level_db = shareOf(compared.level_db, 0.5);
  row["level_db"] = figureOr(compared.level_db, level_db);
  row["level_p95_db"] = figureOr(compared.level_db, shareOf(absolute(compared.level_db), 0.95));
  row["level_floor_p95_db"] = figureOr(floor_db_, shareOf(absolute(floor_db_), 0.95));
  row["level_bands_db"] = json::array();
  for (const auto& band : compared.band_db)
    row["level_bands_db"].push_back(band.size() < kEnoughPatches ? json() : json(shareOf(band, 0.5)));
  const double snr = live.signalToNoise(), modelSnr = model.signalToNoise();
  row["snr_live"] = known(snr > 0.0 ? snr : std::nan(""));
  row["snr_forward"] = known(modelSnr > 0.0 ? modelSnr : std::nan(""));
  row["snr_off_percent"] = known(snr > 0.0 && modelSnr > 0.0 ? 100.0 * (snr / modelSnr - 1.0) : std::nan(""));
  row["axial_off_percent"] = known(worstLength_percent(live, model, [](const SpeckleSums::Lengths& l) { return l.axial_mm; }));
  row["lateral_off_percent"] = known(worstLength_percent(live, model, [](const SpeckleSums::Lengths& l) { return l.lateral_mm; }));
  row["lengths"] = json::array();
  for (int band = 0; band < kEchoBands; ++band) {
    const auto a = live.lengths(band), b = model.lengths(band);
    row["lengths"].push_back({{"patches", b.patches},
                              {"axial_live_mm", a.axial_mm},
                              {"axial_forward_mm", b.axial_mm},
                              {"lateral_live_mm", a.lateral_mm},
                              {"lateral_forward_mm", b.lateral_mm}});
  }
  double worst = std::nan("");
  row["decorrelation"] = json::array();
  for (std::size_t m = 0; m < motions_.size(); ++m) {
    if (model_.views[m].patches() < kEnoughViews) continue;
    const double a = compared.own.views[m].value(), b = model_.views[m].value();
    row["decorrelation"].push_back({{"motion", motions_[m].kind}, {"amount", motions_[m].amount}, {"live", a}, {"forward", b}});
    if (std::isnan(worst) || std::abs(a - b) > std::abs(worst)) worst = a - b;
  }
  row["decorrelation_off"] = known(worst);
  row["shadow_patches"] = compared.shadow_db.size();
  const std::vector<double>& shadow_db = compared.shadow_db;
  const bool hasShadow = shadow_db.size() >= kEnoughPatches;
  row["shadow_db"] = hasShadow ? json(shareOf(shadow_db, 0.5)) : json();
  row["shadow_p95_db"] = hasShadow ? json(shareOf(absolute(shadow_db), 0.95)) : json();
  const auto& one = compared.time_ms[0];
  const auto& two = compared.time_ms[1];
  for (const auto& [name, times] : {std::pair{"one", &one}, std::pair{"two", &two}}) {
    row[std::string(name) + (name == std::string("one") ? "_thread_ms" : "_threads_ms")] = shareOf(*times, 0.5);
    row[std::string(name) + "_p95_ms"] = shareOf(*times, 0.95);
    row[std::string(name) + "_p99_ms"] = shareOf(*times, 0.99);
  }
  row["forward_ms"] = shareOf(forward_ms_, 0.5);
  row["case_mib"] = case_mib;
  row["held_mib"] = compared.held_mib;
  row["forward_mib"] = forward_mib_;
  row["median_us"] = 1e3 * shareOf(two, 0.5);
  return row;
}

std::vector<json> CaseBench::rows() const {
  std::vector<json> rows;
  for (std::size_t q = 0; q < kQualities.size(); ++q) rows.push_back(rowOf(q));
  return rows;
}

void CaseBench::addSteps(json& steps) const {
  for (std::size_t q = 0; q < kQualities.size(); ++q) {
    std::vector<double> times_us;
    for (const double time_ms : compared_[q].time_ms[1]) times_us.push_back(1e3 * time_ms);
    steps.push_back(json(cli::stepRow(subject_.id + "/" + kQualities[q].second, std::move(times_us))));
  }
}

/// A line of totals for each quality: the worst case in every column.
json totalsOf(const json& results) {
  json totals = json::array();
  for (const auto& [quality, name] : kQualities) {
    json total = {{"quality", name}};
    for (const char* figure :
         {"level_db", "level_p95_db", "level_floor_p95_db", "snr_off_percent", "axial_off_percent", "lateral_off_percent",
          "decorrelation_off", "shadow_db", "one_thread_ms", "two_threads_ms", "two_p95_ms", "two_p99_ms", "forward_ms"}) {
      total[figure] = nullptr;
      for (const auto& row : results)
        if (row["quality"] == name && row[figure].is_number() &&
            (total[figure].is_null() || std::abs(row[figure].get<double>()) > std::abs(total[figure].get<double>())))
          total[figure] = row[figure];
    }
    totals.push_back(std::move(total));
  }
  return totals;
}

json mustShowOf(const json& totals) {
  json bars = json::array();
  const json& usual = totals[1];
  for (const auto& [figure, name, limit] :
       {std::tuple{"level_db", "level, dB off the forward model, worst case", kLevelBar_db},
        std::tuple{"snr_off_percent", "speckle SNR, percent off, worst case", kSnrBar_percent},
        std::tuple{"axial_off_percent", "axial correlation length, percent off, worst band", kLengthBar_percent},
        std::tuple{"lateral_off_percent", "lateral correlation length, percent off, worst band", kLengthBar_percent},
        std::tuple{"decorrelation_off", "decorrelation between views, off, worst motion", kViewBar},
        std::tuple{"shadow_db", "shadows, dB off, worst case", kShadowBar_db},
        std::tuple{"two_threads_ms", "whole frame on two threads, ms, worst case", kFrameBar_ms},
        std::tuple{"two_p99_ms", "99 of 100 frames from pose to image, ms, worst case", kP99Bar_ms}}) {
    if (!usual[figure].is_number()) continue;
    const double value = std::abs(usual[figure].get<double>());
    bars.push_back({{"name", name}, {"value", value}, {"limit", limit}, {"met", value <= limit}});
  }
  return bars;
}

}  // namespace

Result<json> benchEchoes(const EchoBenchOptions& options, Progress& progress) {
  if (options.poses < 1 || options.poses > 1000)
    return failure(ErrorCode::badUsage, say<"The number of poses must lie between 1 and 1000.">());
  if (options.frames < 5 || options.frames > 10000)
    return failure(ErrorCode::badUsage, say<"The number of timed frames must lie between 5 and 10000.">());
  if (options.width_px < 128 || options.width_px > 4096 || options.height_px < 128 || options.height_px > 4096)
    return failure(ErrorCode::badUsage, say<"A frame must be between 128 and 4096 pixels wide and high.">());
  json report = {{"machine", machineName()},    {"poses", options.poses}, {"frames", options.frames}, {"width", options.width_px},
                 {"height", options.height_px}, {"seed", options.seed},   {"results", json::array()}, {"steps", json::array()}};
  const auto share = 1.0 / static_cast<double>(std::max<std::size_t>(options.cases.size(), 1));
  for (std::size_t n = 0; n < options.cases.size(); ++n) {
    const double begin = share * static_cast<double>(n);
    PartOfProgress reading(progress, begin, begin + 0.3 * share), timing(progress, begin + 0.3 * share, begin + 0.5 * share),
        comparing(progress, begin + 0.5 * share, begin + share);
    const MemoryWatch memory;
    auto subject = readEchoSubject(options.cases[n], reading);
    if (!subject) return passOn(subject.error());
    CaseBench bench(*subject, options);
    bench.case_mib = heldOf(memory);
    if (auto done = bench.time(timing); !done) return passOn(done.error());
    if (auto done = bench.compare(comparing); !done) return passOn(done.error());
    for (json& row : bench.rows()) report["results"].push_back(std::move(row));
    bench.addSteps(report["steps"]);
  }
  report["totals"] = totalsOf(report["results"]);
  report["must_show"] = mustShowOf(report["totals"]);
  return report;
}

}  // namespace ew
