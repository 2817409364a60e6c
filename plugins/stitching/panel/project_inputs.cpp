#include "panel/project_inputs.h"

#include <QDropEvent>
#include <QMimeData>
#include <QPointer>
#include <QUrl>
#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "ew/core/ending.h"
#include "ew/stitching/chain.h"
#include "ew/widgets/words.h"
#include "panel/folders.h"
#include "panel/notices.h"
#include "panel/project_document.h"
#include "panel/project_files.h"

namespace ew::stitching {

/// Files that were read before they become lines of the project.
struct FilesRead {
  std::vector<std::pair<ProjectVolume, std::shared_ptr<const Volume>>> volumes;  ///< null: a sweep that still needs something
  std::map<std::string, Message> reasons;                                        ///< of these, by keyOf
  std::set<std::string> little;  ///< keyOf those that are asked about: too little of them is kept
  std::set<std::filesystem::path> sweeps;
  int failed = 0;
};

namespace {

namespace fs = std::filesystem;

bool isProject(const fs::path& file) { return hasEnding(file, ".json"); }

/// A file's name without what only tells its kind, which is two words for sweeps and packed volumes.
std::string nameOfFile(const fs::path& file) {
  const fs::path stem = file.stem();
  return (hasEnding(stem, ".igs") || hasEnding(stem, ".nii")) && stem.stem() != stem ? stem.stem().string() : stem.string();
}

/// Files are read one after the other: sweeps are made volumes in one folder, in which one run can be at work.
/// @return not held: it was cancelled meanwhile
std::unique_lock<std::timed_mutex> waitForTurn(std::timed_mutex& turn, const Progress& progress) {
  std::unique_lock lock(turn, std::defer_lock);
  while (!progress.cancelRequested() && !lock.try_lock_for(std::chrono::milliseconds(50)))
    ;
  return lock;
}

bool isSweepFile(const fs::path& file, sdk::Volumes& volumes) {
  const auto info = volumes.inspect(file);
  return info && info->sweep;
}

bool asksForConsent(const Error& problem) {
  return std::find(problem.context.begin(), problem.context.end(), std::pair<std::string, std::string>("ask", "accept-small")) !=
         problem.context.end();
}

/// A sweep of which something has to be said before it is a volume: it stays in the list, where that can be done.
bool canBeMended(const Error& problem) {
  return problem.code == ErrorCode::missingCalibration || problem.code == ErrorCode::tooLarge || asksForConsent(problem);
}

/// The chain says how a project's text answers; here a box below the list does.
Error asAskedHere(Error problem) {
  if (asksForConsent(problem) && !problem.message.arguments().empty()) {
    const Message question = problem.message.arguments().front();
    problem.message = ew::say<"%1 Below the list it can be taken as it is.">(question);
  }
  return problem;
}

/// A volume as it is, a sweep as the chain's first step makes one of it.
Result<Volume> readOne(const ProjectVolume& line, bool isSweep, const fs::path& folder, sdk::Volumes& volumes, Progress& progress) {
  if (!isSweep && line.confidence.empty()) {
    auto volume = volumes.read(line.file, progress);
    if (volume && !line.coverage.empty())
      if (auto covered = volumes.readCoverageInto(*volume, line.coverage, progress); !covered) return passOn(covered.error());
    return volume;
  }
  StitchProject one;
  one.volumes.push_back(line);
  ChainOptions options;
  options.until = Step::reconstruct;
  options.isFolderOwn = true;
  auto state = runChain(one, folder, options, progress);
  if (!state) return passOn(asAskedHere(state.error()));
  if (state->volumes.empty() || !state->volumes.front())
    return failure(ErrorCode::notReadable, say<"'%1' gave no volume; check what kind of file it is.">(line.file));
  return *state->volumes.front();
}

/// Reads lines before they are added: a file that is no volume never becomes one. @error the first of `into.failed`, cancelled
Result<void> readLines(const std::vector<ProjectVolume>& lines, const fs::path& folder, std::timed_mutex& turn, sdk::Volumes& volumes,
                       FilesRead& into, Progress& progress) {
  const auto mine = waitForTurn(turn, progress);
  if (!mine) return failure(ErrorCode::cancelled, say<"Reading was cancelled.">());
  const double share = 1.0 / static_cast<double>(lines.size());
  std::optional<Error> first;
  for (std::size_t n = 0; n < lines.size(); ++n) {
    PartOfProgress part(progress, share * static_cast<double>(n), share * static_cast<double>(n + 1));
    part.report(verbatim(lines[n].name), 0.0);
    const bool isSweep = isSweepFile(lines[n].file, volumes);
    if (isSweep) into.sweeps.insert(lines[n].file);
    auto volume = readOne(lines[n], isSweep, folder, volumes, part);
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"Reading was cancelled.">());
    if (volume) {
      into.volumes.emplace_back(lines[n], std::make_shared<const Volume>(std::move(*volume)));
      continue;
    }
    ++into.failed;
    if (!first) first = volume.error();
    if (!isSweep || !canBeMended(volume.error())) continue;
    into.volumes.emplace_back(lines[n], nullptr);
    into.reasons[keyOf(lines[n])] = volume.error().message;
    if (asksForConsent(volume.error())) into.little.insert(keyOf(lines[n]));
  }
  if (first) return passOn(*first);
  return {};
}

}  // namespace

