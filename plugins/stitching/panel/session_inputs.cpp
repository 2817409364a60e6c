#include "panel/stitch_session.h"

#include <QPointer>
#include <algorithm>
#include <system_error>
#include <utility>

#include "ew/sdk/panel.h"
#include "logic/places.h"
#include "panel/folders.h"
#include "panel/phrases.h"
#include "panel/session_parts.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using sdk::words;

bool isProject(const fs::path& file) { return file.extension() == ".json"; }

/// A file's name without what only tells its kind, which is two words for sweeps and packed volumes.
std::string nameOfFile(const fs::path& file) {
  const fs::path stem = file.stem();
  return (stem.extension() == ".igs" || stem.extension() == ".nii") && stem.stem() != stem ? stem.stem().string() : stem.string();
}

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

void StitchSession::addFiles(const std::vector<fs::path>& files) {
  Q_EMIT problem({});
  if (!files.empty()) keepFolderOf(words(files.front().string()));
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
    } else if (isListed(file)) {
      known << words(file.filename().string());
    } else {
      ProjectVolume line;
      line.file = file;
      line.name = nameOfFile(file);
      lines.push_back(std::move(line));
    }
  }
  if (!known.isEmpty()) Q_EMIT problem(tr("%1: in the list already.").arg(known.join(QStringLiteral(", "))));
  if (lines.empty()) return;
  // Read before they are added: a file that is no volume never becomes a line.
  struct Read {
    std::vector<std::pair<ProjectVolume, std::shared_ptr<const Volume>>> volumes;
    int failed = 0;
  };
  auto read = std::make_shared<Read>();
  const QPointer<StitchSession> here(this);
  const QString what = lines.size() == 1 ? tr("Reading %1").arg(words(lines.front().name))
                                         : tr("Reading %n volumes", nullptr, static_cast<int>(lines.size()));
  auto& volumes = host_.volumes();
  auto& texts = host_.files();
  host_.jobs().start(
      what.toStdString(),
      [read, lines, &volumes, &texts, folder = folder_ / "work" / "reading"](Progress& whole) -> Result<void> {
        ProgressInWords progress(whole);
        const double share = 1.0 / static_cast<double>(lines.size());
        std::optional<Error> first;
        for (std::size_t n = 0; n < lines.size(); ++n) {
          PartOfProgress part(progress, share * static_cast<double>(n), share * static_cast<double>(n + 1));
          part.report(lines[n].name, 0.0);
          auto volume = readOne(lines[n], folder, volumes, texts, part);
          if (progress.cancelRequested()) return failure(ErrorCode::cancelled, "Reading was cancelled.");
          if (volume) {
            read->volumes.emplace_back(lines[n], std::make_shared<const Volume>(std::move(*volume)));
          } else {
            ++read->failed;
            if (!first) first = volume.error();
          }
        }
        if (first) return passOn(*first);
        return {};
      },
      [here, read](const Result<void>& outcome) {
        StitchSession* session = here.data();
        if (session == nullptr) return;
        std::vector<ProjectVolume> added;
        for (auto& [line, volume] : read->volumes) {
          session->volumes_[keyOf(line)] = volume;
          added.push_back(line);
        }
        if (!added.empty()) {
          const QString step = added.size() == 1 ? tr("add %1").arg(words(added.front().name))
                                                 : tr("add %n volumes", nullptr, static_cast<int>(added.size()));
          session->edit(withVolumes(session->project(), std::move(added)), step);
        }
        if (outcome) return;
        session->say(outcome.error());
        if (read->failed > 1)
          Q_EMIT session->problem(phraseOf(outcome.error().sentence) + QLatin1Char(' ') +
                                  tr("%n more could not be read either.", nullptr, read->failed - 1));
      });
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
      [read, lines, &volumes, &texts, folder = folder_ / "work" / "reading"](Progress& whole) -> Result<void> {
        ProgressInWords progress(whole);
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

}  // namespace ew::stitching
