#include "bench/images/bench_frame.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <sstream>

#include "bench/tools/bench_parts.h"
#include "ew/core/memory_watch.h"
#include "ew/imaging/beam_grid.h"
#include "ew/imaging/effect_info.h"
#include "ew/imaging/effects/focus.h"
#include "ew/imaging/effects/slice_thickness.h"
#include "ew/imaging/frame.h"
#include "ew/imaging/scan_conversion.h"
#include "ew/library/case.h"
#include "ew/scanning/scanner.h"
#include "run/report.h"

namespace ew {
namespace {

using nlohmann::json;

constexpr double kSpan_mm = 300.0;               // of the cube: the fan of the probe lies inside it in every pose
constexpr double kPerSigma = 2.354820045030949;  // full width at half maximum of a normal distribution

/// What a setting's image can be compared with.
enum class Exact { none, field, elevationalMean, lateralMean };

/// One thing to time. `frame` makes the image of a pose; it stays valid until the next call.
struct FrameSetting {  // NOLINT(bugprone-exception-escape): JSON is moved without an exception
  std::string name;    ///< "frame_1024x768_of_256cubed/focus_kernel/1"
  std::string group;
  std::string method;
  bool peer = false;
  int threads = 1;
  Exact exact = Exact::none;
  Knobs knobs;
  Scene scene;
  std::function<const std::uint8_t*(const Pose&)> frame;
  std::shared_ptr<Scanner> scanner;  ///< null: a peer, or bare beams
  json held_mib;                     ///< by the scanner after its first frame

  std::vector<double> cpu_us;  ///< mean of each repetition
  std::vector<double> wall_us;
  double psnr_db = 0.0;
  double worst_grey = 0.0;
  std::map<std::string, std::vector<double>> steps_us;
};

/// What is scanned, and from where.
struct World {
  FrameBenchOptions options;
  int side = 0;
  Probe probe;
  BenchField field;
  Volume volume;      ///< the field; later with a bright ball in it
  ScanVoxels voxels;  ///< of the volume as it is, in both layouts, as the program chooses
  Volume labels;      ///< 1 in the ball, 2 in a ball of fluid beside it
  std::vector<Pose> poses;
  std::vector<float> gaps_mm;  ///< of a face of which a sixth lies in air

