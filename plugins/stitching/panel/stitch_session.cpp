#include "panel/stitch_session.h"

#include <QApplication>
#include <QCryptographicHash>
#include <QDateTime>
#include <QFileDialog>
#include <QLocale>
#include <QPointer>
#include <QStandardPaths>
#include <algorithm>
#include <cmath>
#include <mutex>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "ew/sdk/panel.h"
#include "logic/places.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using sdk::words;

constexpr int kKeepAfter_ms = 700;

fs::path dataFolder() {
  return fs::path(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString()) / "stitching";
}

/// What makes two lines of a project the same voxels.
std::string keyOf(const ProjectVolume& volume) {
  return volume.file.string() + '\n' + volume.coverage.string() + '\n' + volume.confidence.string() + '\n' + volume.calibration.string() +
         '\n' + std::to_string(volume.spacing_mm);
}

glm::dvec3 carried(const glm::dmat4& m, const glm::dvec3& p) { return glm::dvec3(m * glm::dvec4(p, 1.0)); }

glm::dvec3 middleOf(const Grid& grid) { return carried(grid.voxelToWorld().matrix, 0.5 * (glm::dvec3(grid.dims) - 1.0)); }

bool isProject(const fs::path& file) { return file.extension() == ".json"; }

Result<Volume> readOne(const ProjectVolume& line, const fs::path& folder, sdk::Volumes& volumes, sdk::Files& files, Progress& progress) {
  // A sweep is no volume yet: the chain's first step makes one of it, and says in a sentence what is wrong with what is neither.
  if (line.confidence.empty() && line.calibration.empty() && line.spacing_mm == 0.0) {
    auto volume = volumes.read(line.file, progress);
    if (volume && line.coverage.empty()) return volume;
    if (volume) {
      if (auto covered = volumes.readCoverageInto(*volume, line.coverage, progress); !covered) return passOn(covered.error());
      return volume;
    }
    if (volume.error().code == ErrorCode::cancelled || volume.error().code == ErrorCode::notFound) return volume;
    StitchProject one;
    one.volumes.push_back(line);
    ChainOptions options;
    options.until = Step::reconstruct;
    auto state = runChain(one, folder, options, volumes, files, progress);
    if (!state || state->volumes.empty() || !state->volumes.front()) return volume;
    return *state->volumes.front();
  }
  StitchProject one;
  one.volumes.push_back(line);
  ChainOptions options;
  options.until = Step::reconstruct;
  auto state = runChain(one, folder, options, volumes, files, progress);
  if (!state) return passOn(state.error());
  if (state->volumes.empty() || !state->volumes.front())
    return failure(ErrorCode::notReadable, "'" + line.file.string() + "' gave no volume; check what kind of file it is.");
  return *state->volumes.front();
}

}  // namespace

/// Levels on their way from the working thread to the window's.
struct StitchSession::Inbox {
  std::mutex mutex;
  std::vector<LevelSeen> levels;
};

StitchSession::StitchSession(sdk::Host& host, fs::path folder)
    : host_(host), folder_(folder.empty() ? dataFolder() : std::move(folder)), document_(host.files(), folder_ / "unsaved.json") {
  setObjectName(QStringLiteral("stitchSession"));
  keepSoon_.setSingleShot(true);
  keepSoon_.setInterval(kKeepAfter_ms);
  connect(&keepSoon_, &QTimer::timeout, this, &StitchSession::keep);
  poll_.setInterval(100);
  connect(&poll_, &QTimer::timeout, this, [this] {
    if (!inbox_) return poll_.stop();
    std::vector<LevelSeen> arrived;
    {
      const std::lock_guard lock(inbox_->mutex);
      arrived.swap(inbox_->levels);
    }
    if (arrived.empty()) return;
    running_levels_.insert(running_levels_.end(), arrived.begin(), arrived.end());
    Q_EMIT levelsChanged();
  });
  if (auto left = document_.leftBehind()) {
    left_ = std::move(*left);
  } else {
    host_.log().warn(left.error().sentence);
  }
}

StitchSession::~StitchSession() { keep(); }

void StitchSession::keep() {
  keepSoon_.stop();
  // While an offer stands, the file is the offer's.
  if (left_) return;
  if (auto kept = document_.keepRecovery(); !kept) host_.log().warn(kept.error().sentence);
}

std::shared_ptr<void> StitchSession::onChanged(std::function<void()> callback) {
  auto kept = std::make_shared<std::function<void()>>(std::move(callback));
  callbacks_.push_back(kept);
  return kept;
}

void StitchSession::tell() {
  std::erase_if(callbacks_, [](const auto& one) { return one.expired(); });
  const auto now = callbacks_;
  for (const auto& weak : now)
    if (const auto callback = weak.lock()) (*callback)();
}

void StitchSession::say(const Error& error) {
  if (error.code == ErrorCode::cancelled) return;  // the user knows
  host_.log().warn(error.sentence);
  Q_EMIT problem(words(error.sentence));
}

std::string StitchSession::title() const {
  const auto count = static_cast<int>(project().volumes.size());
  const QString name = document_.file().empty() ? QString() : words(document_.file().stem().string());
  if (count == 0 && name.isEmpty()) return tr("Stitching").toStdString();
  const QString subvolumes = count == 1 ? tr("1 subvolume") : tr("%1 subvolumes").arg(count);
  return (name.isEmpty() ? tr("Stitching: %1").arg(subvolumes) : tr("Stitching: %1, %2").arg(name, subvolumes)).toStdString();
}

std::string StitchSession::remark() const {
  if (project().volumes.empty()) return {};
  return document_.hasUnsavedChanges() ? tr("not saved").toStdString() : tr("saved").toStdString();
}

std::string StitchSession::note() const {
  const auto all = pairs();
  const auto seen = std::count_if(all.begin(), all.end(), [](const PairLine& line) { return line.outcome != nullptr; });
  const int look = pairsToLookAt();
  if (seen == 0) return {};
  return look == 0 ? tr("no pair needs a look").toStdString()
                   : tr("%1 of %2 pairs need a look").arg(look).arg(static_cast<int>(all.size())).toStdString();
}

