#include "panel/stitch_session.h"

#include <QCryptographicHash>
#include <QPointer>
#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "ew/sdk/panel.h"
#include "ew/stitching/places.h"
#include "panel/session_parts.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using sdk::words;

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

fs::path StitchSession::workFolder() const {
  if (document_.file().empty()) return untitledFolder(recovery_.number());
  const std::string whole = fs::absolute(document_.file()).lexically_normal().string();
  const QByteArray name = QCryptographicHash::hash(QByteArray::fromStdString(whole), QCryptographicHash::Sha1).toHex().left(16);
  return folder_ / "work" / name.toStdString();
}

bool StitchSession::isBusy() {
  if (running_) Q_EMIT problem(tr("A step is still running; wait for it or cancel it."));
  return running_;
}

void StitchSession::matchAll(bool withoutPlaces) {
  if (project().volumes.size() < 2) {
    Q_EMIT problem(tr("Matching needs two volumes at least; add another one."));
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
  if (!(next == project())) edit(std::move(next), withoutPlaces ? tr("match without tracker") : tr("refine the poses"));
  run(Step::graph, withoutPlaces ? tr("Matching without tracker") : tr("Refining the poses"));
  if (running_) {
    Q_EMIT said(leftOut.isEmpty() ? QString()
                                  : tr("Not matched by their images, because you placed them by landmarks or accepted them by hand: %1.")
                                        .arg(leftOut.join(QStringLiteral(", "))));
  }
}

void StitchSession::run(Step until, const QString& title) {
  if (isBusy()) return;
  if (project().volumes.empty()) {
    Q_EMIT problem(tr("There is nothing to work on yet; add two volumes or more."));
    return;
  }
  Q_EMIT problem({});
  begin(until, title);
}

void StitchSession::takeUp() {
  std::error_code ignored;
  if (running_ || project().volumes.empty() || !fs::exists(workFolder() / "steps", ignored)) return;
  begin(std::nullopt, tr("Restoring previous results"));
}

void StitchSession::begin(std::optional<Step> until, const QString& title) {
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
  const QPointer<StitchSession> here(this);
  host_.jobs().start(
      title.toStdString(),
      [made, asked, options, until, &volumes = host_.volumes(), folder = workFolder(), reading = readingFolder()](Progress& progress) {
        std::error_code ignored;
        fs::create_directories(folder, ignored);
        if (until) takeUpRead(reading, folder);
        return makeChain(asked, folder, options, until, volumes, *made, progress);
      },
      [here, made, asked, until, number = projectNumber_](const Result<void>& outcome) {
        if (StitchSession* session = here.data()) session->finish(outcome, *made, asked, until.has_value(), number);
      });
  Q_EMIT changed();
  Q_EMIT levelsChanged();
}

void StitchSession::finish(const Result<void>& outcome, ChainMade& made, const StitchProject& asked, bool wasAsked, int number) {
  running_ = false;
  poll_.stop();
  inbox_.reset();
  const bool another = projectNumber_ != number;  // opened meanwhile: this is no answer about it
  if (!outcome && wasAsked) {
    say(outcome.error());
  } else if (!outcome) {  // nobody asked; a run will say it
    host_.log().info(outcome.error().sentence());
  } else if (made.any && !another) {
    for (const Message& note : made.state.notes) host_.log().warn(note.english());
    if (made.result) {
      const ChainState& state = made.state;
      result_ = made.result;
      resultFiles_ = {state.volume, state.coverage, state.source, state.level, state.provenance};
      resultAsked_ = asked;
    }
    settle(std::move(made.state), asked);
    if (wasAsked && isResultFresh()) Q_EMIT resultMade();
  }
  if (another) takeUp();
  Q_EMIT changed();
  Q_EMIT lookChanged();
  Q_EMIT levelsChanged();
  tell();
}

void StitchSession::settle(ChainState state, StitchProject asked) {
  foundKeys_.clear();
  for (std::size_t n = 0; n < asked.volumes.size(); ++n) {
    foundKeys_.push_back(keyOf(asked.volumes[n]));
    if (n < state.volumes.size() && state.volumes[n]) volumes_[foundKeys_.back()] = state.volumes[n];
  }
  turnedOutcomes_.clear();
  found_ = std::make_shared<const ChainState>(std::move(state));
  asked_ = std::move(asked);
  if (stage_ == Stage::elastic && !hasElastic()) stage_ = Stage::rigid;
  if (!found_->warps.empty() && hasElastic()) stage_ = Stage::elastic;
  afterChoice();
  fit();
  if (!found_->reason.empty() && found_->verdict != registration::Verdict::aligned) Q_EMIT said(words(found_->reason));
}

}  // namespace ew::stitching