  World(const FrameBenchOptions& wanted, int volumeSide, Probe scanned)
      : options(wanted), side(volumeSide), probe(std::move(scanned)), field(volumeSide) {}
};

constexpr double kBall_mm = 14.0;
constexpr glm::dvec3 kFluid_mm{25.0, 10.0, 8.0};

/// As ScanVoxels::of lays them out, timed here and now instead of remembered.
Result<void> layOut(World& world, Progress& progress) {
  const auto shared = std::shared_ptr<const Volume>(std::shared_ptr<const Volume>(), &world.volume);
  auto both = ScanVoxels::inBothLayouts(shared, 1, std::nullopt, progress);
  if (!both) return passOn(both.error());
  world.voxels = std::move(*both);
  return {};
}

void paintBalls(World& world) {
  const Grid& grid = world.volume.grid;
  world.labels = {grid, std::vector<std::uint8_t>(grid.voxelCount(), 0), {}};
  for (int k = 0; k < grid.dims.z; ++k)
    for (int j = 0; j < grid.dims.y; ++j)
      for (int i = 0; i < grid.dims.x; ++i) {
        const glm::dvec3 p = grid.origin_mm + grid.spacing_mm * glm::dvec3(i, j, k);
        const double stone_mm = glm::length(p);
        if (stone_mm < kBall_mm) world.labels.echo[grid.indexOf(i, j, k)] = 1;
        if (stone_mm > kBall_mm - 3.0 && stone_mm < kBall_mm) world.volume.echo[grid.indexOf(i, j, k)] = 255;
        if (glm::distance(p, kFluid_mm) < 10.0) world.labels.echo[grid.indexOf(i, j, k)] = 2;
      }
}

Result<std::unique_ptr<World>> makeWorld(const FrameBenchOptions& options, int side, const Probe& probe, Progress& progress) {
  auto world = std::make_unique<World>(options, side, probe);
  auto volume = world->field.volume(progress);
  if (!volume) return passOn(volume.error());
  world->volume = std::move(*volume);
  Grid& grid = world->volume.grid;
  grid.spacing_mm = glm::dvec3(kSpan_mm / side);
  grid.origin_mm = glm::dvec3(-0.5 * kSpan_mm + 0.5 * kSpan_mm / side);
  for (int n = 0; n < options.poses; ++n) {
    const double t = n / 3.0;
    Pose pose;
    glm::dmat4& matrix = pose.probeToWorld.matrix;
    matrix = glm::mat4_cast(rockingTurn(t));
    const glm::dvec3 slide_mm = 6.0 * glm::dvec3(std::sin(1.3 * t), std::sin(0.7 * t), 0.5 * std::cos(1.1 * t));
    matrix[3] = glm::dvec4(slide_mm - 0.5 * probe.defaultDepth_mm * glm::dvec3(matrix[1]), 1.0);
    world->poses.push_back(pose);
  }
  world->gaps_mm.assign(static_cast<std::size_t>(probe.lines), 0.0F);
  std::fill_n(world->gaps_mm.begin(), world->gaps_mm.size() / 6, 12.0F);
  return world;
}

/// Everything a console and a scene can ask for at once.
Knobs everyKnob() {
  Knobs knobs;
  knobs.gain = 1.2;
  knobs.dgc = {0.9, 1.0, 1.0, 1.1, 1.1, 1.2, 1.3, 1.4};
  knobs.focus_mm = 60.0;
  knobs.moreFoci_mm[0] = 110.0;
  knobs.dynamicRange_db = 50.0;
  knobs.greyMap = GreyMap::soft;
  knobs.edgeEnhancement = 0.4;
  knobs.persistence = 0.3;
  knobs.mode = DisplayMode::both;
  return knobs;
}

std::vector<TissueAcoustics> benchTissues() {
  return {{.label = 0, .name = "liver", .attenuation_dbPerCmMhz = 0.5},
          {.label = 1, .name = "stone", .attenuation_dbPerCmMhz = 10.0, .reflection_db = 24.0},
          {.label = 2, .name = "fluid", .attenuation_dbPerCmMhz = 0.0}};
}

/// Frames of a Scanner of its own, so that settings can take turns without making tables anew.
void addFrames(std::vector<FrameSetting>& settings, const World& world, FrameSetting setting, bool withLabels = false,
               bool withGaps = false) {
  const auto shared = [](const Volume& volume) { return std::shared_ptr<const Volume>(std::shared_ptr<const Volume>(), &volume); };
  if (withLabels) setting.scene.tissues = benchTissues();
  ScanSubject subject = subjectOf(world.voxels, setting.method);
  if (withLabels) {
    subject.labels = shared(world.labels);
    subject.placedLabels = world.volume.grid;
  }
  ScanState state{.probe = world.probe, .knobs = setting.knobs, .pan = {}, .scene = setting.scene, .pose = {}};
  if (withGaps) state.gaps_mm = world.gaps_mm;
  const MemoryWatch memory;
  setting.scanner = std::make_shared<Scanner>(setting.threads);
  setting.scanner->show(std::move(subject));
  const glm::ivec2 size_px(world.options.width_px, world.options.height_px);
  setting.scanner->prepare(state, size_px.x, size_px.y);
  setting.frame = [scanner = setting.scanner, state, size_px](const Pose& pose) mutable {
    state.pose = pose;
    state.time_s = static_cast<double>(++state.number) / 30.0;
    return static_cast<const std::uint8_t*>(scanner->make(state, size_px.x, size_px.y).grey.row(0));
  };
  setting.frame(world.poses.front());
  setting.held_mib = heldOf(memory);
  settings.push_back(std::move(setting));
}

/// Sampling on the beam grid and scan conversion with nothing between: what a setting pays for its beams before the first effect.
void addBareBeams(std::vector<FrameSetting>& settings, const World& world, FrameSetting setting) {
  struct State {
    BeamGrid grid;
    ScanConversionTable table;
    std::vector<SampleRow> rows;
    SliceScratch scratch;
    GreyImage lines;
    BeamImage beams;
    GreyImage image;
  };
  auto state = std::make_shared<State>();
  const DisplayGeometry geometry = fitDisplay(world.probe, setting.knobs, world.options.width_px, world.options.height_px);
  state->grid = makeBeamGrid(world.probe, setting.knobs, geometry.depth_mm, geometry.pixel_mm);
  state->table = makeScanConversion(world.probe, setting.knobs, state->grid, geometry);
  const int lines = static_cast<int>(state->grid.lines.size());
  state->lines = GreyImage(state->grid.samples, lines);
  state->beams = BeamImage(lines, state->grid.samples);
  state->image = GreyImage(world.options.width_px, world.options.height_px);
  setting.frame = [state, &world, quality = setting.knobs.quality](const Pose& pose) {
    rowsOf(state->grid, world.volume.grid.worldToVoxel() * pose.probeToWorld, glm::dvec2(0.0), state->rows);
    sampleRows(quality, world.voxels.source(world.volume.grid, 0.0), state->rows, viewOf(state->lines), state->scratch);
    accumulatePlane(viewOf(std::as_const(state->lines)), 1.0F, true, viewOf(state->beams));
    scanConvert(state->table, viewOf(std::as_const(state->beams)), 0, state->image.height, viewOf(state->image));
    return static_cast<const std::uint8_t*>(state->image.pixels.data());
  };
  settings.push_back(std::move(setting));
}

void addPeers(std::vector<FrameSetting>& settings, const World& world) {
  const DisplayGeometry geometry = fitDisplay(world.probe, Knobs(), world.options.width_px, world.options.height_px);
  const auto imageToProbe = geometry.imageToProbe();
  const auto worldToVoxel = world.volume.grid.worldToVoxel();
  for (const auto& [quality, method] :
       {std::pair{Quality::weave, "VTK nearest"}, std::pair{Quality::linear, "VTK linear"}, std::pair{Quality::cubic, "VTK cubic"}}) {
    FrameSetting setting;
    setting.group = "sampling";
    setting.method = method;
    setting.peer = true;
    setting.exact = Exact::field;
    const auto slicer = peerSlicer(quality, world.volume, world.options.width_px, world.options.height_px);
    setting.frame = [=](const Pose& pose) { return slicer(worldToVoxel * pose.probeToWorld * imageToProbe); };
    settings.push_back(std::move(setting));
  }
  // The same number of pixels through the volume's middle, one voxel a pixel: those beside the volume cost VTK little.
  FrameSetting setting;
  setting.group = "one voxel a pixel";
  setting.method = "VTK linear, one voxel a pixel";
  setting.peer = true;
  const auto slicer = peerSlicer(Quality::linear, world.volume, world.options.width_px, world.options.height_px);
  setting.frame = [=, &world](const Pose& pose) {
    Transform<frame::Voxel, frame::Image> plane;
    const glm::dmat4& matrix = pose.probeToWorld.matrix;
    const glm::dvec3 middle_voxel(0.5 * (world.side - 1));
    plane.matrix[0] = matrix[0];
    plane.matrix[1] = matrix[1];
    plane.matrix[2] = matrix[2];
    plane.matrix[3] = glm::dvec4(
        middle_voxel - glm::dvec3(matrix[0]) * (0.5 * world.options.width_px) - glm::dvec3(matrix[1]) * (0.5 * world.options.height_px),
        1.0);
    return slicer(plane);
  };
  settings.push_back(std::move(setting));
}

/// The settings of one volume, each with its own scanner.
class FrameSettings {
 public:
  explicit FrameSettings(const World& world) : world_(world) {}

