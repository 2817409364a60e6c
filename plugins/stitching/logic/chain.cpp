#include "logic/chain.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <map>
#include <mutex>
#include <numeric>

#include "ew/core/depth_curves.h"
#include "ew/core/parallel.h"
#include "ew/core/version.h"
#include "logic/beside.h"
#include "logic/chain_json.h"
#include "logic/content_key.h"
#include "logic/group_bend.h"
#include "logic/overlap.h"
#include "logic/pair_match.h"
#include "logic/places.h"
#include "logic/provenance.h"
#include "logic/step_store.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;
using registration::Verdict;

/// Part of a step's key: raise it when the step starts to give another result for the same inputs.
constexpr int kInputFormat = 2;
constexpr int kPairFormat = 2;
constexpr int kGraphFormat = 1;
constexpr int kEqualiseFormat = 2;
constexpr int kBendFormat = 2;
constexpr int kSeamFormat = 2;
constexpr int kVolumeFormat = 2;
constexpr double kHandError_mm = 10.0;  ///< how far a place given by hand is believed
constexpr double kHandError_deg = 10.0;
constexpr double kAcceptedError_mm = 1.0;  ///< of a pair a person accepted although its images say nothing about its error
constexpr double kAcceptedError_deg = 1.0;
constexpr double kUnconfirmed = 0.1;  ///< trust in an elastic pair that the images did not confirm
/// What is registered elastically of two views: their overlap and so much around it, for motions and for windows of local means.
constexpr double kAround_mm = 20.0;
/// Voxels of the finest images of rigid pairs that are bent afterwards: places within 0.2 mm are all that bending needs.
constexpr double kFinestBeforeBending_mm = 1.5;
constexpr const char* kPairStep = "pairs";
constexpr const char* kBendStep = "bends";
/// Where each step begins in the whole, from what they took on six virtual subvolumes.
constexpr std::array kShares = {0.0, 0.15, 0.40, 0.42, 0.46, 0.80, 0.88, 1.0};

tl::unexpected<Error> cancelled() { return failure(ErrorCode::cancelled, "The stitching was cancelled; what was finished is kept."); }

class Clock {
 public:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count(); }

 private:
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

/// A result that is read back: what a damaged file throws becomes "not there".
template <class Value, class From>
std::optional<Value> readBack(const std::optional<json>& data, const From& from) {
  if (!data) return std::nullopt;
  try {
    return from(*data);
  } catch (const json::exception&) {
    return std::nullopt;
  }
}

std::string bytesOf(const std::vector<glm::vec3>& vectors) {
  return {reinterpret_cast<const char*>(vectors.data()), vectors.size() * sizeof(glm::vec3)};
}

/// Whether two boxes at their places meet when each is `margin_mm` larger: by the separating axes of their faces and edges.
bool boxesMeet(const Grid& a, const Grid& b, double margin_mm) {
  const glm::dvec3 apart = middleOf(b) - middleOf(a);
  const auto reach = [margin_mm](const Grid& grid, const glm::dvec3& axis) {
    double sum = margin_mm;
    for (int d = 0; d < 3; ++d) sum += std::abs(glm::dot(axis, grid.directions[d])) * 0.5 * (grid.dims[d] - 1) * grid.spacing_mm[d];
    return sum;
  };
  const auto parted = [&](const glm::dvec3& axis) {
    const double length = glm::length(axis);
    if (length < 1e-9) return false;
    const glm::dvec3 unit = axis / length;
    return std::abs(glm::dot(apart, unit)) > reach(a, unit) + reach(b, unit);
  };
  for (int d = 0; d < 3; ++d) {
    if (parted(a.directions[d]) || parted(b.directions[d])) return false;
    for (int e = 0; e < 3; ++e)
      if (parted(glm::cross(a.directions[d], b.directions[e]))) return false;
  }
  return true;
}

void addOptions(ContentKey& key, const StitchOptions& grid) {
  key.add(grid.spacing_mm).add(grid.featherWidth_mm).add(grid.interpolatedWeight).add(static_cast<int>(grid.axes));
}
void addOptions(ContentKey& key, const SeamOptions& seam) {
  key.add(static_cast<int>(seam.method))
      .add(seam.cell_mm)
      .add(seam.blend_mm)
      .add(seam.levelBlend_mm)
      .add(seam.confidenceWeight)
      .add(seam.distanceWeight);
  for (const auto& stroke : seam.strokes) key.add(static_cast<std::uint64_t>(stroke.view)).add(stroke.at_mm).add(stroke.radius_mm);
}

/// One pair of the project: what it asks for and under which key its answer lies.
struct Candidate {
  std::size_t fixed = 0;
  std::size_t moving = 0;
  Decision decision = Decision::undecided;
  PairTask task;
  std::string key;
};

/// The keys of the steps: each of everything it depends on.
struct Keys {
  std::array<std::string, kSteps.size()> of;
  [[nodiscard]] const std::string& operator[](Step step) const { return of[static_cast<std::size_t>(step)]; }
  std::string& operator[](Step step) { return of[static_cast<std::size_t>(step)]; }
};

class Chain {
 public:
  Chain(const StitchProject& project, const fs::path& folder, const ChainOptions& options, sdk::Volumes& volumes, sdk::Files& files,
        StepStore& store, Progress& progress)
      : project_(project),
        settings_(project.settings),
        folder_(folder),
        options_(options),
        volumes_(volumes),
        files_(files),
        store_(store),
        contents_(store, files),
        progress_(progress) {
    for (const Step step : kSteps) state_.steps.push_back({.step = step});
    inputs_.resize(project.volumes.size());
  }

  Result<ChainState> run() {
    if (project_.volumes.empty()) return failure(ErrorCode::emptyVolume, "The stitch project has no volumes; add some.");
    using Body = Result<void> (Chain::*)(Progress&);
    constexpr std::array<Body, kSteps.size()> bodies = {&Chain::reconstruct, &Chain::rigid, &Chain::graph, &Chain::equalise,
                                                        &Chain::elastic,     &Chain::seam,  &Chain::volume};
    for (std::size_t n = 0; n < kSteps.size() && kSteps[n] <= options_.until; ++n) {
      if (progress_.cancelRequested()) return cancelled();
      PartOfProgress part(progress_, kShares[n], kShares[n + 1]);
      const Clock clock;
      if (auto done = (this->*bodies[n])(part); !done) return passOn(done.error());
      state_.steps[n].done = true;
      state_.steps[n].seconds = clock.seconds();
    }
    if (options_.keepVolumes) {
      for (std::size_t v = 0; v < inputs_.size(); ++v) {
        auto view = load(v, progress_);
        if (!view) return passOn(view.error());
        state_.volumes.push_back((*view)->volume);
      }
    }
    return std::move(state_);
  }

  Result<ChainForecast> forecast() {
    if (auto looked = identify(progress_, true); !looked) return passOn(looked.error());
    const Keys keys = keysOf(candidates());
    bool before = true;
    ChainForecast forecast;
    for (const Step step : kSteps) {
      StepOutcome outcome{.step = step};
      before = before && store_.find(nameOf(step), keys[step]).has_value() && (step != Step::volume || resultIsThere(keys[step]));
      outcome.done = outcome.reused = before;
      outcome.forecast_bytes = before ? 0 : peakOf(step);
      forecast.peak_bytes = std::max(forecast.peak_bytes, outcome.forecast_bytes);
      forecast.steps.push_back(outcome);
    }
    return forecast;
  }

 private:
  /// What is known about an input before and after its voxels are read.
  struct Input {
    sdk::VolumeInfo info;
    std::string key;
    Grid grid;  ///< of the volume; of a sweep once that is known
    std::uint64_t sweepBytes = 0;
    std::shared_ptr<const LoadedView> view;
  };

  // ---- keys ----

  [[nodiscard]] ContentKey newKey(const char* what, int format) const {
    ContentKey key;
    key.add(what).add(format).add(kVersion);
    return key;
  }

  /// The content of one file, by its bytes; of what is no file, by its voxels.
  Result<std::string> contentOf(const fs::path& file, Progress& progress) {
    auto content = contents_.keyOf(file, progress);
    if (!content) return passOn(content.error());
    if (*content) return **content;
    auto read = volumes_.read(file, progress);
    if (!read) return passOn(read.error());
    return ContentKey().add(jsonOf(read->grid).dump()).add(std::span<const std::uint8_t>(read->echo)).text();
  }