void StitchSession::undo() {
  document_.undo();
  afterEdit();
}

void StitchSession::redo() {
  document_.redo();
  afterEdit();
}

void StitchSession::save(bool elsewhere) {
  if (project().volumes.empty()) {
    Q_EMIT problem(tr("The project has no volume yet; add one before it is saved."));
    return;
  }
  fs::path file = document_.file();
  if (file.empty() || elsewhere) {
    QString chosen = QFileDialog::getSaveFileName(QApplication::activeWindow(), tr("Save the stitch project"),
                                                  file.empty() ? QString() : words(file.string()), tr("Stitch projects (*.json)"));
    if (chosen.isEmpty()) return;
    if (!chosen.endsWith(QLatin1String(".json"))) chosen += QLatin1String(".json");
    file = chosen.toStdString();
  }
  saveAs(file);
}

bool StitchSession::saveAs(const fs::path& file) {
  const fs::path before = workFolder();
  if (auto saved = document_.save(file); !saved) {
    say(saved.error());
    return false;
  }
  left_.reset();
  // What was found goes along; where that does not work it is only found again.
  std::error_code ignored;
  const fs::path after = workFolder();
  if (before != after && !running_ && fs::exists(before, ignored) && !fs::exists(after, ignored)) {
    fs::rename(before, after, ignored);
    if (!ignored && found_) {
      auto state = std::make_shared<ChainState>(*found_);
      for (fs::path* path : {&state->volume, &state->coverage, &state->source, &state->provenance})
        if (!path->empty()) *path = after / path->lexically_relative(before);
      found_ = std::move(state);
    }
  }
  Q_EMIT problem({});
  Q_EMIT changed();
  tell();
  return true;
}

QString StitchSession::projectAsText() const { return words(projectText(project(), {})); }

QString StitchSession::verdictOf(int a, int b) const {
  const PairLine line = pairLine(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
  return line.outcome != nullptr ? QString::fromLatin1(registration::nameOf(line.outcome->rigid.verdict)) : QString();
}

QList<double> StitchSession::transformNow() const {
  QList<double> numbers;
  const glm::dmat4 matrix = transform();
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) numbers << matrix[column][row];
  return numbers;
}

void StitchSession::startAnew() {
  document_.clear();
  found_.reset();
  result_.reset();
  pair_.reset();
  chosenVolume_.reset();
  afterEdit();
}

void StitchSession::reopenLeft() {
  if (!left_) return;
  const auto left = std::exchange(left_, std::nullopt);
  document_.takeOver(*left);
  found_.reset();
  result_.reset();
  pair_.reset();
  afterEdit();
  readVolumes();
}

void StitchSession::discardLeft() {
  left_.reset();
  document_.forgetRecovery();
  Q_EMIT changed();
}

void StitchSession::edit(StitchProject next, const QString& what, const std::string& mergeKey) {
  if (left_) {
    // Whoever works on has decided; what was left is kept beside, so that this decision loses nothing either.
    std::error_code ignored;
    fs::rename(folder_ / "unsaved.json", folder_ / "unsaved-before.json", ignored);
    left_.reset();
  }
  document_.edit(std::move(next), what.toStdString(), mergeKey);
  afterEdit();
}

void StitchSession::afterEdit() {
  keepSoon_.start();
  const std::size_t count = project().volumes.size();
  if (chosenVolume_ && count == 0) chosenVolume_.reset();
  if (chosenVolume_ && *chosenVolume_ >= count) chosenVolume_ = count - 1;
  if (pair_ && pair_->moving >= count) pair_.reset();
  if (!pair_ && count >= 2) {
    pair_ = Shown{0, 1};
    if (const auto all = pairs(); !all.empty()) pair_ = Shown{all.front().fixed, all.front().moving};
    fit();
  }
  afterChoice();
  if (std::any_of(project().volumes.begin(), project().volumes.end(),
                  [&](const auto& line) { return volumes_.count(keyOf(line)) == 0 && unreadable_.count(keyOf(line)) == 0; }))
    readVolumes();
  Q_EMIT changed();
  Q_EMIT lookChanged();
  Q_EMIT levelsChanged();
  tell();
}

void StitchSession::afterChoice() {
  landmarkResult_.reset();
  const auto marks = landmarks();
  if (chosenLandmark_ >= static_cast<int>(marks.size())) chosenLandmark_ = static_cast<int>(marks.size()) - 1;
  if (marks.empty()) return;
  if (auto result = registration::registerLandmarks(marks)) landmarkResult_ = std::move(*result);
}