  void addSampling() {
    const std::pair<Quality, const char*> qualities[] = {{Quality::weave, "weave"}, {Quality::linear, "linear"}, {Quality::cubic, "cubic"}};
    const auto sampling = [](Quality quality, std::string method) {
      FrameSetting setting = neutral("sampling", std::move(method));
      setting.knobs.quality = quality;
      setting.exact = Exact::field;
      return setting;
    };
    for (const auto& [quality, name] : qualities) addFrames(settings_, world_, sampling(quality, name));
    for (const auto& [quality, name] : qualities) addBareBeams(settings_, world_, sampling(quality, std::string("beams, ") + name));
  }

  /// The effects whose choices have exact answers.
  void addBeamWidths() {
    for (const int planes : {3, 5, 7, 9}) {
      FrameSetting setting = neutral("slice thickness", std::to_string(planes) + " planes");
      setting.scene.sliceThickness.emplace();
      setting.knobs.elevationPlanes = planes;
      setting.exact = Exact::elevationalMean;
      addFrames(settings_, world_, setting);
    }
    for (const auto& [method, name] :
         {std::pair{FocusMethod::rowStretch, "row stretch"}, std::pair{FocusMethod::lateralKernel, "lateral kernel"}}) {
      FrameSetting setting = neutral("focus", name);
      setting.scene.focus.emplace();
      setting.knobs.focusMethod = method;
      setting.knobs.focus_mm = 60.0;
      setting.exact = Exact::lateralMean;
      addFrames(settings_, world_, setting);
    }
  }

