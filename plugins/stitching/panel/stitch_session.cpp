#include "panel/stitch_session.h"

#include <QApplication>
#include <QFileDialog>
#include <QStandardPaths>
#include <algorithm>
#include <system_error>
#include <utility>

#include "ew/sdk/panel.h"
#include "panel/folders.h"
#include "panel/phrases.h"
#include "panel/session_parts.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;
using sdk::words;

constexpr int kKeepAfter_ms = 700;

fs::path dataFolder() {
  return fs::path(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString()) / "stitching";
}

}  // namespace

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
    runningLevels_.insert(runningLevels_.end(), arrived.begin(), arrived.end());
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
  Q_EMIT problem(phraseOf(error.sentence));
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

std::string StitchSession::note() const { return standOfPairs().toStdString(); }

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
                                                  file.empty() ? lastFolder() : words(file.string()), tr("Stitch projects (*.json)"));
    if (chosen.isEmpty()) return;
    if (!chosen.endsWith(QLatin1String(".json"))) chosen += QLatin1String(".json");
    keepFolderOf(chosen);
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
      for (fs::path& path : resultFiles_)
        if (!path.empty()) path = after / path.lexically_relative(before);
      turnedOutcomes_.clear();
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

QList<double> StitchSession::matesAt(double x, double y, double z, bool bent) const {
  const Stage stage = bent ? Stage::elastic : Stage::rigid;
  const glm::dvec3 fixed = fixedMapping(stage)({x, y, z});
  const glm::dvec3 moving = movingMapping(stage)({x, y, z});
  return {fixed.x, fixed.y, fixed.z, moving.x, moving.y, moving.z};
}

void StitchSession::forgetFound() {
  ++projectNumber_;
  turnedOutcomes_.clear();
  found_.reset();
  result_.reset();
  resultFiles_ = {};
  resultAsked_ = {};
}

void StitchSession::startAnew() {
  document_.clear();
  forgetFound();
  pair_.reset();
  chosenVolume_.reset();
  afterEdit();
}

void StitchSession::reopenLeft() {
  if (!left_) return;
  const auto left = std::exchange(left_, std::nullopt);
  document_.takeOver(*left);
  forgetFound();
  pair_.reset();
  afterEdit();
  readVolumes();
  takeUp();
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

bool StitchSession::openProject(const fs::path& file) {
  Q_EMIT problem({});
  if (auto opened = document_.open(file); !opened) {
    say(opened.error());
    return false;
  }
  left_.reset();
  forgetFound();
  pair_.reset();
  chosenVolume_.reset();
  unreadable_.clear();
  afterEdit();
  takeUp();
  return true;
}

}  // namespace ew::stitching