void StitchSession::addFiles(const std::vector<fs::path>& files) {
  Q_EMIT problem({});
  std::vector<ProjectVolume> lines;
  for (const auto& file : files) {
    if (isProject(file)) {
      if (project().volumes.empty() && files.size() == 1) {
        openProject(file);
        return;
      }
      auto text = host_.files().readText(file);
      if (!text) {
        say(text.error());
        continue;
      }
      auto other = parseProject(*text, file.parent_path(), host_.files());
      if (!other) {
        say(other.error());
        continue;
      }
      lines.insert(lines.end(), other->volumes.begin(), other->volumes.end());
    } else {
      ProjectVolume line;
      line.file = file;
      line.name = file.stem().string();
      lines.push_back(std::move(line));
    }
  }
  if (lines.empty()) return;
  // Read before they are added: a file that is no volume never becomes a line.
  auto read = std::make_shared<std::vector<std::pair<ProjectVolume, std::shared_ptr<const Volume>>>>();
  const QPointer<StitchSession> here(this);
  const QString what = lines.size() == 1 ? tr("Reading %1").arg(words(lines.front().name))
                                         : tr("Reading %n volumes", nullptr, static_cast<int>(lines.size()));
  auto& volumes = host_.volumes();
  auto& texts = host_.files();
  host_.jobs().start(
      what.toStdString(),
      [read, lines, &volumes, &texts, folder = folder_ / "work" / "reading"](Progress& progress) -> Result<void> {
        const double share = 1.0 / static_cast<double>(lines.size());
        std::optional<Error> first;
        for (std::size_t n = 0; n < lines.size(); ++n) {
          PartOfProgress part(progress, share * static_cast<double>(n), share * static_cast<double>(n + 1));
          part.report(lines[n].name, 0.0);
          auto volume = readOne(lines[n], folder, volumes, texts, part);
          if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "Reading was cancelled.");
          if (volume) {
            read->emplace_back(lines[n], std::make_shared<const Volume>(std::move(*volume)));
          } else if (!first) {
            first = volume.error();
          }
        }
        if (first) return passOn(*first);
        return {};
      },
      [here, read](const Result<void>& outcome) {
        StitchSession* session = here.data();
        if (session == nullptr) return;
        std::vector<ProjectVolume> added;
        for (auto& [line, volume] : *read) {
          session->volumes_[keyOf(line)] = volume;
          added.push_back(line);
        }
        if (!added.empty()) {
          const QString step = added.size() == 1 ? tr("add %1").arg(words(added.front().name))
                                                 : tr("add %n volumes", nullptr, static_cast<int>(added.size()));
          session->edit(withVolumes(session->project(), std::move(added)), step);
        }
        if (!outcome) session->say(outcome.error());
      });
}

bool StitchSession::openProject(const fs::path& file) {
  Q_EMIT problem({});
  if (auto opened = document_.open(file); !opened) {
    say(opened.error());
    return false;
  }
  left_.reset();
  found_.reset();
  result_.reset();
  pair_.reset();
  chosenVolume_.reset();
  unreadable_.clear();
  afterEdit();
  return true;
}

void StitchSession::readVolumes() {
  if (reading_) return;
  std::vector<ProjectVolume> lines;
  for (const auto& line : project().volumes)
    if (volumes_.count(keyOf(line)) == 0 && unreadable_.count(keyOf(line)) == 0) lines.push_back(line);
  if (lines.empty()) return;
  reading_ = true;
  struct Read {
    std::vector<std::pair<std::string, std::shared_ptr<const Volume>>> volumes;  ///< null: it cannot be read
    std::optional<Error> first;
  };
  auto read = std::make_shared<Read>();
  const QPointer<StitchSession> here(this);
  auto& volumes = host_.volumes();
  auto& texts = host_.files();
  host_.jobs().start(
      tr("Reading %n volumes", nullptr, static_cast<int>(lines.size())).toStdString(),
      [read, lines, &volumes, &texts, folder = folder_ / "work" / "reading"](Progress& progress) -> Result<void> {
        const double share = 1.0 / static_cast<double>(lines.size());
        for (std::size_t n = 0; n < lines.size(); ++n) {
          PartOfProgress part(progress, share * static_cast<double>(n), share * static_cast<double>(n + 1));
          part.report(lines[n].name, 0.0);
          auto volume = readOne(lines[n], folder, volumes, texts, part);
          if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "Reading was cancelled.");
          if (!volume && !read->first) read->first = volume.error();
          read->volumes.emplace_back(keyOf(lines[n]), volume ? std::make_shared<const Volume>(std::move(*volume)) : nullptr);
        }
        return {};
      },
      [here, read, lines](const Result<void>& outcome) {
        StitchSession* session = here.data();
        if (session == nullptr) return;
        session->reading_ = false;
        for (const auto& [key, volume] : read->volumes) {
          if (volume)
            session->volumes_[key] = volume;
          else
            session->unreadable_.insert(key);
        }
        if (!outcome)  // cancelled: not asked again until the file is added anew
          for (const auto& line : lines)
            if (session->volumes_.count(keyOf(line)) == 0) session->unreadable_.insert(keyOf(line));
        if (read->first) session->say(*read->first);
        session->fit();
        session->afterEdit();
      });
}

std::shared_ptr<const Volume> StitchSession::volume(std::size_t index) const {
  if (index >= project().volumes.size()) return nullptr;
  const auto at = volumes_.find(keyOf(project().volumes[index]));
  return at != volumes_.end() ? at->second : nullptr;
}

bool StitchSession::isUnreadable(std::size_t index) const {
  return index < project().volumes.size() && unreadable_.count(keyOf(project().volumes[index])) != 0;
}

fs::path StitchSession::workFolder() const {
  const std::string name =
      document_.file().empty()
          ? std::string("untitled")
          : QCryptographicHash::hash(QByteArray::fromStdString(fs::absolute(document_.file()).lexically_normal().string()),
                                     QCryptographicHash::Sha1)
                .toHex()
                .left(16)
                .toStdString();
  return folder_ / "work" / name;
}

std::optional<std::size_t> StitchSession::foundIndex(std::size_t index) const {
  if (!found_ || index >= project().volumes.size()) return std::nullopt;
  const auto at = std::find(foundKeys_.begin(), foundKeys_.end(), keyOf(project().volumes[index]));
  if (at == foundKeys_.end()) return std::nullopt;
  return static_cast<std::size_t>(at - foundKeys_.begin());
}

bool StitchSession::samePlaces(std::size_t index) const {
  const auto at = foundIndex(index);
  if (!at || *at >= asked_.volumes.size()) return false;
  const ProjectVolume& before = asked_.volumes[*at];
  const ProjectVolume& now = project().volumes[index];
  return before.placement == now.placement && before.toWorld == now.toWorld;
}

bool StitchSession::isFoundFresh() const { return found_ && asked_ == project(); }