  Result<void> identify(Progress& progress, bool planSweeps) {
    for (std::size_t v = 0; v < inputs_.size(); ++v) {
      const ProjectVolume& asked = project_.volumes[v];
      Input& input = inputs_[v];
      if (progress.cancelRequested()) return cancelled();
      progress.report("Looking at " + asked.name, 0.0);
      auto info = volumes_.inspect(asked.file);
      if (!info) return passOn(info.error());
      input.info = std::move(*info);
      input.grid = input.info.grid;
      ContentKey key = newKey("input", kInputFormat);
      key.add(input.info.sweep).add(asked.spacing_mm);
      std::vector<fs::path> files = input.info.files;
      for (const fs::path& beside : {asked.coverage, asked.confidence, asked.calibration}) {
        key.add(!beside.empty());
        if (!beside.empty()) files.push_back(beside);
      }
      for (const fs::path& file : files) {
        if (file == asked.calibration) {
          auto text = files_.readText(file);
          if (!text) return passOn(text.error());
          key.add(*text);
          continue;
        }
        auto content = contentOf(file, progress);
        if (!content) return passOn(content.error());
        key.add(*content);
      }
      input.key = key.text();
      if (!input.info.sweep) continue;
      if (auto grid = readBack<Grid>(store_.find(kSweepStep, input.key), [](const json& data) { return gridFrom(data.at("grid")); })) {
        input.grid = *grid;
      } else if (planSweeps) {
        auto plan = volumes_.planSweep(asked.file, sweepOptions(v), progress);
        if (!plan) return passOn(plan.error());
        input.grid = plan->grid;
        input.sweepBytes = plan->bytes;
      }
    }
    return {};
  }

  [[nodiscard]] bool placesAreExact() const { return settings_.trackerError_mm == 0.0; }
  [[nodiscard]] bool isKnown(std::size_t v) const { return project_.volumes[v].placement != Placement::unknown; }
  [[nodiscard]] bool isExact(std::size_t v) const { return placesAreExact() && project_.volumes[v].placement == Placement::tracker; }
  [[nodiscard]] glm::dmat4 fromPlaces(std::size_t fixed, std::size_t moving) const {
    return rigidInverse(project_.volumes[moving].toWorld) * project_.volumes[fixed].toWorld;
  }

  /// The pairs that are worth a look, in order: those a person spoke about, those whose places may overlap, all with an unknown place.
  [[nodiscard]] std::vector<Candidate> candidates() const {
    std::vector<Candidate> found;
    for (std::size_t f = 0; f < inputs_.size(); ++f)
      for (std::size_t m = f + 1; m < inputs_.size(); ++m) {
        const auto entry = std::find_if(project_.pairs.begin(), project_.pairs.end(),
                                        [&](const ProjectPair& pair) { return pair.fixed == f && pair.moving == m; });
        const bool spoken = entry != project_.pairs.end() && speaksOfPose(*entry);
        const bool known = isKnown(f) && isKnown(m);
        if (!spoken && isExact(f) && isExact(m)) continue;
        if (!spoken && known &&
            !boxesMeet(placed(inputs_[f].grid, project_.volumes[f].toWorld), placed(inputs_[m].grid, project_.volumes[m].toWorld),
                       settings_.trackerError_mm))
          continue;
        Candidate candidate;
        candidate.fixed = f;
        candidate.moving = m;
        candidate.task = {.placesKnown = known,
                          .start = fromPlaces(f, m),
                          .landmarks = {},
                          .maxTurn_deg = settings_.maxTurn_deg,
                          .trackerError_mm = settings_.trackerError_mm,
                          .trackerError_deg = settings_.trackerError_deg};
        if (settings_.elastic) candidate.task.finest_mm = kFinestBeforeBending_mm;
        if (spoken) {
          candidate.decision = entry->decision;
          candidate.task.method = entry->method;
          candidate.task.landmarks = entry->landmarks;
          if (entry->start) {
            candidate.task.start = *entry->start;
            candidate.task.placesKnown = true;
          }
          if (entry->maxTurn_deg) candidate.task.maxTurn_deg = *entry->maxTurn_deg;
        }
        candidate.key = keyOf(candidate);
        found.push_back(std::move(candidate));
      }
    return found;
  }

  /// Of everything the answer depends on and nothing else, so that an undone edit finds it again.
  [[nodiscard]] std::string keyOf(const Candidate& candidate) const {
    const PairTask& task = candidate.task;
    const PairMethod first = firstMethod(task);
    ContentKey key = newKey("pair", kPairFormat);
    key.add(inputs_[candidate.fixed].key).add(inputs_[candidate.moving].key);
    key.add(static_cast<int>(task.method)).add(static_cast<int>(first));
    if (first != PairMethod::byHand) key.add(task.finest_mm);
    if (first == PairMethod::refine || first == PairMethod::byHand) key.add(task.start);
    if (first == PairMethod::refine && task.method == PairMethod::automatic) key.add(task.trackerError_mm).add(task.trackerError_deg);
    if (first == PairMethod::search || (first == PairMethod::refine && task.method == PairMethod::automatic)) key.add(task.maxTurn_deg);
    if (first == PairMethod::landmarks)
      for (const auto& landmark : task.landmarks) key.add(landmark.name).add(landmark.fixed_mm).add(landmark.moving_mm);
    return key.text();
  }

  [[nodiscard]] Keys keysOf(const std::vector<Candidate>& pairs) const {
    Keys keys;
    ContentKey reconstructed = newKey("reconstruct", kInputFormat);
    for (const Input& input : inputs_) reconstructed.add(input.key);
    keys[Step::reconstruct] = reconstructed.text();
    ContentKey matched = newKey("rigid", kPairFormat);
    matched.add(keys[Step::reconstruct]);
    for (const Candidate& pair : pairs)
      if (pair.decision != Decision::rejected)
        matched.add(static_cast<std::uint64_t>(pair.fixed)).add(static_cast<std::uint64_t>(pair.moving)).add(pair.key);
    keys[Step::rigid] = matched.text();
    ContentKey posed = newKey("graph", kGraphFormat);
    posed.add(keys[Step::rigid]).add(settings_.trackerError_mm).add(settings_.trackerError_deg);
    for (const Candidate& pair : pairs) posed.add(static_cast<int>(pair.decision));
    for (const ProjectVolume& volume : project_.volumes) posed.add(static_cast<int>(volume.placement)).add(volume.toWorld);
    const std::string poses = posed.text();
    for (const ProjectVolume& volume : project_.volumes) posed.add(volume.name);  // the reason names them
    keys[Step::graph] = posed.text();
    keys[Step::equalise] = newKey("equalise", kEqualiseFormat).add(poses).add(settings_.equalise).text();
    ContentKey bent = newKey("elastic", kBendFormat);
    bent.add(poses).add(settings_.elastic);
    if (settings_.elastic) {
      bent.add(static_cast<int>(settings_.effort)).add(settings_.fallOff_mm);
      for (const ProjectPair& pair : project_.pairs)
        if (pair.effort && *pair.effort != settings_.effort)
          bent.add(static_cast<std::uint64_t>(pair.fixed)).add(static_cast<std::uint64_t>(pair.moving)).add(static_cast<int>(*pair.effort));
    }
    keys[Step::elastic] = bent.text();
    ContentKey cut = newKey("seam", kSeamFormat);
    cut.add(keys[Step::equalise]).add(keys[Step::elastic]);
    addOptions(cut, settings_.join.grid);
    addOptions(cut, settings_.join.seam);
    keys[Step::seam] = cut.text();
    ContentKey joined = newKey("volume", kVolumeFormat);
    joined.add(keys[Step::seam]).add(keys[Step::graph]);
    for (const ProjectVolume& volume : project_.volumes)
      joined.add(volume.file.generic_string()).add(volume.coverage.generic_string()).add(volume.confidence.generic_string());
    joined.add(options_.streamAbove_voxels);  // the same voxels, but other bytes of the files
    keys[Step::volume] = joined.text();
    return keys;
  }

  // ---- memory ----

  /// Of the inputs themselves, which stay in memory: echo, coverage and confidence; and of reading the largest.
  [[nodiscard]] std::uint64_t heldBytes() const {
    std::uint64_t bytes = 0;
    std::uint64_t largest = 0;
    for (const Input& input : inputs_) {
      bytes += 3 * input.grid.voxelCount();
      largest = std::max<std::uint64_t>(largest, input.grid.voxelCount());
    }
    return bytes + 4 * largest;
  }