  void addSingleKnobs() {
    alone("gain and TGC", [](FrameSetting& s) { s.knobs.gain = 1.2, s.knobs.dgc = everyKnob().dgc; });
    alone("gain and TGC in decibels", [](FrameSetting& s) {
      s.knobs.gainLaw = GainLaw::decibel;
      s.knobs.gain_db = 2.0;
      s.knobs.tgc_db = {-2, -1, 0, 0, 1, 2, 3, 4};
    });
    alone("dynamic range, grey map", [](FrameSetting& s) { s.knobs.dynamicRange_db = 50.0, s.knobs.greyMap = GreyMap::soft; });
    alone("edge enhancement", [](FrameSetting& s) { s.knobs.edgeEnhancement = 0.4; });
    alone("persistence", [](FrameSetting& s) { s.knobs.persistence = 0.3; });
    alone("M-mode beside B-mode", [](FrameSetting& s) { s.knobs.mode = DisplayMode::both; });
  }

  /// Every effect that no setting has yet; those that need labels or gaps to act on come first.
  void addSingleEffects() {
    const auto shadow = [](FrameSetting& s) { s.scene.attenuation.emplace(); };
    alone("shadow by grey level", shadow);
    alone("shadow by tissue", shadow, true);
    alone(
        "contact loss", [](FrameSetting& s) { s.scene.contact.emplace(); }, false, true);
    for (const EffectInfo& effect : sceneEffects()) {
      const bool isMeasured = std::any_of(settings_.begin(), settings_.end(), [&](const FrameSetting& s) { return effect.isOn(s.scene); });
      if (!isMeasured) alone(effect.shortName, [&effect](FrameSetting& s) { effect.switchTo(s.scene, true); });
    }
  }

  void addEverything() {
    everything("everything", [](FrameSetting&) {});
    everything("everything, weave", [](FrameSetting& s) { s.knobs.quality = Quality::weave; });
    everything("everything, cubic", [](FrameSetting& s) { s.knobs.quality = Quality::cubic; });
    everything("everything, 3 planes", [](FrameSetting& s) { s.knobs.elevationPlanes = 3; });
    everything("everything, 7 planes", [](FrameSetting& s) { s.knobs.elevationPlanes = 7; });
    everything("everything, row stretch", [](FrameSetting& s) { s.knobs.focusMethod = FocusMethod::rowStretch; });
  }

  void addTwoThreads() {
    FrameSetting two = neutral("two threads", "linear");
    two.threads = 2;
    addFrames(settings_, world_, two);
    everything(
        "everything", [](FrameSetting& s) { s.group = "two threads"; }, 2);
  }

  /// All of them, with the peers when they are asked for, by the names of the report.
  std::vector<FrameSetting> named() {
    if (world_.options.peers) addPeers(settings_, world_);
    const std::string size = std::to_string(world_.options.width_px) + "x" + std::to_string(world_.options.height_px);
    for (FrameSetting& setting : settings_) {
      std::string name = setting.method;
      std::erase(name, ',');
      std::replace(name.begin(), name.end(), ' ', '_');
      setting.name = "frame_" + size + "_of_" + std::to_string(world_.side) + "cubed/" + name + "/" + std::to_string(setting.threads);
    }
    return std::move(settings_);
  }