StitchSession::PairLine StitchSession::pairLine(std::size_t a, std::size_t b) const {
  const auto [low, high] = std::minmax(a, b);
  PairLine line{low, high};
  const auto i = foundIndex(low);
  const auto j = foundIndex(high);
  if (i && j) {
    for (const PairOutcome& outcome : found_->pairs) {
      if (outcome.fixed != *i || outcome.moving != *j) continue;
      line.outcome = &outcome;
      break;
    }
  }
  const ProjectPair said = pairOf(project(), low, high);
  if (line.outcome != nullptr) {
    ProjectPair before = pairOf(asked_, *i, *j);
    before.fixed = low;
    before.moving = high;
    before.decision = said.decision;
    line.stale = !(before == said) || !samePlaces(low) || !samePlaces(high);
    line.wrong = line.outcome->wrong;
    switch (line.outcome->rigid.verdict) {
      case registration::Verdict::aligned:
        line.mark = line.wrong ? Mark::notAligned : Mark::aligned;
        break;
      case registration::Verdict::cannotTell:
        line.mark = Mark::cannotTell;
        break;
      case registration::Verdict::notAligned:
        line.mark = Mark::notAligned;
        break;
    }
  }
  if (said.decision == Decision::rejected) line.mark = Mark::rejected;
  line.needsLook = line.outcome != nullptr && said.decision == Decision::undecided && (line.stale || line.mark != Mark::aligned);
  return line;
}

std::vector<StitchSession::PairLine> StitchSession::pairs() const {
  const std::size_t count = project().volumes.size();
  std::vector<PairLine> lines;
  const bool any = found_ && !found_->pairs.empty();
  for (std::size_t a = 0; a < count; ++a) {
    for (std::size_t b = a + 1; b < count; ++b) {
      PairLine line = pairLine(a, b);
      ProjectPair nothing;
      nothing.fixed = a;
      nothing.moving = b;
      const bool isNew = any && (!foundIndex(a) || !foundIndex(b));
      if (line.outcome != nullptr || !(pairOf(project(), a, b) == nothing) || ((!any || isNew) && count <= 12) ||
          (pair_ && *pair_ == Shown{a, b}))
        lines.push_back(line);
    }
  }
  return lines;
}

StitchSession::Mark StitchSession::markOf(std::size_t index) const {
  Mark best = Mark::unknown;
  const auto rank = [](Mark mark) {
    switch (mark) {
      case Mark::aligned:
        return 4;
      case Mark::cannotTell:
        return 3;
      case Mark::notAligned:
        return 2;
      case Mark::rejected:
        return 1;
      case Mark::unknown:
        return 0;
    }
    return 0;
  };
  for (std::size_t other = 0; other < project().volumes.size(); ++other) {
    if (other == index) continue;
    const PairLine line = pairLine(index, other);
    if (line.outcome != nullptr && rank(line.mark) > rank(best)) best = line.mark;
  }
  return best;
}

int StitchSession::pairsToLookAt() const {
  const auto all = pairs();
  return static_cast<int>(std::count_if(all.begin(), all.end(), [](const PairLine& line) { return line.needsLook; }));
}

const glm::dmat4* StitchSession::foundPlace(std::size_t index) const {
  const auto at = foundIndex(index);
  return at && found_->graph && *at < found_->graph->toWorld.size() && samePlaces(index) ? &found_->graph->toWorld[*at] : nullptr;
}

glm::dmat4 StitchSession::placedToShown(std::size_t index) const {
  for (std::size_t other = 0; other < project().volumes.size(); ++other) {
    if (other == index) continue;
    if (const glm::dmat4* place = foundPlace(other)) return *place * rigidInverse(project().volumes[other].toWorld);
  }
  return glm::dmat4(1.0);
}

glm::dmat4 StitchSession::toWorld(std::size_t index) const {
  if (index >= project().volumes.size()) return glm::dmat4(1.0);
  if (const glm::dmat4* place = foundPlace(index)) return *place;
  return placedToShown(index) * project().volumes[index].toWorld;
}

void StitchSession::setPlace(std::size_t index, const glm::dmat4& shown, const QString& what, const std::string& mergeKey) {
  edit(withPlace(project(), index, rigidInverse(placedToShown(index)) * shown, Placement::hand), what, mergeKey);
}

void StitchSession::setPlacement(std::size_t index, Placement placement) {
  if (index >= project().volumes.size()) return;
  const QString name = words(letterOf(index));
  edit(withPlace(project(), index, project().volumes[index].toWorld, placement),
       placement == Placement::unknown   ? tr("forget the place of %1").arg(name)
       : placement == Placement::tracker ? tr("believe the tracker about %1").arg(name)
                                         : tr("take the place of %1 as a start").arg(name));
}

void StitchSession::choosePair(std::size_t a, std::size_t b) {
  if (a == b || std::max(a, b) >= project().volumes.size()) return;
  const auto [low, high] = std::minmax(a, b);
  const Shown next{low, high};
  if (pair_ == next) return;
  pair_ = next;
  chosenLandmark_ = -1;
  pickedFixed_.reset();
  pickedMoving_.reset();
  document_.endMerging();
  afterChoice();
  fit();
  Q_EMIT changed();
  Q_EMIT levelsChanged();
}

void StitchSession::chooseVolume(std::size_t index) {
  if (index >= project().volumes.size() || chosenVolume_ == index) return;
  chosenVolume_ = index;
  if (pair_ && pair_->fixed != index && pair_->moving != index && project().volumes.size() > 1) {
    // The first pair of it that was looked at, so that list and views speak of the same thing.
    for (const PairLine& line : pairs())
      if (line.fixed == index || line.moving == index) return choosePair(line.fixed, line.moving);
  }
  Q_EMIT changed();
}

void StitchSession::chooseLandmark(int landmark) {
  const auto marks = landmarks();
  if (landmark < 0 || landmark >= static_cast<int>(marks.size())) return;
  chosenLandmark_ = landmark;
  const auto& mark = marks[static_cast<std::size_t>(landmark)];
  setCross(mark.fixed_mm);
  if (!linked_) setMovingCross(mark.moving_mm);
  Q_EMIT changed();
}

void StitchSession::setStage(Stage stage) {
  if (stage_ == stage || (stage == Stage::elastic && !hasElastic())) return;
  stage_ = stage;
  Q_EMIT lookChanged();
}