ProjectInputs::ProjectInputs(sdk::Host& host, Notices& notices, ProjectDocument& document)
    : host_(host), notices_(notices), document_(document) {}

const StitchProject& ProjectInputs::project() const { return document_.project(); }

void ProjectInputs::addDropped(QDropEvent& event) {
  std::vector<fs::path> files;
  for (const QUrl& url : event.mimeData()->urls())
    if (url.isLocalFile()) files.emplace_back(url.toLocalFile().toStdString());
  if (files.empty()) return;
  event.acceptProposedAction();
  addFiles(files);
}

void ProjectInputs::addFiles(const std::vector<fs::path>& files) {
  Q_EMIT notices_.problem({});
  if (!files.empty()) keepFolderOf(words(files.front().string()));
  if (files.size() == 1 && isProject(files.front()) && project().volumes.empty()) {
    document_.openProject(files.front());
    return;
  }
  std::vector<ProjectVolume> lines = linesOf(files);
  if (lines.empty()) return;
  auto read = std::make_shared<FilesRead>();
  const QPointer<ProjectInputs> here(this);
  const QString what = lines.size() == 1 ? tr("Reading %1").arg(words(lines.front().name))
                                         : tr("Reading %n volumes", nullptr, static_cast<int>(lines.size()));
  host_.jobs().start(
      what.toStdString(),
      [read, lines = std::move(lines), &volumes = host_.volumes(), folder = document_.readingFolder(),
       turn = readingTurn_](Progress& progress) { return readLines(lines, folder, *turn, volumes, *read, progress); },
      [here, read](const Result<void>& outcome) {
        if (ProjectInputs* inputs = here.data()) inputs->takeRead(*read, outcome);
      });
}

std::vector<ProjectVolume> ProjectInputs::linesOf(const std::vector<fs::path>& files) {
  std::vector<ProjectVolume> lines;
  QStringList known;
  // The same file twice is a slip of the hand: it would be stitched with itself.
  const auto isListed = [&](const fs::path& file) {
    const auto same = [&](const ProjectVolume& line) {
      std::error_code ignored;
      return line.file == file || fs::equivalent(line.file, file, ignored);
    };
    return std::any_of(project().volumes.begin(), project().volumes.end(), same) || std::any_of(lines.begin(), lines.end(), same);
  };
  for (const auto& file : files) {
    if (isProject(file)) {
      auto text = host_.files().readText(file);
      if (!text) {
        notices_.say(text.error());
        continue;
      }
      auto other = parseProject(*text, file.parent_path());
      if (!other) {
        notices_.say(other.error());
        continue;
      }
      lines.insert(lines.end(), other->volumes.begin(), other->volumes.end());
    } else if (isListed(file)) {
      known << words(file.filename().string());
    } else {
      ProjectVolume line;
      line.file = file;
      line.name = nameOfFile(file);
      lines.push_back(std::move(line));
    }
  }
  if (!known.isEmpty()) Q_EMIT notices_.problem(tr("%1: in the list already.").arg(known.join(QStringLiteral(", "))));
  return lines;
}

void ProjectInputs::takeRead(FilesRead& read, const Result<void>& outcome) {
  std::vector<ProjectVolume> added;
  for (auto& [line, volume] : read.volumes) {
    if (volume)
      volumes_[keyOf(line)] = volume;
    else
      unreadable_[keyOf(line)] = read.reasons[keyOf(line)];
    added.push_back(line);
  }
  sweeps_.merge(read.sweeps);
  little_.merge(read.little);
  if (!added.empty()) {
    const QString step =
        added.size() == 1 ? tr("add %1").arg(words(added.front().name)) : tr("add %n volumes", nullptr, static_cast<int>(added.size()));
    document_.edit(withVolumes(project(), std::move(added)), step);
    if (!read.reasons.empty()) Q_EMIT mendingWanted(project().volumes.size() - 1);  // where it can be mended
  }
  if (outcome) return;
  notices_.say(outcome.error());
  if (read.failed > 1)
    Q_EMIT notices_.problem(words(outcome.error().message) + QLatin1Char(' ') +
                            tr("%n more could not be read either.", nullptr, read.failed - 1));
}

