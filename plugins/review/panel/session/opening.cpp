#include "panel/session/opening.h"

#include "ew/assessment/step_metrics.h"

namespace ew::review {
namespace {

namespace fs = std::filesystem;

Result<fs::path> mannequinFileOf(const Case& opened) {
  auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  const std::string name = opened.mannequin.empty() ? std::string("adult.json") : opened.mannequin;
  std::error_code ignored;
  return fs::exists(opened.folder / name, ignored) ? opened.folder / name : *resources / "mannequin" / name;
}

std::optional<Scene> liveSceneOf(const ScanLog& log) {
  for (const ScanEvent& event : log.events())
    if (const auto* changed = std::get_if<SceneChanged>(&event.what); changed != nullptr && changed->scene.liveEchoes)
      return changed->scene;
  return std::nullopt;
}

}  // namespace

Result<void> Opening::run(Progress& progress) {
  Contents used;
  for (const Side side : kSides) {
    if (!choices[side]) continue;
    PartOfProgress part(progress, side == kReviewed ? 0.0 : 0.5, side == kReviewed ? 0.5 : 1.0);
    auto done = open(side, used, part);
    // What is reviewed is shown though what it is compared with cannot be opened.
    if (!done && (side == kReviewed || done.error().code == ErrorCode::cancelled)) return done;
    if (!done) problem = std::move(done.error());
  }
  contents = std::move(used);
  return {};
}

Result<void> Opening::open(Side side, Contents& used, Progress& progress) {
  PartOfProgress reading(progress, 0.0, 0.1), preparing(progress, 0.1, 0.8), looking(progress, 0.8, 1.0);
  auto scan = openScan(*choices[side], reading);
  if (!scan) return passOn(scan.error());
  const auto folder = caseOf(*scan, *shelf, libraryFolder());
  if (!folder) return passOn(folder.error());
  if (auto read = readCase(*folder, used, preparing); !read) return read;
  const auto& [home, held] = used.at(*folder);
  ScanSubject subject = subjectOf(home, held);
  if (choices[side]->watch) scan->recording.log = formedIn(scan->recording.log, subject.scene);
  ReviewScan made{std::make_shared<const ScanExcerpt>(std::move(*scan)), std::move(subject), {}, {}, nullptr, {}, {}};
  const ScanLog& log = made.scan->recording.log;
  if (const auto live = liveSceneOf(log); live && made.subject.tissue == nullptr && made.subject.canFormEchoes()) {
    auto tissue = recordedTissueOf(made.subject.voxels, *live, 0, preparing);
    if (!tissue) return passOn(tissue.error());
    made.subject.know(std::move(*tissue));
  }
  if (side == kReviewed || mannequin == nullptr)
    if (auto body = readMannequin(home, progress); !body) return body;
  if (auto seen = look(side, made, looking); !seen) return seen;
  if (auto measured = measure(home, held, made, progress); !measured) return measured;
  opened[side] = std::make_shared<const ReviewScan>(std::move(made));
  return {};
}

/// Contents that are known are used again, unless the case was edited since.
Result<void> Opening::readCase(const fs::path& folder, Contents& used, Progress& progress) const {
  if (used.count(folder) > 0) return {};
  auto named = loadCase(folder);
  if (!named) return passOn(named.error());
  if (const auto known = contents.find(folder); known != contents.end() && known->second.first == *named) {
    used.insert(*known);
    return {};
  }
  auto read = readContents(*named, progress);
  if (!read) return passOn(read.error());
  used.emplace(folder, std::pair(std::move(*named), std::move(*read)));
  return {};
}

/// Where the probe was, and what it saw.
Result<void> Opening::look(Side side, ReviewScan& made, Progress& progress) const {
  const ScanLog& log = made.scan->recording.log;
  made.path = skinPathOf(log, made.scan->part);
  made.planes = planeVisitsOf(log, made.scan->part);
  if (const auto& volume = made.subject.voxels.volume()) {
    const auto& other = opened[kReviewed];
    const bool isShared = side == kCompared && other && other->subject.voxels.volume() == volume;
    made.regions = isShared ? other->regions : std::make_shared<const VolumeRegions>(*volume, made.subject.placedGrid);
    auto seen = regionCoverageOf(*made.regions, log, made.scan->part, progress);
    if (!seen) return passOn(seen.error());
    made.seen = std::move(*seen);
  }
  return {};
}

Result<void> Opening::measure(const Case& home, const CaseContents& held, ReviewScan& made, Progress& progress) const {
  if (!step) return {};
  PartOfProgress silent(progress, 0.8, 0.8);
  auto truth = loadCaseTruth(home, silent);
  if (!truth && truth.error().code == ErrorCode::cancelled) return passOn(truth.error());
  const CaseGround ground(std::make_shared<const CaseTruth>(truth ? std::move(*truth) : CaseTruth{}), held.labels,
                          made.subject.placedLabels);
  const ScanLog log = logOfPart(made.scan->recording.log, made.scan->part);
  StepOutcome outcome = made.scan->choice.outcome.value_or(StepOutcome{});
  if (!made.scan->choice.outcome) {  // an expert's scan was judged by nobody
    outcome.stepId = step->id;
    outcome.seconds = made.scan->part.length_s();
  }
  auto metrics = ew::metricsOf({*step, outcome, &log}, ground, {}, silent);
  if (!metrics) return passOn(metrics.error());
  made.metrics = std::move(*metrics);
  return {};
}

Result<void> Opening::readMannequin(const Case& home, Progress& progress) {
  const auto file = mannequinFileOf(home);
  if (!file) return passOn(file.error());
  if (mannequin && *file == mannequinFile) return {};
  PartOfProgress silent(progress, 0.8, 0.8);
  auto loaded = bridge::loadMannequin(*file, {}, silent);
  if (!loaded) return passOn(loaded.error());
  mannequin = std::make_shared<const bridge::Mannequin>(std::move(*loaded));
  mannequinFile = *file;
  return {};
}

}  // namespace ew::review
