#include "panel/stitch_session.h"

#include <QApplication>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <algorithm>
#include <system_error>
#include <utility>

#include "ew/sdk/panel.h"
#include "ew/sdk/window.h"
#include "panel/folders.h"
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
    : host_(host),
      folder_(folder.empty() ? dataFolder() : std::move(folder)),
      recovery_(folder_),
      document_(host.files(), recovery_.file()) {
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
  for (const int place : recovery_.left()) {
    auto left = document_.leftIn(recovery_.fileOf(place));
    if (!left)
      host_.log().warn(left.error().sentence());
    else if (*left)
      left_.push_back({place, std::move(**left)});
  }
}

StitchSession::~StitchSession() { keep(); }

fs::path StitchSession::untitledFolder(int place) const { return folder_ / "work" / ("untitled-" + std::to_string(place)); }

fs::path StitchSession::readingFolder() const { return folder_ / "work" / ("reading-" + std::to_string(recovery_.number())); }

void StitchSession::keep() {
  keepSoon_.stop();
  if (auto kept = document_.keepRecovery(); !kept) host_.log().warn(kept.error().sentence());
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
  host_.log().warn(error.sentence());
  Q_EMIT problem(words(error.message));
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

std::string StitchSession::note() const { return pairSummary().toStdString(); }

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
  if (!elsewhere && document_.isChangedOnDisk()) {
    const OnDisk wanted = askAboutFileOnDisk();
    if (wanted == OnDisk::cancel) return;
    if (wanted == OnDisk::reload) {
      openProject(file);
      return;
    }
    elsewhere = wanted == OnDisk::saveElsewhere;
  }
  if (file.empty() || elsewhere) {
    file = askForSaveName(file);
    if (file.empty()) return;
  }
  saveAs(file);
}

fs::path StitchSession::askForSaveName(const fs::path& before) {
  const fs::path usual = fs::path(lastFolder().toStdString()) / "stitching.json";
  const auto chosen = host_.window().askSaveFile({tr("Save the stitch project").toStdString(),
                                                  before.empty() ? usual : before,
                                                  tr("Stitch projects (*.json)").toStdString(),
                                                  {".json"},
                                                  {},
                                                  {},
                                                  filesOf(project())});
  if (!chosen) return {};
  keepFolderOf(words(chosen->string()));
  return *chosen;
}

StitchSession::OnDisk StitchSession::askAboutFileOnDisk() {
  QMessageBox question(QApplication::activeWindow());
  question.setObjectName(QStringLiteral("changedOnDiskQuestion"));
  question.setIcon(QMessageBox::NoIcon);
  question.setText(tr("'%1' was changed by another program since it was opened here.").arg(words(document_.file().filename().string())));
  question.setInformativeText(tr("Reloading drops your changes, overwriting drops the other ones."));
  auto* reload = question.addButton(tr("Reload"), QMessageBox::DestructiveRole);
  reload->setObjectName(QStringLiteral("reloadProject"));
  auto* overwrite = question.addButton(tr("Overwrite"), QMessageBox::DestructiveRole);
  overwrite->setObjectName(QStringLiteral("overwriteProject"));
  auto* another = question.addButton(tr("Save as…"), QMessageBox::AcceptRole);
  another->setObjectName(QStringLiteral("saveProjectAs"));
  question.setDefaultButton(another);
  question.setEscapeButton(question.addButton(QMessageBox::Cancel));
  question.exec();
  if (question.clickedButton() == reload) return OnDisk::reload;
  if (question.clickedButton() == overwrite) return OnDisk::overwrite;
  return question.clickedButton() == another ? OnDisk::saveElsewhere : OnDisk::cancel;
}

bool StitchSession::saveAs(const fs::path& file) {
  const fs::path before = workFolder();
  if (auto saved = document_.save(file); !saved) {
    say(saved.error());
    return false;
  }
  left_.clear();
  // What was found goes along; where that does not work it is only found again.
  std::error_code ignored;
  const fs::path after = workFolder();
  if (before != after && !running_ && fs::exists(before, ignored) && !fs::exists(after, ignored)) {
    fs::rename(before, after, ignored);
    if (!ignored && found_) {
      auto state = std::make_shared<ChainState>(*found_);
      for (fs::path* path : {&state->volume, &state->coverage, &state->source, &state->level, &state->provenance})
        if (!path->empty()) *path = after / path->lexically_relative(before);
      for (fs::path& path : resultFiles_)
        if (!path.empty()) path = after / path.lexically_relative(before);
      turnedOutcomes_.clear();
      found_ = std::move(state);
    }
  }
  Q_EMIT problem({});
  if (const auto elsewhere = filesElsewhere(project(), file.parent_path()); !elsewhere.empty())
    Q_EMIT said(
        tr("%n files lie in other folders and are named by their whole path: to take the project to another machine, put them beside "
           "it first.",
           nullptr, static_cast<int>(elsewhere.size())));
  Q_EMIT changed();
  tell();
  return true;
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
  Q_EMIT problem({});  // it was about the project before
  Q_EMIT said({});
  document_.clear();
  forgetFound();
  pair_.reset();
  chosenVolume_.reset();
  afterEdit();
}

void StitchSession::reopenLeft() {
  if (left_.empty()) return;
  const LeftWork left = left_.front();
  // What was found about it goes along; where that does not work it is only found again.
  std::error_code ignored;
  if (left.work.file.empty() && !fs::exists(untitledFolder(recovery_.number()), ignored))
    fs::rename(untitledFolder(left.place), untitledFolder(recovery_.number()), ignored);
  document_.takeOver(left.work);
  if (auto kept = document_.keepRecovery(); !kept)
    host_.log().warn(kept.error().sentence());  // it stays where it was
  else
    recovery_.forget(left.place);
  left_.clear();
  forgetFound();
  pair_.reset();
  afterEdit();
  readVolumes();
  takeUp();
}

void StitchSession::discardLeft() {
  if (left_.empty()) return;
  recovery_.forget(left_.front().place);
  left_.erase(left_.begin());
  Q_EMIT changed();
}

void StitchSession::edit(StitchProject next, const QString& what, const std::string& mergeKey) {
  left_.clear();  // who works on does not want to be asked; it stays where it is
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
  Q_EMIT said({});
  if (auto opened = document_.open(file); !opened) {
    say(opened.error());
    return false;
  }
  left_.clear();
  forgetFound();
  pair_.reset();
  chosenVolume_.reset();
  unreadable_.clear();
  little_.clear();
  afterEdit();
  takeUp();
  return true;
}

}  // namespace ew::stitching