  [[nodiscard]] std::vector<PlacedGrid> placedGrids() const {
    std::vector<PlacedGrid> grids;
    for (const std::size_t v : included_) grids.push_back({inputs_[v].grid, poseOf(v), project_.volumes[v].name});
    if (included_.empty())
      for (std::size_t v = 0; v < inputs_.size(); ++v)
        grids.push_back({inputs_[v].grid, project_.volumes[v].toWorld, project_.volumes[v].name});
    return grids;
  }

  [[nodiscard]] JoinOptions joinOptions() const {
    JoinOptions options = settings_.join;
    options.grid.threads = options.seam.threads = options_.threads;
    options.grid.maxBytes = options_.maxBytes;
    std::vector<SeamStroke> strokes;
    for (SeamStroke stroke : options.seam.strokes) {
      const auto at = std::find(included_.begin(), included_.end(), stroke.view);
      if (at == included_.end()) continue;
      stroke.view = static_cast<std::size_t>(at - included_.begin());
      strokes.push_back(stroke);
    }
    options.seam.strokes = std::move(strokes);
    return options;
  }

  [[nodiscard]] registration::ElasticOptions elasticOptions(std::size_t fixed, std::size_t moving) const {
    registration::ElasticOptions options;
    options.effort = effortOf(project_, fixed, moving);
    options.threads = options_.threads;
    return options;
  }

  /// A seventh more, for what is too small to be counted and what the allocator keeps between steps: measured, the six sweeps of
  /// tests/stitching/six_subvolumes take up to 1.07 times what is counted.
  static std::uint64_t withMargin_bytes(std::uint64_t counted) { return counted + counted / 7; }

  /// How many pairs are registered beside each other, and what they take then: as many as there are threads and room.
  struct Beside {
    int pairs = 1;
    std::uint64_t bytes = 0;
  };
  [[nodiscard]] Beside besideEachOther_bytes(std::vector<std::uint64_t> each) const {
    std::sort(each.rbegin(), each.rend());
    Beside beside;
    const auto threads = static_cast<std::size_t>(threadCount(options_.threads));
    const std::uint64_t held = heldBytes();
    for (std::size_t n = 0; n < each.size() && n < threads; ++n) {
      if (n > 0 && withMargin_bytes(held + beside.bytes + each[n]) > options_.maxBytes) break;
      beside.bytes += each[n];
      beside.pairs = static_cast<int>(n + 1);
    }
    return beside;
  }

  /// Of bending a pair: its parts of both views, and registering these.
  [[nodiscard]] std::uint64_t bendBytes(const Grid& fixed, const Grid& moving, const glm::dmat4& fixedToMoving,
                                        const registration::ElasticOptions& options) const {
    const auto [in, there] = sharedBoxes(fixed, moving, fixedToMoving, kAround_mm);
    if (in.size() == glm::ivec3(0)) return 0;
    const Grid own = gridOf(fixed, in), other = gridOf(moving, there);
    return registration::forecastElastic_bytes(own, other, options) + 6 * (own.voxelCount() + other.voxelCount());
  }

  /// At the peak of a step, the inputs not counted.
  [[nodiscard]] std::uint64_t forecastOf(Step step) const {
    std::uint64_t bytes = 0;
    switch (step) {
      case Step::reconstruct:
        for (const Input& input : inputs_) bytes = std::max(bytes, input.sweepBytes);
        return bytes;
      case Step::rigid: {
        std::vector<std::uint64_t> each;
        for (const Candidate& pair : candidates())
          if (pair.decision != Decision::rejected)
            each.push_back(forecastPair_bytes(inputs_[pair.fixed].grid, inputs_[pair.moving].grid, pair.task));
        return besideEachOther_bytes(std::move(each)).bytes;
      }
      case Step::graph:
        return 0;
      case Step::equalise: {
        if (!settings_.equalise) return 0;
        // Differences of the cells that two views share, in a list that grows by doubling.
        const double cell_mm = EqualiseViewsOptions{}.cell_mm;
        const auto all = placedGrids();
        for (std::size_t f = 0; f < all.size(); ++f)
          for (std::size_t m = f + 1; m < all.size(); ++m) {
            const VoxelBox shared = sharedBoxes(all[f].grid, all[m].grid, rigidInverse(all[m].toWorld) * all[f].toWorld, 0.0).first;
            const glm::dvec3 size = glm::dvec3(shared.size()) * all[f].grid.spacing_mm / cell_mm;
            bytes += static_cast<std::uint64_t>(1.5 * sizeof(DepthDifference) * size.x * size.y * size.z);
          }
        return bytes;
      }
      case Step::elastic: {
        if (!settings_.elastic) return 0;
        std::vector<Grid> grids;
        std::vector<std::uint64_t> each;
        const auto placedOnes = placedGrids();
        for (const auto& one : placedOnes) grids.push_back(placed(one.grid, one.toWorld));
        const auto number = [&](std::size_t n) { return included_.empty() ? n : included_[n]; };
        for (std::size_t f = 0; f < grids.size(); ++f)
          for (std::size_t m = f + 1; m < grids.size(); ++m)
            if (boxesMeet(grids[f], grids[m], 0.0))
              each.push_back(bendBytes(placedOnes[f].grid, placedOnes[m].grid, rigidInverse(placedOnes[m].toWorld) * placedOnes[f].toWorld,
                                       elasticOptions(number(f), number(m))));
        bytes = besideEachOther_bytes(std::move(each)).bytes;
        return std::max(bytes, forecastBends_bytes(grids, grids.size() * (grids.size() - 1) / 2, bendOptions()));
      }
      case Step::seam:
      case Step::volume: {
        JoinOptions unlimited = joinOptions();
        unlimited.grid.maxBytes = ~std::uint64_t{0};
        const auto forecast = forecastJoin(placedGrids(), unlimited);
        if (!forecast) return 0;  // the step itself says why
        const std::uint64_t voxels = forecast->grid.voxelCount();
        return forecast->bytes + (step == Step::volume && voxels <= options_.streamAbove_voxels ? 3 * voxels : 0);
      }
    }
    return bytes;
  }

  [[nodiscard]] std::uint64_t peakOf(Step step) const { return withMargin_bytes(heldBytes() + forecastOf(step)); }

  Result<void> checkMemory(Step step) {
    StepOutcome& outcome = state_.steps[static_cast<std::size_t>(step)];
    outcome.forecast_bytes = peakOf(step);
    if (outcome.forecast_bytes <= options_.maxBytes) return {};
    return failure(ErrorCode::tooLarge,
                   "The step " + std::string(nameOf(step)) + " would need " + std::to_string(outcome.forecast_bytes >> 20) +
                       " MiB of memory, more than the " + std::to_string(options_.maxBytes >> 20) +
                       " MiB allowed; use a coarser spacing_mm or fewer volumes at a time.",
                   {{"step", nameOf(step)}, {"forecast_bytes", std::to_string(outcome.forecast_bytes)}});
  }

  // ---- inputs ----

  static constexpr const char* kSweepStep = "reconstruct";

  [[nodiscard]] sdk::SweepOptions sweepOptions(std::size_t v) const {
    const ProjectVolume& asked = project_.volumes[v];
    return {.spacing_mm = asked.spacing_mm, .calibration = asked.calibration, .threads = options_.threads, .maxBytes = options_.maxBytes};
  }

  Result<void> makeSweep(std::size_t v, Progress& progress) {
    PartOfProgress making(progress, 0.0, 0.8), writing(progress, 0.8, 1.0);
    auto made = volumes_.reconstruct(project_.volumes[v].file, sweepOptions(v), making);
    if (!made) return passOn(made.error());
    const std::string& key = inputs_[v].key;
    if (auto room = store_.prepare(kSweepStep); !room) return room;
    if (auto w = volumes_.write(made->volume, store_.fileOf(kSweepStep, key, "volume.mha"), writing); !w) return w;
    if (auto w = volumes_.writeCoverage(made->volume, store_.fileOf(kSweepStep, key, "coverage.mha"), writing); !w) return w;
    if (auto w = volumes_.writeConfidence(made->volume.grid, made->confidence, store_.fileOf(kSweepStep, key, "confidence.mha"), writing);
        !w)
      return w;
    ordered_json data = {{"grid", jsonOf(made->volume.grid)}, {"beams", jsonOf(made->beams)}, {"notes", made->notes}};
    if (auto kept = store_.keep(kSweepStep, key, std::move(data), {"volume.mha", "coverage.mha", "confidence.mha"}); !kept) return kept;
    inputs_[v].grid = made->volume.grid;
    return {};
  }