bool StitchSession::hasElastic() const {
  if (!found_ || !pair_ || found_->bends.empty() || !found_->graph) return false;
  const auto i = foundIndex(pair_->fixed);
  const auto j = foundIndex(pair_->moving);
  return i && j && *i < found_->bends.size() && *j < found_->bends.size() && *i < found_->graph->toWorld.size() &&
         *j < found_->graph->toWorld.size() && samePlaces(pair_->fixed) && samePlaces(pair_->moving);
}

glm::dmat4 StitchSession::startTransform() const {
  if (!pair_) return glm::dmat4(1.0);
  return rigidInverse(project().volumes[pair_->moving].toWorld) * project().volumes[pair_->fixed].toWorld;
}

glm::dmat4 StitchSession::transform() const {
  if (!pair_) return glm::dmat4(1.0);
  const ProjectPair said = pairOf(project(), pair_->fixed, pair_->moving);
  const PairLine line = pairLine(pair_->fixed, pair_->moving);
  if (said.start && (said.method == PairMethod::byHand || line.outcome == nullptr || line.stale)) return *said.start;
  if (said.method == PairMethod::landmarks && landmarkResult_ && landmarkResult_->verdict != registration::Verdict::cannotTell &&
      (line.outcome == nullptr || line.stale))
    return landmarkResult_->fixedToMoving;
  if (line.outcome != nullptr) return line.outcome->rigid.fixedToMoving;
  return startTransform();
}

Mapping StitchSession::fixedMapping(Stage stage) const {
  if (stage != Stage::elastic || !hasElastic()) return {};
  const std::size_t i = *foundIndex(pair_->fixed);
  const glm::dmat4& world = found_->graph->toWorld[i];
  return {world, &found_->bends[i], rigidInverse(world)};
}

Mapping StitchSession::movingMapping(Stage stage) const {
  if (!pair_) return {};
  if (stage == Stage::elastic && hasElastic()) {
    const std::size_t i = *foundIndex(pair_->fixed);
    const std::size_t j = *foundIndex(pair_->moving);
    return {found_->graph->toWorld[i], &found_->bends[j], rigidInverse(found_->graph->toWorld[j])};
  }
  return {glm::dmat4(1.0), nullptr, stage == Stage::start ? startTransform() : transform()};
}

Plane StitchSession::movingPlane() const {
  return linked_ ? moved(plane_, movingMapping(stage_).toGrid * movingMapping(stage_).toBend) : movingPlane_;
}

glm::dvec3 StitchSession::movingCross() const { return linked_ ? movingMapping(stage_)(cross_) : movingCross_; }

void StitchSession::setPlane(const Plane& plane) {
  plane_ = plane;
  Q_EMIT lookChanged();
}

void StitchSession::setCross(const glm::dvec3& p_mm) {
  cross_ = p_mm;
  const double off = distanceTo(plane_, p_mm);
  if (std::abs(off) > 1e-9) plane_.centre_mm += off * plane_.normal();
  Q_EMIT lookChanged();
}

void StitchSession::setMovingPlane(const Plane& plane) {
  if (linked_) {
    const Mapping mapping = movingMapping(stage_);
    return setPlane(moved(plane, rigidInverse(mapping.toGrid * mapping.toBend)));
  }
  movingPlane_ = plane;
  Q_EMIT lookChanged();
}

void StitchSession::setMovingCross(const glm::dvec3& p_mm) {
  if (linked_) {
    const Mapping mapping = movingMapping(stage_);
    return setCross(carried(rigidInverse(mapping.toGrid * mapping.toBend), p_mm));
  }
  movingCross_ = p_mm;
  const double off = distanceTo(movingPlane_, p_mm);
  if (std::abs(off) > 1e-9) movingPlane_.centre_mm += off * movingPlane_.normal();
  Q_EMIT lookChanged();
}

void StitchSession::setLinked(bool linked) {
  if (linked_ == linked) return;
  if (!linked) {
    movingPlane_ = movingPlane();
    movingCross_ = movingCross();
    // Where the two do not overlap yet, a view of nothing helps nobody.
    if (pair_) {
      if (const auto moving = volume(pair_->moving)) {
        const Bounds box = boundsOf(moving->grid);
        if (glm::any(glm::lessThan(movingCross_, box.lowest_mm)) || glm::any(glm::greaterThan(movingCross_, box.highest_mm))) {
          movingCross_ = middleOf(moving->grid);
          movingPlane_.centre_mm = movingCross_;
        }
      }
    }
  }
  linked_ = linked;
  Q_EMIT lookChanged();
  Q_EMIT changed();
}

void StitchSession::setCut(Cut cut) {
  plane_ = planeOf(cut, cross_, plane_.pixel_mm);
  if (!linked_) movingPlane_ = planeOf(cut, movingCross_, movingPlane_.pixel_mm);
  Q_EMIT lookChanged();
}

void StitchSession::setViewSide(int px) {
  px = std::max(40, px);
  if (px == viewSide_px_) return;
  const double factor = static_cast<double>(viewSide_px_) / px;
  viewSide_px_ = px;
  plane_.pixel_mm *= factor;
  movingPlane_.pixel_mm *= factor;
  Q_EMIT lookChanged();
}

