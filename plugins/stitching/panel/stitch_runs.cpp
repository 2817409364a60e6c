#include "panel/stitch_runs.h"

#include <QPointer>
#include <algorithm>
#include <mutex>
#include <system_error>
#include <utility>

#include "ew/core/memory.h"
#include "ew/stitching/places.h"
#include "ew/widgets/words.h"
#include "logic/stitch_document.h"
#include "panel/mosaic.h"
#include "panel/notices.h"
#include "panel/project_document.h"
#include "panel/project_files.h"

namespace ew::stitching {

/// What a run of the chain brought.
struct ChainMade {
  ChainState state;
  bool any = false;
  std::shared_ptr<const Volume> result;  ///< null: it did not come so far
};

/// Levels on their way from the working thread to the window's.
struct StitchRuns::Inbox {
  std::mutex mutex;
  std::vector<LevelSeen> levels;
};

namespace {

namespace fs = std::filesystem;

/// Sweeps were made volumes when they were read: the run takes these up instead of making them again. What does not work is made again.
void takeUpRead(const fs::path& reading, const fs::path& work) {
  const fs::path from = reading / "steps" / nameOf(Step::reconstruct), to = work / "steps" / nameOf(Step::reconstruct);
  std::error_code ignored;
  fs::create_directories(to, ignored);
  // A result counts once its .json lies there: these are looked for first and put there last, since another file may just be read.
  std::vector<fs::path> finished, beside;
  for (const bool first : {true, false})
    for (fs::directory_iterator at(from, ignored), end; at != end; at.increment(ignored)) {
      const fs::path name = at->path().filename();
      if ((name.extension() == ".json") == first && !name.string().starts_with('.')) (first ? finished : beside).push_back(name);
    }
  for (const auto* names : {&beside, &finished})
    for (const fs::path& name : *names) fs::create_hard_link(from / name, to / name, ignored);
}

/// Runs the chain as far as `until`, or as far as it was finished before, and reads the volume it made.
Result<void> makeChain(const StitchProject& asked, const fs::path& folder, ChainOptions options, std::optional<Step> until,
                       sdk::Volumes& volumes, ChainMade& made, Progress& progress) {
  std::optional<Step> last = until;
  if (!last) {  // as far as it was finished before
    auto known = forecastChain(asked, folder, options);
    if (!known) return passOn(known.error());
    for (const StepOutcome& step : known->steps)
      if (step.done) last = step.step;
    if (!last) return {};
  }
  options.until = *last;
  auto state = runChain(asked, folder, options, progress);
  if (!state) return passOn(state.error());
  made.state = std::move(*state);
  made.any = true;
  if (made.state.volume.empty()) return {};
  auto volume = volumes.read(made.state.volume, progress);
  if (!volume) return passOn(volume.error());
  if (!made.state.coverage.empty())
    if (auto covered = volumes.readCoverageInto(*volume, made.state.coverage, progress); !covered) return covered;
  made.result = std::make_shared<const Volume>(std::move(*volume));
  return {};
}

}  // namespace

StitchRuns::StitchRuns(sdk::Host& host, Notices& notices, ProjectDocument& document, StitchResults& results, Mosaic& mosaic)
    : host_(host), notices_(notices), document_(document), results_(results), mosaic_(mosaic) {
  poll_.setInterval(100);
  connect(&poll_, &QTimer::timeout, this, &StitchRuns::takeLevels);
}

const StitchProject& StitchRuns::project() const { return document_.project(); }

void StitchRuns::takeLevels() {
  if (!inbox_) return poll_.stop();
  std::vector<LevelSeen> arrived;
  {
    const std::lock_guard lock(inbox_->mutex);
    arrived.swap(inbox_->levels);
  }
  if (arrived.empty()) return;
  runningLevels_.insert(runningLevels_.end(), arrived.begin(), arrived.end());
  Q_EMIT levelsChanged();
}

bool StitchRuns::isBusy() {
  if (running_) Q_EMIT notices_.problem(tr("A step is still running; wait for it or cancel it."));
  return running_;
}

void StitchRuns::matchAll(bool withoutPlaces) {
  if (project().volumes.size() < 2) {
    Q_EMIT notices_.problem(tr("Matching needs two volumes at least; add another one."));
    return;
  }
  if (isBusy()) return;
  StitchProject next = project();
  if (withoutPlaces)
    for (ProjectVolume& volume : next.volumes) volume.placement = Placement::unknown;
  QStringList leftOut;
  for (ProjectPair pair : project().pairs) {
    if (pair.decision == Decision::rejected) continue;
    const bool isByHand = pair.method == PairMethod::byHand;
    const bool hasStart = pair.start.has_value() || pair.method == PairMethod::refine;
    if (!isByHand && pair.method != PairMethod::landmarks && !(withoutPlaces && hasStart)) continue;
    if (pair.method == PairMethod::landmarks || pair.decision == Decision::accepted) {
      leftOut << tr("%1 to %2").arg(words(letterOf(pair.fixed)), words(letterOf(pair.moving)));
      continue;
    }
    pair.method = PairMethod::automatic;
    if (withoutPlaces) pair.start.reset();  // else where a hand put it is where refining begins
    next = withPair(std::move(next), pair);
  }
  if (!(next == project())) document_.edit(std::move(next), withoutPlaces ? tr("match without tracker") : tr("refine the poses"));
  run(Step::graph, withoutPlaces ? tr("Matching without tracker") : tr("Refining the poses"));
  if (running_) {
    Q_EMIT notices_.said(leftOut.isEmpty()
                             ? QString()
                             : tr("Not matched by their images, because you placed them by landmarks or accepted them by hand: %1.")
                                   .arg(leftOut.join(QStringLiteral(", "))));
  }
}

void StitchRuns::run(Step until, const QString& title) {
  if (isBusy()) return;
  if (project().volumes.empty()) {
    Q_EMIT notices_.problem(tr("There is nothing to work on yet; add two volumes or more."));
    return;
  }
  Q_EMIT notices_.problem({});
  begin(until, title);
}

void StitchRuns::resume() {
  std::error_code ignored;
  if (running_ || project().volumes.empty() || !fs::exists(document_.workFolder() / "steps", ignored)) return;
  begin(std::nullopt, tr("Restoring previous results"));
}

void StitchRuns::begin(std::optional<Step> until, const QString& title) {
  document_.endMerging();
  running_ = true;
  runningLevels_.clear();
  runningKeys_.clear();
  for (const auto& line : project().volumes) runningKeys_.push_back(keyOf(line));
  inbox_ = std::make_shared<Inbox>();
  poll_.start();
  auto made = std::make_shared<ChainMade>();
  const StitchProject asked = project();
  ChainOptions options;
  options.keepVolumes = until.has_value();
  options.isFolderOwn = true;
  if (const auto free = availableMemory_bytes()) options.maxBytes = std::min(options.maxBytes, *free);
  options.onLevel = [inbox = inbox_](std::size_t fixed, std::size_t moving, const registration::Level& level) {
    const std::lock_guard lock(inbox->mutex);
    inbox->levels.push_back({fixed, moving, level});
  };
  const QPointer<StitchRuns> here(this);
  host_.jobs().start(
      title.toStdString(),
      [made, asked, options, until, &volumes = host_.volumes(), folder = document_.workFolder(),
       reading = document_.readingFolder()](Progress& progress) {
        std::error_code ignored;
        fs::create_directories(folder, ignored);
        if (until) takeUpRead(reading, folder);
        return makeChain(asked, folder, options, until, volumes, *made, progress);
      },
      [here, made, asked, until, number = document_.number()](const Result<void>& outcome) {
        if (StitchRuns* runs = here.data()) runs->finish(outcome, *made, asked, until.has_value(), number);
      });
  Q_EMIT begun();
  Q_EMIT levelsChanged();
}

void StitchRuns::finish(const Result<void>& outcome, ChainMade& made, const StitchProject& asked, bool wasAsked, int number) {
  running_ = false;
  poll_.stop();
  inbox_.reset();
  const bool another = document_.number() != number;  // opened meanwhile: this is no answer about it
  if (!outcome && wasAsked) {
    notices_.say(outcome.error());
  } else if (!outcome) {  // nobody asked; a run will say it
    host_.log().info(outcome.error().sentence());
  } else if (made.any && !another) {
    for (const Message& note : made.state.notes) host_.log().warn(note.english());
    if (made.result) mosaic_.take(made.result, made.state, asked);
    results_.settle(std::move(made.state), asked);
    const ChainState& found = *results_.found();
    if (!found.reason.empty() && found.verdict != registration::Verdict::aligned) Q_EMIT notices_.said(words(found.reason));
    if (wasAsked && mosaic_.isFresh()) Q_EMIT resultMade();
  }
  if (another) resume();
  Q_EMIT ended();
}

void StitchRuns::moveWork(const fs::path& before, const fs::path& after) {
  // Where that does not work it is only found again.
  std::error_code ignored;
  if (running_ || !fs::exists(before, ignored) || fs::exists(after, ignored)) return;
  fs::rename(before, after, ignored);
  if (ignored) return;
  results_.moveFiles(before, after);
  mosaic_.moveFiles(before, after);
}

std::vector<registration::Level> StitchRuns::levelsSeen(const VolumePair& pair, bool ofWarp) const {
  std::vector<registration::Level> seen;
  const auto at = [&](std::size_t volume) {
    return std::find(runningKeys_.begin(), runningKeys_.end(), keyOf(project().volumes[volume])) - runningKeys_.begin();
  };
  const auto fixed = static_cast<std::size_t>(at(pair.fixed));
  const auto moving = static_cast<std::size_t>(at(pair.moving));
  for (const LevelSeen& each : runningLevels_)
    if (std::minmax(each.fixed, each.moving) == std::minmax(fixed, moving) && (each.level.node_mm > 0.0) == ofWarp)
      seen.push_back(each.level);
  return seen;
}

std::vector<registration::Level> StitchRuns::levels(const std::optional<VolumePair>& pair) const {
  if (!pair) return {};
  auto seen = levelsSeen(*pair, false);
  if (!seen.empty()) return seen;
  const StitchResults::PairLine line = results_.pairLine(pair->fixed, pair->moving);
  return line.outcome != nullptr ? line.outcome->rigid.levels : seen;
}

std::vector<registration::Level> StitchRuns::warpLevels(const std::optional<VolumePair>& pair) const {
  if (!pair) return {};
  auto seen = levelsSeen(*pair, true);
  if (!seen.empty()) return seen;
  const PairDeformation* warped = results_.warpedOf(pair->fixed, pair->moving);
  return warped != nullptr ? warped->levels : seen;
}

}  // namespace ew::stitching