  Result<std::shared_ptr<LoadedView>> readSweep(std::size_t v, Progress& progress) {
    const std::string& key = inputs_[v].key;
    const auto about = readBack<std::pair<Grid, std::optional<Beams>>>(
        store_.find(kSweepStep, key), [](const json& data) { return std::pair(gridFrom(data.at("grid")), beamsFrom(data.at("beams"))); });
    if (!about) return failure(ErrorCode::notFound, "The reconstruction of '" + project_.volumes[v].name + "' is not there.");
    auto volume = volumes_.read(store_.fileOf(kSweepStep, key, "volume.mha"), progress);
    if (!volume) return passOn(volume.error());
    if (auto r = volumes_.readCoverageInto(*volume, store_.fileOf(kSweepStep, key, "coverage.mha"), progress); !r) return passOn(r.error());
    auto confidence = volumes_.readConfidence(volume->grid, store_.fileOf(kSweepStep, key, "confidence.mha"), progress);
    if (!confidence) return passOn(confidence.error());
    volume->grid = about->first;  // to the last bit, whatever the file's text of it says
    auto view = std::make_shared<LoadedView>();
    view->volume = std::make_shared<const Volume>(std::move(*volume));
    view->confidence = std::move(*confidence);
    view->beams = about->second;
    return view;
  }

  Result<std::shared_ptr<LoadedView>> readVolume(std::size_t v, Progress& progress) {
    const ProjectVolume& asked = project_.volumes[v];
    auto volume = volumes_.read(asked.file, progress);
    if (!volume) return passOn(volume.error());
    if (!asked.coverage.empty())
      if (auto r = volumes_.readCoverageInto(*volume, asked.coverage, progress); !r) return passOn(r.error());
    auto view = std::make_shared<LoadedView>();
    if (!asked.confidence.empty()) {
      auto confidence = volumes_.readConfidence(volume->grid, asked.confidence, progress);
      if (!confidence) return passOn(confidence.error());
      view->confidence = std::move(*confidence);
    }
    view->volume = std::make_shared<const Volume>(std::move(*volume));
    return view;
  }

  /// The voxels of an input, read once.
  Result<std::shared_ptr<const LoadedView>> load(std::size_t v, Progress& progress) {
    Input& input = inputs_[v];
    if (input.view) return input.view;
    if (progress.cancelRequested()) return cancelled();
    progress.report("Reading " + project_.volumes[v].name, 0.0);
    auto view = input.info.sweep ? readSweep(v, silent_) : readVolume(v, silent_);
    if (!view && input.info.sweep && view.error().code != ErrorCode::cancelled) {
      store_.remove(kSweepStep, input.key);  // damaged: made again, once
      if (auto made = makeSweep(v, silent_); !made) return passOn(made.error());
      view = readSweep(v, silent_);
    }
    if (!view) return passOn(view.error());
    (*view)->name = project_.volumes[v].name;
    input.view = std::move(*view);
    input.grid = input.view->volume->grid;
    return input.view;
  }

  // ---- steps ----

  StepOutcome& outcomeOf(Step step) { return state_.steps[static_cast<std::size_t>(step)]; }

  Result<void> reconstruct(Progress& progress) {
    if (auto known = identify(progress, false); !known) return known;
    contents_.save();
    const std::size_t count = inputs_.size();
    for (std::size_t v = 0; v < count; ++v) {
      Input& input = inputs_[v];
      if (!input.info.sweep || store_.find(kSweepStep, input.key)) continue;
      PartOfProgress part(progress, static_cast<double>(v) / static_cast<double>(count),
                          static_cast<double>(v + 1) / static_cast<double>(count));
      auto plan = volumes_.planSweep(project_.volumes[v].file, sweepOptions(v), silent_);
      if (!plan) return passOn(plan.error());
      input.grid = plan->grid;
      input.sweepBytes = plan->bytes;
      if (auto fits = checkMemory(Step::reconstruct); !fits) return fits;
      if (auto made = makeSweep(v, part); !made) return made;
    }
    if (auto fits = checkMemory(Step::reconstruct); !fits) return fits;
    candidates_ = candidates();
    keys_ = keysOf(candidates_);
    StepOutcome& outcome = outcomeOf(Step::reconstruct);
    outcome.reused = store_.find(nameOf(Step::reconstruct), keys_[Step::reconstruct]).has_value();
    if (outcome.reused) return {};
    for (std::size_t v = 0; v < count; ++v)  // coverage of another grid and the like are said now, not after an hour
      if (auto view = load(v, progress); !view) return passOn(view.error());
    return store_.keep(nameOf(Step::reconstruct), keys_[Step::reconstruct], {{"inputs", count}});
  }

  [[nodiscard]] std::optional<PairOutcome> findPair(const Candidate& pair) const {
    auto found = readBack<PairOutcome>(store_.find(kPairStep, pair.key), [](const json& data) { return pairFrom(data.at("outcome")); });
    if (found) {
      found->fixed = pair.fixed;
      found->moving = pair.moving;
    }
    return found;
  }

  Result<void> rigid(Progress& progress) {
    if (auto fits = checkMemory(Step::rigid); !fits) return fits;
    StepOutcome& outcome = outcomeOf(Step::rigid);
    outcome.reused = store_.find(nameOf(Step::rigid), keys_[Step::rigid]).has_value();
    std::vector<std::optional<PairOutcome>> found;
    std::vector<std::size_t> missing;
    std::vector<std::uint64_t> bytes;
    for (std::size_t n = 0; n < candidates_.size(); ++n) {
      const Candidate& pair = candidates_[n];
      found.push_back(findPair(pair));
      if (found.back() || pair.decision == Decision::rejected) continue;
      missing.push_back(n);
      bytes.push_back(forecastPair_bytes(inputs_[pair.fixed].grid, inputs_[pair.moving].grid, pair.task));
    }
    if (!missing.empty()) {
      outcome.reused = false;
      for (const std::size_t n : missing)
        for (const std::size_t v : {candidates_[n].fixed, candidates_[n].moving})
          if (auto view = load(v, progress); !view) return passOn(view.error());
      const int atOnce = besideEachOther_bytes(bytes).pairs;
      const auto matched = besideEachOther(missing.size(), atOnce, progress, [&](std::size_t n, Progress& part) -> Result<void> {
        auto made = match(candidates_[missing[n]], threadsOfEach(atOnce), part);
        if (!made) return passOn(made.error());
        found[missing[n]] = std::move(*made);
        return {};
      });
      if (!matched) return matched;
    }
    for (std::size_t n = 0; n < candidates_.size(); ++n) {
      if (!found[n]) continue;
      state_.pairs.push_back(std::move(*found[n]));
      decisions_.push_back(candidates_[n].decision);
    }
    if (outcome.reused) return {};
    return store_.keep(nameOf(Step::rigid), keys_[Step::rigid], {{"pairs", state_.pairs.size()}});
  }

  /// Threads of each of so many pairs.
  [[nodiscard]] int threadsOfEach(int atOnce) const { return std::max(1, threadCount(options_.threads) / atOnce); }

  [[nodiscard]] registration::OnLevel levelsOf(std::size_t fixed, std::size_t moving) {
    if (!options_.onLevel) return {};
    return [this, fixed, moving](const registration::Level& level) {
      const std::lock_guard lock(onLevelGuard_);
      options_.onLevel(fixed, moving, level);
    };
  }

  /// Both views are loaded.
  Result<PairOutcome> match(const Candidate& pair, int threads, Progress& progress) {
    const LoadedView &fixed = *inputs_[pair.fixed].view, &moving = *inputs_[pair.moving].view;
    progress.report("Registering " + fixed.name + " and " + moving.name, 0.0);
    auto made = matchPair(fixed, moving, pair.task, threads, progress, levelsOf(pair.fixed, pair.moving));
    if (!made) return passOn(made.error());
    made->fixed = pair.fixed;
    made->moving = pair.moving;
    ordered_json data = {{"fixed", fixed.name}, {"moving", moving.name}, {"outcome", jsonOf(*made)}};
    if (auto kept = store_.keep(kPairStep, pair.key, std::move(data)); !kept) return passOn(kept.error());
    return made;
  }