void StitchSession::fit() {
  if (!pair_) return;
  const auto fixed = volume(pair_->fixed);
  const auto moving = volume(pair_->moving);
  const Volume* any = fixed ? fixed.get() : moving.get();
  if (any == nullptr) return;
  const Grid& grid = any->grid;
  glm::dvec3 middle = middleOf(grid);
  if (fixed && moving) {
    // The middle of what both cover: where there is something to compare.
    const glm::dmat4 toVoxel = moving->grid.worldToVoxel().matrix * transform();
    glm::dvec3 sum{0.0};
    int count = 0;
    constexpr int kSide = 16;
    for (int n = 0; n < kSide * kSide * kSide; ++n) {
      const glm::dvec3 share = glm::dvec3(n % kSide, (n / kSide) % kSide, n / kSide / kSide) / (kSide - 1.0);
      const glm::ivec3 at = glm::ivec3(glm::round(share * (glm::dvec3(grid.dims) - 1.0)));
      if (fixed->coverageAt(grid.indexOf(at.x, at.y, at.z)) == Coverage::absent) continue;
      const glm::dvec3 p = carried(grid.voxelToWorld().matrix, glm::dvec3(at));
      const glm::ivec3 other = glm::ivec3(glm::round(carried(toVoxel, p)));
      if (!moving->grid.contains(other) || moving->coverageAt(moving->grid.indexOf(other.x, other.y, other.z)) == Coverage::absent)
        continue;
      sum += p;
      ++count;
    }
    if (count > 0) middle = sum / static_cast<double>(count);
  }
  const glm::dvec3 extent = glm::dvec3(grid.dims) * grid.spacing_mm;
  const double pixel_mm = std::max({extent.x, extent.y, extent.z, 1.0}) / (0.96 * viewSide_px_);
  plane_.centre_mm = middle;
  plane_.pixel_mm = pixel_mm;
  cross_ = middle;
  movingPlane_ = moved(plane_, transform());
  if (moving) {
    movingCross_ = middleOf(moving->grid);
    movingPlane_.centre_mm = movingCross_;
  }
  Q_EMIT lookChanged();
}

QString StitchSession::nameOfPair() const {
  return pair_ ? tr("%1 to %2").arg(words(letterOf(pair_->fixed)), words(letterOf(pair_->moving))) : QString();
}

void StitchSession::editPair(const std::function<void(ProjectPair&)>& change, const QString& what, const std::string& mergeKey) {
  if (!pair_) return;
  ProjectPair pair = pairOf(project(), pair_->fixed, pair_->moving);
  change(pair);
  edit(withPair(project(), pair), what, mergeKey);
}

std::vector<registration::LandmarkPair> StitchSession::landmarks() const {
  return pair_ ? pairOf(project(), pair_->fixed, pair_->moving).landmarks : std::vector<registration::LandmarkPair>{};
}

void StitchSession::pick(bool moving, const glm::dvec3& p_mm) {
  if (!pair_) return;
  (moving ? pickedMoving_ : pickedFixed_) = p_mm;
  if (!pickedFixed_ || !pickedMoving_) {
    Q_EMIT lookChanged();
    Q_EMIT changed();
    return;
  }
  const registration::LandmarkPair mark{tr("place %1").arg(landmarks().size() + 1).toStdString(), *pickedFixed_, *pickedMoving_};
  pickedFixed_.reset();
  pickedMoving_.reset();
  chosenLandmark_ = static_cast<int>(landmarks().size());
  editPair([&](ProjectPair& pair) { pair.landmarks.push_back(mark); },
           tr("landmark %1 of %2").arg(landmarks().size() + 1).arg(nameOfPair()));
}

void StitchSession::dropPick() {
  pickedFixed_.reset();
  pickedMoving_.reset();
  Q_EMIT lookChanged();
  Q_EMIT changed();
}

void StitchSession::removeLandmark(int landmark) {
  const auto marks = landmarks();
  if (landmark < 0 || landmark >= static_cast<int>(marks.size())) return;
  editPair([&](ProjectPair& pair) { pair.landmarks.erase(pair.landmarks.begin() + landmark); },
           tr("remove landmark %1").arg(words(marks[static_cast<std::size_t>(landmark)].name)));
}

void StitchSession::renameLandmark(int landmark, const QString& name) {
  const auto marks = landmarks();
  if (landmark < 0 || landmark >= static_cast<int>(marks.size())) return;
  if (name.trimmed().isEmpty()) {
    Q_EMIT problem(tr("A landmark needs a name; type one."));
    Q_EMIT changed();
    return;
  }
  editPair([&](ProjectPair& pair) { pair.landmarks[static_cast<std::size_t>(landmark)].name = name.trimmed().toStdString(); },
           tr("call landmark %1 '%2'").arg(landmark + 1).arg(name.trimmed()));
}

void StitchSession::useLandmarks() {
  if (isBusy()) return;
  if (landmarks().size() < 3) {
    Q_EMIT problem(tr("Three places that do not lie on one line are needed; mark %n more in both volumes.", nullptr,
                      3 - static_cast<int>(landmarks().size())));
    return;
  }
  editPair(
      [](ProjectPair& pair) {
        pair.method = PairMethod::landmarks;
        pair.start.reset();
        pair.decision = Decision::undecided;
      },
      tr("bring %1 together by landmarks").arg(nameOfPair()));
  run(Step::graph, tr("Matching %1 by landmarks").arg(nameOfPair()));
}

void StitchSession::setDecision(Decision decision) {
  if (!pair_) return;
  const Decision before = pairOf(project(), pair_->fixed, pair_->moving).decision;
  const Decision next = before == decision ? Decision::undecided : decision;
  const QString what = next == Decision::accepted   ? tr("accept %1").arg(nameOfPair())
                       : next == Decision::rejected ? tr("reject %1").arg(nameOfPair())
                                                    : tr("decide nothing about %1").arg(nameOfPair());
  editPair([&](ProjectPair& pair) { pair.decision = next; }, what);
}

void StitchSession::setTransform(const glm::dmat4& fixedToMoving, const QString& what, const std::string& mergeKey) {
  editPair(
      [&](ProjectPair& pair) {
        pair.start = fixedToMoving;
        pair.method = PairMethod::byHand;
        if (pair.decision == Decision::rejected) pair.decision = Decision::undecided;
      },
      what, mergeKey);
}