void ProjectInputs::readVolumes() {
  if (reading_) return;
  std::vector<ProjectVolume> lines;
  for (const auto& line : project().volumes)
    if (volumes_.count(keyOf(line)) == 0 && unreadable_.count(keyOf(line)) == 0) lines.push_back(line);
  if (lines.empty()) return;
  reading_ = true;
  struct Read {
    std::vector<std::pair<std::string, std::shared_ptr<const Volume>>> volumes;  ///< null: it cannot be read
    std::map<std::string, Message> reasons;                                      ///< of these
    std::set<std::string> little;                                                ///< of these, those with too little
    std::set<fs::path> sweeps;
    std::optional<Error> first;
  };
  auto read = std::make_shared<Read>();
  const QPointer<ProjectInputs> here(this);
  auto& volumes = host_.volumes();
  host_.jobs().start(
      tr("Reading %n volumes", nullptr, static_cast<int>(lines.size())).toStdString(),
      [read, lines, &volumes, folder = document_.readingFolder(), turn = readingTurn_](Progress& progress) -> Result<void> {
        const auto mine = waitForTurn(*turn, progress);
        if (!mine) return failure(ErrorCode::cancelled, ew::say<"Reading was cancelled.">());
        const double share = 1.0 / static_cast<double>(lines.size());
        for (std::size_t n = 0; n < lines.size(); ++n) {
          PartOfProgress part(progress, share * static_cast<double>(n), share * static_cast<double>(n + 1));
          part.report(verbatim(lines[n].name), 0.0);
          const bool isSweep = isSweepFile(lines[n].file, volumes);
          if (isSweep) read->sweeps.insert(lines[n].file);
          auto volume = readOne(lines[n], isSweep, folder, volumes, part);
          if (progress.cancelRequested()) return failure(ErrorCode::cancelled, ew::say<"Reading was cancelled.">());
          if (!volume && !read->first) read->first = volume.error();
          if (!volume) read->reasons[keyOf(lines[n])] = volume.error().message;
          if (!volume && asksForConsent(volume.error())) read->little.insert(keyOf(lines[n]));
          read->volumes.emplace_back(keyOf(lines[n]), volume ? std::make_shared<const Volume>(std::move(*volume)) : nullptr);
        }
        return {};
      },
      [here, read, lines](const Result<void>& outcome) {
        ProjectInputs* inputs = here.data();
        if (inputs == nullptr) return;
        inputs->reading_ = false;
        for (const auto& [key, volume] : read->volumes) {
          if (volume)
            inputs->volumes_[key] = volume;
          else
            inputs->unreadable_[key] = read->reasons[key];
        }
        inputs->sweeps_.merge(read->sweeps);
        inputs->little_.merge(read->little);
        if (!outcome)  // cancelled: not asked again until the file is added anew
          for (const auto& line : lines)
            if (inputs->volumes_.count(keyOf(line)) == 0) inputs->unreadable_.try_emplace(keyOf(line));
        if (read->first) inputs->notices_.say(*read->first);
        Q_EMIT inputs->volumesRead();
      });
}

void ProjectInputs::forgetFailures() {
  unreadable_.clear();
  little_.clear();
}

void ProjectInputs::keep(const ProjectVolume& line, std::shared_ptr<const Volume> volume) { volumes_[keyOf(line)] = std::move(volume); }

std::shared_ptr<const Volume> ProjectInputs::volume(std::size_t index) const {
  return index < project().volumes.size() ? volumeOf(project().volumes[index]) : nullptr;
}

std::shared_ptr<const Volume> ProjectInputs::volumeOf(const ProjectVolume& line) const {
  const auto at = volumes_.find(keyOf(line));
  return at != volumes_.end() ? at->second : nullptr;
}

bool ProjectInputs::asksAboutLittle(std::size_t index) const {
  if (index >= project().volumes.size()) return false;
  const ProjectVolume& line = project().volumes[index];
  return line.acceptsSmall || little_.count(keyOf(line)) != 0;
}

void ProjectInputs::setAcceptsSmall(std::size_t index, bool accepts) {
  if (index >= project().volumes.size() || project().volumes[index].acceptsSmall == accepts) return;
  StitchProject next = project();
  next.volumes[index].acceptsSmall = accepts;
  Q_EMIT notices_.problem({});
  document_.edit(std::move(next),
                 accepts ? tr("take %1 as it is").arg(words(letterOf(index))) : tr("ask about %1 again").arg(words(letterOf(index))));
}

bool ProjectInputs::isUnreadable(std::size_t index) const {
  return index < project().volumes.size() && unreadable_.count(keyOf(project().volumes[index])) != 0;
}

QString ProjectInputs::whyUnreadable(std::size_t index) const {
  return isUnreadable(index) ? words(unreadable_.at(keyOf(project().volumes[index]))) : QString();
}

bool ProjectInputs::isSweep(std::size_t index) const {
  return index < project().volumes.size() && sweeps_.contains(project().volumes[index].file);
}

void ProjectInputs::setCalibration(std::size_t index, const fs::path& deviceSet) {
  if (index >= project().volumes.size()) return;
  StitchProject next = project();
  next.volumes[index].calibration = deviceSet;
  Q_EMIT notices_.problem({});
  document_.edit(std::move(next), deviceSet.empty() ? tr("no calibration of %1").arg(words(letterOf(index)))
                                                    : tr("calibration of %1").arg(words(letterOf(index))));
}

void ProjectInputs::setSweepSpacing(std::size_t index, double spacing_mm) {
  if (index >= project().volumes.size() || project().volumes[index].spacing_mm == spacing_mm) return;
  StitchProject next = project();
  next.volumes[index].spacing_mm = spacing_mm;
  Q_EMIT notices_.problem({});
  document_.edit(std::move(next), tr("voxel spacing of %1").arg(words(letterOf(index))));
}

}  // namespace ew::stitching