  [[nodiscard]] registration::GraphResult asPlaced() const {
    registration::GraphResult graph;
    for (const auto& volume : project_.volumes) graph.toWorld.push_back(volume.toWorld);
    graph.part.assign(project_.volumes.size(), 0);
    graph.parts = 1;
    graph.verdict = Verdict::aligned;
    graph.reason = project_.volumes.size() == 1 ? "There is one volume alone." : "The recorded places were taken as they are.";
    return graph;
  }

  Result<void> graph(Progress& progress) {
    const bool allExact = [&] {
      for (std::size_t v = 0; v < inputs_.size(); ++v)
        if (!isExact(v)) return false;
      return true;
    }();
    std::vector<std::size_t> pairOfEdge;
    std::vector<registration::GraphEdge> edges;
    for (std::size_t n = 0; n < state_.pairs.size(); ++n) {
      const PairOutcome& pair = state_.pairs[n];
      const bool accepted = decisions_[n] == Decision::accepted;
      if (decisions_[n] == Decision::rejected || (pair.rigid.verdict != Verdict::aligned && !accepted)) continue;
      registration::GraphEdge edge;
      edge.fixed = pair.fixed;
      edge.moving = pair.moving;
      edge.fixedToMoving = pair.rigid.fixedToMoving;
      edge.covariance = pair.rigid.covariance;
      if (!edge.covariance && accepted) edge.covariance = evenCovariance(kAcceptedError_mm, kAcceptedError_deg);
      edge.centre_mm = pair.rigid.centre_mm;
      edges.push_back(edge);
      pairOfEdge.push_back(n);
    }
    const std::string& key = keys_[Step::graph];
    auto found =
        readBack<registration::GraphResult>(store_.find(nameOf(Step::graph), key), [](const json& data) { return graphFrom(data); });
    if (found && (found->toWorld.size() != inputs_.size() || found->part.size() != inputs_.size())) found.reset();
    outcomeOf(Step::graph).reused = found.has_value();
    if (found) {
      state_.graph = std::move(*found);
    } else {
      if (inputs_.size() == 1 || (allExact && edges.empty())) {
        state_.graph = asPlaced();
      } else {
        auto solved = registration::solveGraph(nodes(), edges, {}, progress);
        if (!solved) return passOn(solved.error());
        state_.graph = std::move(*solved);
      }
      // Read back, so that a run that goes on and one that starts here see the same bits.
      const ordered_json data = jsonOf(*state_.graph);
      state_.graph = graphFrom(data);
      if (auto kept = store_.keep(nameOf(Step::graph), key, data); !kept) return kept;
    }
    const auto& suspects = state_.graph->suspects;
    for (std::size_t e = 0; e < pairOfEdge.size() && e < state_.graph->edges.size(); ++e) {
      PairOutcome& pair = state_.pairs[pairOfEdge[e]];
      pair.inGraph = state_.graph->edges[e];
      pair.wrong = pair.inGraph->wrong;
      pair.suspect = std::find(suspects.begin(), suspects.end(), e) != suspects.end();
    }
    state_.verdict = state_.graph->verdict;
    state_.reason = state_.graph->reason;
    include();
    return {};
  }

  [[nodiscard]] std::vector<registration::GraphNode> nodes() const {
    std::vector<registration::GraphNode> nodes;
    for (std::size_t v = 0; v < inputs_.size(); ++v) {
      registration::GraphNode node;
      node.name = project_.volumes[v].name;
      node.toWorld = project_.volumes[v].toWorld;
      node.priorCentre_mm = middleOf(inputs_[v].grid);
      if (isExact(v)) {
        node.fixed = true;
      } else if (project_.volumes[v].placement == Placement::tracker) {
        node.prior = evenCovariance(settings_.trackerError_mm, settings_.trackerError_deg);
      } else if (project_.volumes[v].placement == Placement::hand) {
        node.prior = evenCovariance(std::max(kHandError_mm, 3.0 * settings_.trackerError_mm),
                                    std::max(kHandError_deg, 3.0 * settings_.trackerError_deg));
      }
      nodes.push_back(std::move(node));
    }
    return nodes;
  }

  /// The largest part goes into the result; what nothing holds to it would lie anywhere.
  void include() {
    const auto& part = state_.graph->part;
    std::map<int, std::size_t> sizes;
    for (const int p : part) ++sizes[p];
    const int main = std::max_element(sizes.begin(), sizes.end(), [](const auto& a, const auto& b) { return a.second < b.second; })->first;
    included_.clear();
    for (std::size_t v = 0; v < inputs_.size(); ++v) (part[v] == main ? included_ : state_.leftOut).push_back(v);
  }

  [[nodiscard]] const glm::dmat4& poseOf(std::size_t v) const { return state_.graph->toWorld[v]; }

  /// The views that go into the result; all are in memory afterwards.
  Result<std::vector<View>> views(Progress& progress) {
    std::vector<View> views;
    for (const std::size_t v : included_) {
      auto loaded = load(v, progress);
      if (!loaded) return passOn(loaded.error());
      View view;
      view.volume = (*loaded)->volume.get();
      view.confidence = (*loaded)->confidence;
      view.toWorld = poseOf(v);
      if (v < state_.bends.size() && !state_.bends[v].displacement_mm.empty()) view.bend = &state_.bends[v];
      if (v < state_.corrections.size()) view.correction = state_.corrections[v];
      view.correction.beams = (*loaded)->beams;
      view.name = (*loaded)->name;
      views.push_back(std::move(view));
    }
    return views;
  }

  Result<void> equalise(Progress& progress) {
    if (auto fits = checkMemory(Step::equalise); !fits) return fits;
    const std::string& key = keys_[Step::equalise];
    state_.corrections.assign(inputs_.size(), {});
    auto found = readBack<std::vector<GreyCorrection>>(store_.find(nameOf(Step::equalise), key), [](const json& data) {
      std::vector<GreyCorrection> corrections;
      for (const auto& each : data.at("corrections")) corrections.push_back(correctionFrom(each));
      return corrections;
    });
    if (found && found->size() != inputs_.size()) found.reset();
    outcomeOf(Step::equalise).reused = found.has_value();
    if (found) {
      state_.corrections = std::move(*found);
      return {};
    }
    ordered_json data = {{"corrections", ordered_json::array()}};
    if (settings_.equalise && included_.size() > 1) {
      auto inputs = views(progress);
      if (!inputs) return passOn(inputs.error());
      EqualiseViewsOptions options;
      options.threads = options_.threads;
      auto equalised = equaliseViews(*inputs, options, progress);
      if (!equalised) return passOn(equalised.error());
      for (std::size_t n = 0; n < included_.size(); ++n) state_.corrections[included_[n]] = equalised->corrections[n];
      data["groups"] = equalised->groups;
      data["disagreement_before_db"] = equalised->disagreementBefore_db;
      data["disagreement_after_db"] = equalised->disagreementAfter_db;
      data["notes"] = equalised->notes;
    }
    for (const auto& correction : state_.corrections) data["corrections"].push_back(jsonOf(correction));
    return store_.keep(nameOf(Step::equalise), key, std::move(data));
  }

  [[nodiscard]] BendOptions bendOptions() const { return {.fallOff_mm = settings_.fallOff_mm, .threads = options_.threads}; }

  [[nodiscard]] bool isRejected(std::size_t fixed, std::size_t moving) const {
    return std::any_of(project_.pairs.begin(), project_.pairs.end(), [&](const ProjectPair& pair) {
      return pair.fixed == fixed && pair.moving == moving && pair.decision == Decision::rejected;
    });
  }

  /// An elastic pair from the poses of the graph.
  struct Bent {
    PairBend bend;
    BentPair about;
  };