void StitchSession::nudge(const glm::dvec3& shift_mm, const glm::dvec3& turn_deg) {
  if (!pair_) return;
  const glm::dmat3 axes(plane_.right, plane_.down, plane_.normal());
  const bool shifts = shift_mm != glm::dvec3(0.0);
  const glm::dmat4 next = nudged(transform(), axes * shift_mm, axes * turn_deg, cross_);
  const std::string key = (shifts ? "shift " : "turn ") + std::to_string(pair_->fixed) + ' ' + std::to_string(pair_->moving);
  // The name tells the whole way since the keys began to be pressed.
  glm::dmat4 from = transform();
  if (const StitchProject* before = document_.beforeMerging(key)) {
    const ProjectPair was = pairOf(*before, pair_->fixed, pair_->moving);
    const PairLine line = pairLine(pair_->fixed, pair_->moving);
    from = was.start && was.method == PairMethod::byHand ? *was.start
           : line.outcome != nullptr                     ? line.outcome->rigid.fixedToMoving
                                                         : startTransform();
  }
  const glm::dmat4 motion = rigidInverse(next) * from;
  const QLocale locale;
  QString what;
  if (shifts) {
    what =
        tr("nudge %1 by %2 mm").arg(words(letterOf(pair_->moving)), locale.toString(glm::length(carried(motion, cross_) - cross_), 'g', 3));
  } else {
    const glm::dmat3 turn(motion);
    const double angle = std::acos(std::clamp(0.5 * (turn[0][0] + turn[1][1] + turn[2][2] - 1.0), -1.0, 1.0)) * 180.0 / M_PI;
    what = tr("turn %1 by %2°").arg(words(letterOf(pair_->moving)), locale.toString(angle, 'g', 3));
  }
  if (stage_ != Stage::rigid) stage_ = Stage::rigid;
  setTransform(next, what, key);
}

QuickAgreement StitchSession::agreement() const {
  if (!pair_) return {};
  const auto fixed = volume(pair_->fixed);
  const auto moving = volume(pair_->moving);
  if (!fixed || !moving) return {};
  // Cross-hairs that move ask again and again about a pose that stays.
  const glm::dmat4 now = transform();
  if (agreementOf_.fixed == fixed && agreementOf_.moving == moving && agreementOf_.transform == now) return agreementOf_.found;
  const glm::dvec3 extent = glm::dvec3(fixed->grid.dims) * fixed->grid.spacing_mm;
  const double step_mm = std::max(1.0, std::cbrt(extent.x * extent.y * extent.z) / 40.0);
  agreementOf_ = {fixed, moving, now, quickAgreement(*fixed, *moving, now, step_mm)};
  return agreementOf_.found;
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
  if (withoutPlaces) {
    StitchProject next = project();
    for (std::size_t n = 0; n < next.volumes.size(); ++n) next.volumes[n].placement = Placement::unknown;
    edit(std::move(next), tr("match without tracker"));
  }
  run(Step::graph, withoutPlaces ? tr("Matching without tracker") : tr("Refining the places"));
}

void StitchSession::run(Step until, const QString& title) {
  if (isBusy()) return;
  if (project().volumes.empty()) {
    Q_EMIT problem(tr("There is nothing to work on yet; add two volumes or more."));
    return;
  }
  Q_EMIT problem({});
  document_.endMerging();
  running_ = true;
  running_levels_.clear();
  inbox_ = std::make_shared<Inbox>();
  poll_.start();
  struct Made {
    ChainState state;
    std::shared_ptr<const Volume> result;
  };
  auto made = std::make_shared<Made>();
  const StitchProject asked = project();
  ChainOptions options;
  options.until = until;
  if (const auto free = availableMemory_bytes()) options.maxBytes = std::min(options.maxBytes, *free);
  options.onLevel = [inbox = inbox_](std::size_t fixed, std::size_t moving, const registration::Level& level) {
    const std::lock_guard lock(inbox->mutex);
    inbox->levels.push_back({fixed, moving, level});
  };
  auto& volumes = host_.volumes();
  auto& files = host_.files();
  const QPointer<StitchSession> here(this);
  host_.jobs().start(
      title.toStdString(),
      [made, asked, options, &volumes, &files, folder = workFolder()](Progress& progress) -> Result<void> {
        std::error_code ignored;
        fs::create_directories(folder, ignored);
        auto state = runChain(asked, folder, options, volumes, files, progress);
        if (!state) return passOn(state.error());
        made->state = std::move(*state);
        if (made->state.volume.empty()) return {};
        auto volume = volumes.read(made->state.volume, progress);
        if (!volume) return passOn(volume.error());
        if (!made->state.coverage.empty())
          if (auto covered = volumes.readCoverageInto(*volume, made->state.coverage, progress); !covered) return covered;
        made->result = std::make_shared<const Volume>(std::move(*volume));
        return {};
      },
      [here, made, asked](const Result<void>& outcome) {
        StitchSession* session = here.data();
        if (session == nullptr) return;
        session->running_ = false;
        session->poll_.stop();
        session->inbox_.reset();
        if (!outcome) {
          session->say(outcome.error());
        } else {
          session->result_ = made->result;
          session->settle(std::move(made->state), asked);
        }
        Q_EMIT session->changed();
        Q_EMIT session->lookChanged();
        Q_EMIT session->levelsChanged();
        session->tell();
      });
  Q_EMIT changed();
  Q_EMIT levelsChanged();
}

void StitchSession::settle(ChainState state, StitchProject asked) {
  foundKeys_.clear();
  for (std::size_t n = 0; n < asked.volumes.size(); ++n) {
    foundKeys_.push_back(keyOf(asked.volumes[n]));
    if (n < state.volumes.size() && state.volumes[n]) volumes_[foundKeys_.back()] = state.volumes[n];
  }
  found_ = std::make_shared<const ChainState>(std::move(state));
  asked_ = std::move(asked);
  if (stage_ == Stage::elastic && !hasElastic()) stage_ = Stage::rigid;
  if (!found_->bends.empty() && hasElastic()) stage_ = Stage::elastic;
  afterChoice();
  fit();
  if (!found_->reason.empty() && found_->verdict != registration::Verdict::aligned) Q_EMIT said(words(found_->reason));
}

void StitchSession::pinStart() {
  if (running_) return;
  const glm::dmat4 now = transform();
  editPair([&](ProjectPair& pair) { pair.start = now; }, tr("redo %1").arg(nameOfPair()), "redo " + nameOfPair().toStdString());
}