 private:
  static FrameSetting neutral(std::string group, std::string method) {
    FrameSetting setting;
    setting.group = std::move(group);
    setting.method = std::move(method);
    return setting;
  }
  void alone(const char* method, const std::function<void(FrameSetting&)>& set, bool labels = false, bool gaps = false) {
    FrameSetting setting = neutral("one effect", method);
    set(setting);
    addFrames(settings_, world_, setting, labels, gaps);
  }
  void everything(const std::string& method, const std::function<void(FrameSetting&)>& change, int threads = 1) {
    FrameSetting setting = neutral("everything", method);
    setting.knobs = everyKnob();
    setting.scene = sceneWithEverything();
    setting.threads = threads;
    change(setting);
    addFrames(settings_, world_, setting, true, true);
  }

  const World& world_;
  std::vector<FrameSetting> settings_;
};

std::vector<FrameSetting> settingsOf(const World& world) {
  FrameSettings settings(world);
  settings.addSampling();
  settings.addBeamWidths();
  settings.addSingleKnobs();
  settings.addSingleEffects();
  settings.addEverything();
  settings.addTwoThreads();
  return settings.named();
}

/// The exact grey level of a pixel under a setting.
class FrameAnswer {
 public:
  FrameAnswer(const World& world, const FrameSetting& setting)
      : world_(world),
        setting_(setting),
        geometry_(fitDisplay(world.probe, setting.knobs, world.options.width_px, world.options.height_px)),
        grid_(makeBeamGrid(world.probe, setting.knobs, geometry_.depth_mm, geometry_.pixel_mm)) {
    if (setting.exact == Exact::lateralMean) beam_ = beamModelOf(world.probe, setting.knobs, *setting.scene.focus, geometry_.depth_mm);
  }

  /// Empty where the image's edge or the volume's would count.
  [[nodiscard]] std::optional<double> at(int x, int y, const Pose& pose) const {
    const glm::dvec3 p_mm(geometry_.imageToProbe().matrix * glm::dvec4(x, y, 0.0, 1.0));
    const glm::dvec2 place = lineAndSampleAt(world_.probe, setting_.knobs, grid_, glm::dvec2(p_mm));
    const double lines = static_cast<double>(grid_.lines.size()), depth_mm = grid_.depth_mm(place.y);
    if (!(place.x > 0.1 * lines && place.x < 0.9 * lines && depth_mm > 8.0 && depth_mm < geometry_.depth_mm - 4.0)) return std::nullopt;
    const auto probeToVoxel = world_.volume.grid.worldToVoxel() * pose.probeToWorld;
    const auto voxel = [&](const glm::dvec3& at_mm) { return glm::dvec3(probeToVoxel.matrix * glm::dvec4(at_mm, 1.0)); };
    if (setting_.exact == Exact::field) return world_.field.at(voxel(p_mm));
    if (setting_.exact == Exact::elevationalMean) {
      const double width_mm = elevationalWidth_mm(world_.probe, 0.0, *setting_.scene.sliceThickness, depth_mm);
      return world_.field.meanAt(voxel(p_mm), glm::dvec3(probeToVoxel.matrix[2]) * (width_mm / kPerSigma));
    }
    // Along the arc of equal depth; the mean under a normal distribution by a sum over +-4 standard deviations.
    const double sigma_mm = blurWidth_mm(beam_, depth_mm) / kPerSigma;
    const glm::dvec2 apex_mm(0.0, -world_.probe.radius_mm);
    const glm::dvec2 fromApex = glm::dvec2(p_mm) - apex_mm;
    const double radius_mm = glm::length(fromApex), angle = std::atan2(fromApex.x, fromApex.y);
    constexpr int kHalf = 16;
    double sum = 0.0, weights = 0.0;
    for (int n = -kHalf; n <= kHalf; ++n) {
      const double u = 4.0 * n / kHalf, weight = std::exp(-0.5 * u * u);
      const double turned = angle + u * sigma_mm / radius_mm;
      sum += weight * world_.field.at(voxel(glm::dvec3(apex_mm + radius_mm * glm::dvec2(std::sin(turned), std::cos(turned)), 0.0)));
      weights += weight;
    }
    return sum / weights;
  }