  /// Both views are loaded.
  Result<Bent> bendPair(std::size_t f, std::size_t m, const Overlap& overlap, int threads, Progress& progress) {
    const glm::dmat4 start = startOf(f, m);
    ContentKey name = newKey("bend", kBendFormat);
    name.add(inputs_[f].key).add(inputs_[m].key).add(start).add(static_cast<int>(effortOf(project_, f, m)));
    const std::string key = name.text();
    const auto kept = [&]() -> std::optional<Bent> {
      auto bent = readBack<Bent>(store_.find(kBendStep, key), [](const json& data) {
        Bent read;
        read.about = bentFrom(data.at("outcome"));
        read.bend.fixedToMoving.rigid = matrixFrom(data.at("rigid"));
        read.bend.fixedToMoving.control.nodes = gridFrom(data.at("nodes"));
        return read;
      });
      if (!bent || !readVectors(kBendStep, key, "control.bin", bent->bend.fixedToMoving.control)) return std::nullopt;
      return named(std::move(*bent), f, m);
    };
    if (auto found = kept()) return std::move(*found);
    const PartOfView fixed = around(f, overlap.fixed), moving = around(m, overlap.moving);
    registration::ElasticOptions options = elasticOptions(f, m);
    options.threads = threads;
    auto made = registration::registerElastic(fixed.input(), moving.input(), start, options, progress, levelsOf(f, m));
    if (!made) {
      Error problem = made.error();
      if (problem.code != ErrorCode::cancelled)
        problem.sentence =
            "'" + project_.volumes[f].name + "' and '" + project_.volumes[m].name + "' could not be bent together. " + problem.sentence;
      return passOn(std::move(problem));
    }
    Bent bent;
    bent.about = {.effort = effortOf(project_, f, m),
                  .verdict = made->verdict,
                  .reason = std::move(made->reason),
                  .remarks = std::move(made->remarks),
                  .before = made->before,
                  .after = made->after,
                  .largestMotion_mm = made->largestMotion_mm,
                  .smallestJacobian = made->jacobian.smallest,
                  .levels = std::move(made->levels),
                  .seconds = made->seconds};
    ordered_json data = {{"fixed", project_.volumes[f].name},
                         {"moving", project_.volumes[m].name},
                         {"outcome", jsonOf(bent.about)},
                         {"rigid", jsonOf(made->fixedToMoving.rigid)},
                         {"nodes", jsonOf(made->fixedToMoving.control.nodes)}};
    if (auto w = writeVectors(kBendStep, key, "control.bin", made->fixedToMoving.control); !w) return passOn(w.error());
    if (auto k = store_.keep(kBendStep, key, std::move(data), {"control.bin"}); !k) return passOn(k.error());
    bent.bend.fixedToMoving = std::move(made->fixedToMoving);
    return named(std::move(bent), f, m);
  }

  static Bent named(Bent bent, std::size_t fixed, std::size_t moving) {
    bent.bend.fixed = bent.about.fixed = fixed;
    bent.bend.moving = bent.about.moving = moving;
    bent.bend.trust = bent.about.verdict == Verdict::aligned ? 1.0 : kUnconfirmed;
    return bent;
  }

  /// What a pair needs of a view. Without a coverage map black at a volume's border counts as outside, so such a volume stays whole.
  [[nodiscard]] PartOfView around(std::size_t v, const VoxelBox& box) const {
    const LoadedView& view = *inputs_[v].view;
    const Grid& grid = view.volume->grid;
    return partOf(view, view.volume->coverage.empty() ? VoxelBox{glm::ivec3(0), grid.dims} : widened(box, grid, kAround_mm));
  }

  [[nodiscard]] glm::dmat4 startOf(std::size_t f, std::size_t m) const { return rigidInverse(poseOf(m)) * poseOf(f); }

  Result<void> writeVectors(const char* step, const std::string& key, const std::string& name, const registration::ControlGrid& control) {
    if (auto room = store_.prepare(step); !room) return room;
    return files_.writeText(store_.fileOf(step, key, name), bytesOf(control.displacement_mm));
  }

  /// Fills the displacements of a lattice whose nodes are known, or leaves it without any when it bends nothing.
  bool readVectors(const char* step, const std::string& key, const std::string& name, registration::ControlGrid& control) const {
    const auto bytes = files_.readText(store_.fileOf(step, key, name));
    if (!bytes || bytes->size() % sizeof(glm::vec3) != 0) return false;
    control.displacement_mm.resize(bytes->size() / sizeof(glm::vec3));
    std::memcpy(static_cast<void*>(control.displacement_mm.data()), bytes->data(), bytes->size());
    return control.displacement_mm.empty() || control.displacement_mm.size() == control.nodes.voxelCount();
  }

  [[nodiscard]] bool readBends() {
    const std::string& key = keys_[Step::elastic];
    const auto data = store_.find(nameOf(Step::elastic), key);
    const bool read = readBack<bool>(data, [&](const json& about) {
                        const auto& views = about.at("views");
                        if (views.size() != inputs_.size()) return false;
                        state_.bends.assign(inputs_.size(), {});
                        for (std::size_t v = 0; v < inputs_.size(); ++v) {
                          if (views.at(v).is_null()) continue;
                          state_.bends[v].nodes = gridFrom(views.at(v));
                          if (!readVectors(nameOf(Step::elastic), key, std::to_string(v) + ".bin", state_.bends[v])) return false;
                        }
                        state_.bendSummary = {about.at("pairs").get<std::size_t>(), about.at("largest_mm").get<double>(),
                                              about.at("smallest_jacobian").get<double>(), about.at("disagreement_median_mm").get<double>(),
                                              about.at("disagreement_95_mm").get<double>()};
                        for (const auto& bent : about.at("bent")) {
                          state_.bentPairs.push_back(bentFrom(bent.at("outcome")));
                          state_.bentPairs.back().fixed = bent.at("fixed").get<std::size_t>();
                          state_.bentPairs.back().moving = bent.at("moving").get<std::size_t>();
                        }
                        return true;
                      }).value_or(false);
    if (!read) state_.bentPairs.clear();
    return read;
  }