void StitchSession::redoPair(PairMethod method, std::optional<double> maxTurn_deg) {
  if (!pair_ || isBusy()) return;
  editPair(
      [&](ProjectPair& pair) {
        pair.method = method;
        pair.maxTurn_deg = maxTurn_deg;
        pair.decision = Decision::undecided;
        if (method != PairMethod::byHand && method != PairMethod::refine) pair.start.reset();
      },
      tr("redo %1").arg(nameOfPair()), "redo " + nameOfPair().toStdString());
  run(Step::graph, tr("Matching %1 again").arg(nameOfPair()));
}

std::vector<registration::Level> StitchSession::levels() const {
  std::vector<registration::Level> result;
  if (!pair_) return result;
  for (const LevelSeen& seen : running_levels_)
    if (seen.fixed == pair_->fixed && seen.moving == pair_->moving) result.push_back(seen.level);
  if (!result.empty() || running_) return result;
  const PairLine line = pairLine(pair_->fixed, pair_->moving);
  if (line.outcome != nullptr) result = line.outcome->rigid.levels;
  return result;
}

void StitchSession::showResult() {
  if (result_) host_.volumes().show(*result_, tr("Stitched volume").toStdString());
}

void StitchSession::saveResult(const fs::path& folder) {
  if (!result_ || !found_) {
    Q_EMIT problem(tr("There is no stitched volume yet; run 'Seams and blend' first."));
    return;
  }
  const QPointer<StitchSession> here(this);
  host_.jobs().start(
      tr("Saving the stitched volume").toStdString(),
      [folder, parts = std::vector<fs::path>{found_->volume, found_->coverage, found_->source, found_->provenance}](
          Progress& progress) -> Result<void> {
        std::error_code failed;
        fs::create_directories(folder, failed);
        for (std::size_t n = 0; n < parts.size(); ++n) {
          if (parts[n].empty()) continue;
          if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "Saving was cancelled.");
          const fs::path target = folder / parts[n].filename();
          const fs::path aside = target.string() + ".part";
          fs::copy_file(parts[n], aside, fs::copy_options::overwrite_existing, failed);
          if (!failed) fs::rename(aside, target, failed);
          if (failed)
            return failure(ErrorCode::notWritable, "'" + target.string() + "' could not be written (" + failed.message() +
                                                       "); choose another folder or make room.");
          progress.report("Copying", static_cast<double>(n + 1) / static_cast<double>(parts.size()));
        }
        return {};
      },
      [here, folder](const Result<void>& outcome) {
        StitchSession* session = here.data();
        if (session == nullptr) return;
        if (!outcome) return session->say(outcome.error());
        Q_EMIT session->said(tr("Saved in %1: volume.mha, coverage.mha, source.mha and provenance.json.").arg(words(folder.string())));
      });
}

void StitchSession::handToCase() {
  if (!result_) {
    Q_EMIT problem(tr("There is no stitched volume yet; run 'Seams and blend' first."));
    return;
  }
  auto& cases = host_.cases();
  if (!cases.current() || cases.currentFolder().empty()) {
    Q_EMIT problem(tr("No case is open that could take the volume; open one (Ctrl+O) or save the volume as a file."));
    return;
  }
  const fs::path caseFolder = cases.currentFolder();
  // Volumes are never written over: an older attempt or another case may still speak of them.
  std::error_code ignored;
  std::string name = "stitched";
  for (int n = 2; fs::exists(caseFolder / "volumes" / (name + ".mha"), ignored); ++n) name = "stitched-" + std::to_string(n);
  const auto read = result_;
  const QPointer<StitchSession> here(this);
  auto& volumes = host_.volumes();
  host_.jobs().start(
      tr("Handing the volume to the case").toStdString(),
      [read, &volumes, caseFolder, name](Progress& progress) -> Result<void> {
        std::error_code unmade;
        fs::create_directories(caseFolder / "volumes", unmade);
        PartOfProgress second(progress, 0.0, 0.6);
        if (auto written = volumes.write(*read, caseFolder / "volumes" / (name + ".mha"), second); !written) return written;
        if (read->coverage.empty()) return {};
        PartOfProgress third(progress, 0.6, 1.0);
        return volumes.writeCoverage(*read, caseFolder / "volumes" / (name + "-coverage.mha"), third);
      },
      [here, read, caseFolder, name](const Result<void>& outcome) {
        StitchSession* session = here.data();
        if (session == nullptr) return;
        if (!outcome) return session->say(outcome.error());
        auto& open = session->host_.cases();
        if (!open.current() || open.currentFolder() != caseFolder) {
          Q_EMIT session->problem(tr("Another case was opened meanwhile; the volume lies in %1 and no case was changed.")
                                      .arg(words((caseFolder / "volumes").string())));
          return;
        }
        nlohmann::json manifest = *open.current();
        nlohmann::json place = nlohmann::json::object();
        if (manifest.contains("volume") && manifest["volume"].is_object() && manifest["volume"].contains("file") &&
            manifest["volume"].contains("file_to_world"))
          place["file_to_world"] = manifest["volume"]["file_to_world"];
        place["file"] = "volumes/" + name + ".mha";
        manifest["volume"] = std::move(place);
        const bool wasSaved = !open.hasUnsavedChanges();
        if (auto edited = open.edit(manifest, tr("take over the stitched volume").toStdString(), {}); !edited)
          return session->say(edited.error());
        QString sentence = tr("The case now uses volumes/%1.mha.").arg(words(name));
        if (wasSaved) {
          if (auto saved = open.save(); !saved) return session->say(saved.error());
        } else {
          sentence += QLatin1Char(' ') + tr("It had unsaved changes before; save the case to keep them all.");
        }
        session->host_.volumes().show(*read, tr("Stitched volume").toStdString());
        Q_EMIT session->said(sentence);
      });
}

}  // namespace ew::stitching