 private:
  const World& world_;
  const FrameSetting& setting_;
  DisplayGeometry geometry_;
  BeamGrid grid_;
  BeamModel beam_;
};

void measureError(FrameSetting& setting, const World& world) {
  if (setting.exact == Exact::none) return;
  const FrameAnswer answer(world, setting);
  const int step = setting.exact == Exact::lateralMean ? 5 : 3;
  double squares = 0.0, count = 0.0;
  for (std::size_t n = 0; n < world.poses.size(); n += std::max<std::size_t>(1, world.poses.size() / 3)) {
    const std::uint8_t* pixels = setting.frame(world.poses[n]);
    for (int y = 0; y < world.options.height_px; y += step)
      for (int x = 0; x < world.options.width_px; x += step) {
        const auto exact = answer.at(x, y, world.poses[n]);
        if (!exact) continue;
        const double error = pixels[static_cast<std::ptrdiff_t>(y) * world.options.width_px + x] - *exact;
        squares += error * error;
        count += 1.0;
        setting.worst_grey = std::max(setting.worst_grey, std::abs(error));
      }
  }
  if (squares > 0.0) setting.psnr_db = 10.0 * std::log10(255.0 * 255.0 * count / squares);
}

double now_s() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

/// Settings take turns, in another order each time, so that a busy moment of the machine falls on no one alone.
bool timeSettings(std::vector<FrameSetting>& settings, const World& world, Progress& progress) {
  std::vector<std::size_t> order(settings.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = n;
  std::mt19937 random(7);
  for (int repetition = 0; repetition < world.options.repetitions; ++repetition) {
    std::shuffle(order.begin(), order.end(), random);
    for (std::size_t n = 0; n < order.size(); ++n) {
      if (progress.cancelRequested()) return false;
      progress.report(say<"Timing frames of %1 cubed">(world.side),
                      (repetition + static_cast<double>(n) / static_cast<double>(order.size())) / world.options.repetitions);
      FrameSetting& setting = settings[order[n]];
      setting.frame(world.poses.back());  // its tables come back into the caches
      const double startWall_s = now_s(), startCpu_s = threadTime_s();
      for (const Pose& pose : world.poses) {
        setting.frame(pose);
        if (setting.scanner)
          for (const StepTime& time : setting.scanner->lastTimes()) setting.steps_us[nameOf(time.kind)].push_back(time.measured_us);
      }
      const double frames = static_cast<double>(world.poses.size());
      setting.cpu_us.push_back(1e6 * (threadTime_s() - startCpu_s) / frames);
      setting.wall_us.push_back(1e6 * (now_s() - startWall_s) / frames);
    }
  }
  return true;
}

const FrameSetting* settingNamed(const std::vector<FrameSetting>& settings, const std::string& group, const std::string& method) {
  const auto found =
      std::find_if(settings.begin(), settings.end(), [&](const FrameSetting& s) { return s.group == group && s.method == method; });
  return found == settings.end() ? nullptr : &*found;
}

void addToReport(const std::vector<FrameSetting>& settings, const World& world, json& report) {
  const FrameSetting* peer = settingNamed(settings, "sampling", "VTK linear");
  const double peer_us = peer ? medianOf(peer->cpu_us) : 0.0;
  for (const FrameSetting& setting : settings) {
    const double time_us = setting.threads == 1 ? medianOf(setting.cpu_us) : medianOf(setting.wall_us);
    json row = {
        {"name", setting.name},       {"group", setting.group},    {"method", setting.method}, {"peer", setting.peer},
        {"threads", setting.threads}, {"volume_side", world.side}, {"median_us", time_us},     {"wall_us", medianOf(setting.wall_us)}};
    if (setting.scanner) {
      std::ostringstream plan;
      plan << setting.scanner->plan();
      row["plan"] = plan.str();
      row["held_mib"] = setting.held_mib;
    }
    if (peer_us > 0.0) row["of_peer"] = time_us / peer_us;
    if (setting.exact != Exact::none) {
      row["psnr_db"] = setting.psnr_db;
      row["worst_grey"] = setting.worst_grey;
    }
    report["results"].push_back(std::move(row));
    if (setting.group == "everything" && setting.method == "everything")
      for (const auto& [step, times_us] : setting.steps_us)
        report["steps"].push_back(json(cli::stepRow(setting.name + "/" + step, times_us)));
  }
  const auto must = [&](const std::string& what, const FrameSetting* setting, double limit) {
    if (!setting || peer_us <= 0.0) return;
    const double value = medianOf(setting->cpu_us) / peer_us;
    report["must_show"].push_back({{"name", what + ", " + std::to_string(world.side) + " cubed, of VTK's bare linear slice"},
                                   {"value", value},
                                   {"limit", limit},
                                   {"met", value <= limit}});
  };
  must("every effect on", settingNamed(settings, "everything", "everything"), world.side <= 256 ? 0.25 : 0.35);
  must("neutral plan", settingNamed(settings, "sampling", "linear"), 0.12);
}

Result<void> checkOptions(const FrameBenchOptions& options) {
  const auto refuse = [](const Message& what) { return failure(ErrorCode::badUsage, what); };
  if (options.volumeSides.empty()) return refuse(say<"The benchmark of frames needs at least one volume side; give --side 256.">());
  for (const int side : options.volumeSides)
    if (side < 64 || side > 1024) return refuse(say<"A volume side must lie between 64 and 1024 voxels.">());
  if (options.width_px < 128 || options.width_px > 4096 || options.height_px < 128 || options.height_px > 4096)
    return refuse(say<"An image must be between 128 and 4096 pixels wide and high.">());
  if (options.poses < 2 || options.poses > 1000) return refuse(say<"The number of poses must lie between 2 and 1000.">());
  if (options.repetitions < 1 || options.repetitions > 1000) return refuse(say<"The number of repetitions must lie between 1 and 1000.">());
  return {};
}

}  // namespace

Result<json> benchFrame(const FrameBenchOptions& options, Progress& progress) {
  if (auto usable = checkOptions(options); !usable) return passOn(usable.error());
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  const auto probe = readProbe(*resources / "probes" / "convex-3.5.json");
  if (!probe) return passOn(probe.error());
  const auto stopped = [] { return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">()); };

  json report = {{"machine", machineName()}, {"width", options.width_px},  {"height", options.height_px},
                 {"probe", probe->name},     {"poses", options.poses},     {"repetitions", options.repetitions},
                 {"results", json::array()}, {"must_show", json::array()}, {"steps", json::array()}};
  for (std::size_t n = 0; n < options.volumeSides.size(); ++n) {
    const int side = options.volumeSides[n];
    const double share = 1.0 / static_cast<double>(options.volumeSides.size());
    PartOfProgress part(progress, static_cast<double>(n) * share, static_cast<double>(n + 1) * share);
    part.report(say<"Filling a volume of %1 cubed">(side), 0.0);
    auto made = makeWorld(options, side, *probe, part);
    if (!made) return passOn(made.error());
    World& world = **made;
    if (auto laid = layOut(world, part); !laid) return passOn(laid.error());
    std::vector<FrameSetting> settings = settingsOf(world);
    for (FrameSetting& setting : settings) {
      if (part.cancelRequested()) return stopped();
      measureError(setting, world);
      const auto all = [&] {
        for (const Pose& pose : world.poses) setting.frame(pose);
      };
      if (setting.threads == 1 && !runsOnThisThreadAlone(all))
        return failure(ErrorCode::internal,
                       say<"'%1' used more than one thread, so its times cannot be compared; report this.">(setting.name));
    }
    // Only now, for the field alone has an exact answer: strong interfaces, so that every effect has something to do.
    paintBalls(world);
    if (auto laid = layOut(world, part); !laid) return passOn(laid.error());
    std::vector<FrameSetting> painted = settingsOf(world);
    for (std::size_t at = 0; at < settings.size(); ++at) {
      painted[at].psnr_db = settings[at].psnr_db;
      painted[at].worst_grey = settings[at].worst_grey;
    }
    settings = std::move(painted);
    if (!timeSettings(settings, world, part)) return stopped();
    addToReport(settings, world, report);
  }
  return report;
}

}  // namespace ew