  Result<void> elastic(Progress& progress) {
    if (auto fits = checkMemory(Step::elastic); !fits) return fits;
    StepOutcome& outcome = outcomeOf(Step::elastic);
    outcome.reused = readBends();
    if (outcome.reused) return {};
    state_.bends.assign(inputs_.size(), {});
    std::vector<PairBend> bends;
    if (settings_.elastic && included_.size() > 1) {
      for (const std::size_t v : included_)
        if (auto loaded = load(v, progress); !loaded) return passOn(loaded.error());
      struct Meeting {
        std::size_t f = 0;
        std::size_t m = 0;
        Overlap overlap;
        std::size_t voxels = 0;
        std::optional<Bent> bent = {};
      };
      std::vector<Meeting> meeting;
      std::vector<std::uint64_t> bytes;
      for (const std::size_t f : included_)
        for (const std::size_t m : included_) {
          if (f >= m || isRejected(f, m)) continue;
          if (progress.cancelRequested()) return cancelled();
          const auto overlap = overlapOf(*inputs_[f].view->volume, *inputs_[m].view->volume, startOf(f, m));
          if (!overlap) continue;
          meeting.push_back({f, m, *overlap, gridOf(inputs_[f].grid, overlap->fixed).voxelCount()});
          bytes.push_back(bendBytes(inputs_[f].grid, inputs_[m].grid, startOf(f, m), elasticOptions(f, m)));
        }
      // Large ones first, so that no thread is left alone with one in the end.
      std::vector<std::size_t> order(meeting.size());
      std::iota(order.begin(), order.end(), std::size_t{0});
      std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return meeting[a].voxels > meeting[b].voxels; });
      const int atOnce = besideEachOther_bytes(bytes).pairs;
      PartOfProgress bending(progress, 0.0, 0.9);
      const auto bent = besideEachOther(meeting.size(), atOnce, bending, [&](std::size_t n, Progress& part) -> Result<void> {
        Meeting& each = meeting[order[n]];
        part.report("Bending " + project_.volumes[each.f].name + " and " + project_.volumes[each.m].name, 0.0);
        auto made = bendPair(each.f, each.m, each.overlap, threadsOfEach(atOnce), part);
        if (!made) return passOn(made.error());
        each.bent = std::move(*made);
        return {};
      });
      if (!bent) return bent;
      for (Meeting& each : meeting) {
        bends.push_back(std::move(each.bent->bend));
        state_.bentPairs.push_back(std::move(each.bent->about));
      }
      PartOfProgress sharing(progress, 0.9, 1.0);
      if (auto shared = share(std::move(bends), sharing); !shared) return shared;
      state_.bendSummary.pairs = meeting.size();
    }
    return keepBends();
  }

  Result<void> share(std::vector<PairBend> bends, Progress& progress) {
    std::vector<const LoadedView*> views;
    std::vector<glm::dmat4> poses;
    std::vector<std::size_t> place(inputs_.size());
    for (std::size_t n = 0; n < included_.size(); ++n) {
      place[included_[n]] = n;
      views.push_back(inputs_[included_[n]].view.get());
      poses.push_back(poseOf(included_[n]));
    }
    for (PairBend& bend : bends) {
      bend.fixed = place[bend.fixed];
      bend.moving = place[bend.moving];
    }
    auto group = bendGroup(views, poses, bends, bendOptions(), progress);
    if (!group) return passOn(group.error());
    for (std::size_t n = 0; n < included_.size(); ++n) {
      state_.bends[included_[n]] = std::move(group->bends[n]);
      state_.bendSummary.largest_mm = std::max(state_.bendSummary.largest_mm, group->largest_mm[n]);
    }
    state_.bendSummary.smallestJacobian = group->smallestJacobian;
    state_.bendSummary.disagreementMedian_mm = group->disagreementMedian_mm;
    state_.bendSummary.disagreement95_mm = group->disagreement95_mm;
    return {};
  }

  Result<void> keepBends() {
    const std::string& key = keys_[Step::elastic];
    ordered_json data = {{"pairs", state_.bendSummary.pairs},
                         {"largest_mm", state_.bendSummary.largest_mm},
                         {"smallest_jacobian", state_.bendSummary.smallestJacobian},
                         {"disagreement_median_mm", state_.bendSummary.disagreementMedian_mm},
                         {"disagreement_95_mm", state_.bendSummary.disagreement95_mm},
                         {"views", ordered_json::array()},
                         {"bent", ordered_json::array()}};
    for (const auto& bent : state_.bentPairs)
      data["bent"].push_back({{"fixed", bent.fixed}, {"moving", bent.moving}, {"outcome", jsonOf(bent)}});
    std::vector<std::string> names;
    for (std::size_t v = 0; v < inputs_.size(); ++v) {
      const auto& bend = state_.bends[v];
      data["views"].push_back(bend.displacement_mm.empty() ? ordered_json(nullptr) : jsonOf(bend.nodes));
      if (bend.displacement_mm.empty()) continue;
      names.push_back(std::to_string(v) + ".bin");
      if (auto w = writeVectors(nameOf(Step::elastic), key, names.back(), bend); !w) return w;
    }
    return store_.keep(nameOf(Step::elastic), key, std::move(data), names);
  }

  Result<Grid> resultGrid() const {
    auto forecast = forecastJoin(placedGrids(), joinOptions());
    if (!forecast) return passOn(forecast.error());
    return forecast->grid;
  }

  Result<void> seam(Progress& progress) {
    if (auto fits = checkMemory(Step::seam); !fits) return fits;
    const std::string& key = keys_[Step::seam];
    if (auto found = readBack<SeamMap>(store_.find(nameOf(Step::seam), key), [](const json& data) {
          SeamMap map;
          map.cells = gridFrom(data.at("cells"));
          map.cutCost = data.at("cut_cost").get<double>();
          map.seamFaces = data.at("seam_faces").get<std::size_t>();
          for (const auto& box : data.at("levels")) {
            const auto begin = box.at("begin").get<std::array<int, 3>>(), size = box.at("size").get<std::array<int, 3>>();
            map.levels.push_back({{begin[0], begin[1], begin[2]}, {size[0], size[1], size[2]}, {}});
          }
          return map;
        })) {
      const auto cells = files_.readText(store_.fileOf(nameOf(Step::seam), key, "cells.bin"));
      bool whole = cells && (cells->empty() || cells->size() == found->cells.voxelCount());
      for (std::size_t n = 0; n < found->levels.size() && whole; ++n) {
        const auto offsets = files_.readText(store_.fileOf(nameOf(Step::seam), key, levelsName(n)));
        auto& levels = found->levels[n];
        levels.offset.resize(static_cast<std::size_t>(levels.size.x) * static_cast<std::size_t>(levels.size.y) *
                             static_cast<std::size_t>(levels.size.z));
        whole = offsets && offsets->size() == levels.offset.size() * sizeof(std::int16_t);
        if (whole) std::memcpy(levels.offset.data(), offsets->data(), offsets->size());
      }
      if (whole) {
        found->view.assign(cells->begin(), cells->end());
        outcomeOf(Step::seam).reused = true;
        takeSeams(std::move(*found));
        return {};
      }
    }
    auto inputs = views(progress);
    if (!inputs) return passOn(inputs.error());
    auto grid = resultGrid();
    if (!grid) return passOn(grid.error());
    auto map = findSeams(*inputs, *grid, joinOptions().seam, progress);
    if (!map) return passOn(map.error());
    if (auto room = store_.prepare(nameOf(Step::seam)); !room) return room;
    if (auto w = files_.writeText(store_.fileOf(nameOf(Step::seam), key, "cells.bin"), std::string(map->view.begin(), map->view.end())); !w)
      return w;
    ordered_json data = {
        {"cells", jsonOf(map->cells)}, {"cut_cost", map->cutCost}, {"seam_faces", map->seamFaces}, {"levels", ordered_json::array()}};
    std::vector<std::string> names = {"cells.bin"};
    for (std::size_t n = 0; n < map->levels.size(); ++n) {
      const auto& [begin, size, offset] = map->levels[n];
      data["levels"].push_back({{"begin", {begin.x, begin.y, begin.z}}, {"size", {size.x, size.y, size.z}}});
      names.push_back(levelsName(n));
      const std::string bytes(reinterpret_cast<const char*>(offset.data()), offset.size() * sizeof(std::int16_t));
      if (auto w = files_.writeText(store_.fileOf(nameOf(Step::seam), key, names.back()), bytes); !w) return w;
    }
    takeSeams(std::move(*map));
    return store_.keep(nameOf(Step::seam), key, std::move(data), names);
  }

  /// Of one of the views that go into the result.
  [[nodiscard]] static std::string levelsName(std::size_t view) { return "levels-" + std::to_string(view) + ".bin"; }

  /// Inside, views are counted among those that go into the result; outside, by their numbers in the project.
  void takeSeams(SeamMap map) {
    seams_ = std::move(map);
    state_.seams = seams_;
    for (auto& view : state_.seams->view)
      if (view > 0) view = static_cast<std::uint8_t>(included_[view - 1u] + 1);
    if (state_.seams->levels.empty()) return;
    state_.seams->levels.assign(inputs_.size(), {});
    for (std::size_t n = 0; n < included_.size(); ++n) state_.seams->levels[included_[n]] = seams_.levels[n];
  }

  // ---- the result ----

  static constexpr std::array<const char*, 3> kResultFiles = {"volume.mha", "coverage.mha", "source.mha"};

  /// Takes blocks and names sources by their numbers in the project.
  class Blocks : public BlockSink {
   public:
    explicit Blocks(const std::vector<std::size_t>& included) {
      for (std::size_t n = 0; n < included.size(); ++n) number_[n + 1] = static_cast<std::uint8_t>(included[n] + 1);
    }
    Result<void> put(const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> echo,
                     std::span<const std::uint8_t> coverage, std::span<const std::uint8_t> source) final {
      named_.resize(source.size());
      std::transform(source.begin(), source.end(), named_.begin(), [this](std::uint8_t n) { return number_[n]; });
      place(0, corner, size, echo);
      place(1, corner, size, coverage);
      place(2, corner, size, named_);
      return {};
    }

   protected:
    virtual void place(std::size_t which, const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values) = 0;

   private:
    std::array<std::uint8_t, 256> number_{};
    std::vector<std::uint8_t> named_;
  };

  class MemoryBlocks final : public Blocks {
   public:
    MemoryBlocks(const std::vector<std::size_t>& included, const Grid& grid) : Blocks(included) {
      for (auto& volume : made) volume = {grid, std::vector<std::uint8_t>(grid.voxelCount(), 0), {}};
    }
    std::array<Volume, 3> made;

   private:
    void place(std::size_t which, const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values) override {
      Volume& volume = made[which];
      const auto row = static_cast<std::size_t>(size.x);
      std::size_t from = 0;
      for (int k = 0; k < size.z; ++k)
        for (int j = 0; j < size.y; ++j, from += row)
          std::memcpy(volume.echo.data() + volume.grid.indexOf(corner.x, corner.y + j, corner.z + k), values.data() + from, row);
    }
  };

  class FileBlocks final : public Blocks {
   public:
    using Blocks::Blocks;
    std::array<std::unique_ptr<sdk::VolumeWriter>, 3> writers;

   private:
    void place(std::size_t which, const glm::ivec3& corner, const glm::ivec3& size, std::span<const std::uint8_t> values) override {
      writers[which]->put(corner, size, values);
    }
  };

  /// Joining measures its seams block by block; where the whole is at hand, nothing has to be left out at the blocks' edges.
  void measureWhole(const std::array<Volume, 3>& made, JoinReport& report) const {
    const SeamOptions& seam = settings_.join.seam;
    if (seam.method == SeamMethod::feather) return;
    const double step_db = report.seam.meanStep_db;
    report.seam = seamVisibility(made[0], made[2].echo, seam.blend_mm);
    if (seam.blend_mm > 0.0) report.seam.meanStep_db = step_db;  // that of the views: an edge of tissue is none
  }

  Result<JoinReport> makeResult(const std::string& key, Progress& progress) {
    const char* step = nameOf(Step::volume);
    auto inputs = views(progress);
    if (!inputs) return passOn(inputs.error());
    auto grid = resultGrid();
    if (!grid) return passOn(grid.error());
    if (auto room = store_.prepare(step); !room) return passOn(room.error());
    PartOfProgress joining(progress, 0.0, 0.8), writing(progress, 0.8, 1.0);
    const auto fileOf = [&](std::size_t which) { return store_.fileOf(step, key, kResultFiles[which]); };
    if (grid->voxelCount() > options_.streamAbove_voxels) {
      FileBlocks blocks(included_);
      for (std::size_t which = 0; which < 3; ++which) {
        auto writer = volumes_.writeInBlocks(*grid, fileOf(which));
        if (!writer) return passOn(writer.error());
        blocks.writers[which] = std::move(*writer);
      }
      auto report = join(*inputs, seams_, *grid, joinOptions(), blocks, joining);
      if (!report) return report;
      for (auto& writer : blocks.writers)
        if (auto finished = writer->finish(writing); !finished) return passOn(finished.error());
      return report;
    }
    MemoryBlocks blocks(included_, *grid);
    auto report = join(*inputs, seams_, *grid, joinOptions(), blocks, joining);
    if (!report) return report;
    measureWhole(blocks.made, *report);
    for (std::size_t which = 0; which < 3; ++which)
      if (auto w = volumes_.write(blocks.made[which], fileOf(which), writing); !w) return passOn(w.error());
    return report;
  }

  /// Whether the four files in the folder are those of this key.
  [[nodiscard]] bool resultIsThere(const std::string& key) const {
    const auto sizes = readBack<std::vector<std::uintmax_t>>(
        store_.find(nameOf(Step::volume), key), [](const json& data) { return data.at("bytes").get<std::vector<std::uintmax_t>>(); });
    if (!sizes || sizes->size() != kResultFiles.size()) return false;
    std::error_code error;
    for (std::size_t which = 0; which < kResultFiles.size(); ++which) {
      const fs::path waiting = store_.fileOf(nameOf(Step::volume), key, kResultFiles[which]);
      if (fs::exists(waiting, error)) continue;  // made, and not yet moved
      if (fs::file_size(folder_ / kResultFiles[which], error) != (*sizes)[which] || error) return false;
    }
    if (fs::exists(store_.fileOf(nameOf(Step::volume), key, "provenance.json"), error)) return true;
    const auto provenance = files_.readText(folder_ / "provenance.json");
    if (!provenance) return false;
    const json read = json::parse(*provenance, nullptr, false);
    return read.is_object() && read.contains("key") && read["key"] == key;
  }

  /// Moves a finished result to its names. The provenance goes first and comes last: with it the four belong together, whenever the program
  /// is stopped, and a run that finds them half moved goes on.
  Result<void> publish(const std::string& key) {
    const char* step = nameOf(Step::volume);
    std::error_code error;
    const auto moveIn = [&](const char* name) -> Result<void> {
      const fs::path from = store_.fileOf(step, key, name);
      if (!fs::exists(from, error)) return {};
      fs::rename(from, folder_ / name, error);
      if (error)
        return failure(ErrorCode::notWritable,
                       "'" + (folder_ / name).string() + "' cannot be written (" + error.message() + "); choose another folder.",
                       {{"file", (folder_ / name).string()}});
      return {};
    };
    if (fs::exists(store_.fileOf(step, key, "provenance.json"), error)) fs::remove(folder_ / "provenance.json", error);
    for (const char* name : kResultFiles)
      if (auto moved = moveIn(name); !moved) return moved;
    if (auto moved = moveIn("provenance.json"); !moved) return moved;
    state_.volume = folder_ / kResultFiles[0];
    state_.coverage = folder_ / kResultFiles[1];
    state_.source = folder_ / kResultFiles[2];
    state_.provenance = folder_ / "provenance.json";
    return {};
  }

  Result<void> volume(Progress& progress) {
    if (auto fits = checkMemory(Step::volume); !fits) return fits;
    const char* step = nameOf(Step::volume);
    const std::string& key = keys_[Step::volume];
    if (resultIsThere(key)) {
      auto report = readBack<JoinReport>(store_.find(step, key), [](const json& data) { return reportFrom(data.at("report")); });
      if (report) {
        outcomeOf(Step::volume).reused = true;
        state_.report = std::move(*report);
        return publish(key);
      }
    }
    store_.remove(step, key);
    auto report = makeResult(key, progress);
    if (!report) return passOn(report.error());
    for (const std::size_t v : state_.leftOut)
      report->notes.push_back("Volume '" + project_.volumes[v].name +
                              "' is not in the result: no pair that can be believed holds it to the others.");
    state_.report = std::move(*report);
    const std::string provenance = provenanceText(project_, state_, key);
    if (auto w = files_.writeText(store_.fileOf(step, key, "provenance.json"), provenance); !w) return w;
    // The sizes are kept beside the list of files, which are moved away.
    ordered_json data = {{"report", jsonOf(*state_.report)}, {"bytes", ordered_json::array()}};
    for (const char* name : kResultFiles) {
      std::error_code ignored;
      data["bytes"].push_back(fs::file_size(store_.fileOf(step, key, name), ignored));
    }
    if (progress.cancelRequested()) return cancelled();
    if (auto kept = store_.keep(step, key, std::move(data)); !kept) return kept;
    if (auto moved = publish(key); !moved) return moved;
    store_.removeAllBut(step, {key});
    std::vector<std::string> sweeps = {keys_[Step::reconstruct]};
    for (const Input& input : inputs_) sweeps.push_back(input.key);
    store_.removeAllBut(kSweepStep, sweeps);
    return {};
  }

  /// For what takes no time worth counting: it can be cancelled and says nothing.
  class Silent final : public Progress {
   public:
    explicit Silent(const Progress& whole) : whole_(whole) {}
    void report(std::string_view, double) override {}
    [[nodiscard]] bool cancelRequested() const override { return whole_.cancelRequested(); }

   private:
    const Progress& whole_;
  };

  const StitchProject& project_;
  const ProjectSettings& settings_;
  const fs::path& folder_;
  const ChainOptions& options_;
  sdk::Volumes& volumes_;
  sdk::Files& files_;
  StepStore& store_;
  FileContents contents_;
  Progress& progress_;
  Silent silent_{progress_};

  ChainState state_;
  std::vector<Input> inputs_;
  std::vector<Candidate> candidates_;
  Keys keys_;
  std::vector<Decision> decisions_;    ///< one per state_.pairs
  std::vector<std::size_t> included_;  ///< volumes that go into the result
  SeamMap seams_;                      ///< views counted among included_
  std::mutex onLevelGuard_;
};

}  // namespace

const char* nameOf(Step step) {
  switch (step) {
    case Step::reconstruct:
      return "reconstruct";
    case Step::equalise:
      return "equalise";
    case Step::rigid:
      return "rigid";
    case Step::graph:
      return "graph";
    case Step::elastic:
      return "elastic";
    case Step::seam:
      return "seam";
    case Step::volume:
      return "volume";
  }
  return "volume";
}

Result<ChainForecast> forecastChain(const StitchProject& project, const fs::path& folder, const ChainOptions& options,
                                    sdk::Volumes& volumes, sdk::Files& files) {
  StepStore store = StepStore::peek(folder, files);
  return Chain(project, folder, options, volumes, files, store, noProgress()).forecast();
}

Result<ChainState> runChain(const StitchProject& project, const fs::path& folder, const ChainOptions& options, sdk::Volumes& volumes,
                            sdk::Files& files, Progress& progress) {
  auto store = StepStore::open(folder, files);
  if (!store) return passOn(store.error());
  return Chain(project, folder, options, volumes, files, *store, progress).run();
}

}  // namespace ew::stitching
