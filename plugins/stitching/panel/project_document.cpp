#include "panel/project_document.h"

#include <QApplication>
#include <QCryptographicHash>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <system_error>
#include <utility>

#include "ew/sdk/window.h"
#include "ew/widgets/words.h"
#include "panel/folders.h"
#include "panel/notices.h"
#include "panel/project_files.h"

namespace ew::stitching {
namespace {

namespace fs = std::filesystem;

constexpr int kKeepAfter_ms = 700;

fs::path dataFolder() {
  return fs::path(QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation).toStdString()) / "stitching";
}

}  // namespace

ProjectDocument::ProjectDocument(sdk::Host& host, Notices& notices, fs::path folder)
    : host_(host),
      notices_(notices),
      folder_(folder.empty() ? dataFolder() : std::move(folder)),
      recovery_(folder_),
      document_(host.files(), recovery_.file()) {
  keepSoon_.setSingleShot(true);
  keepSoon_.setInterval(kKeepAfter_ms);
  connect(&keepSoon_, &QTimer::timeout, this, &ProjectDocument::keep);
  for (const int place : recovery_.left()) {
    auto left = document_.leftIn(recovery_.fileOf(place));
    if (!left)
      host_.log().warn(left.error().sentence());
    else if (*left)
      left_.push_back({place, std::move(**left)});
  }
}

ProjectDocument::~ProjectDocument() { keep(); }

fs::path ProjectDocument::untitledFolder(int place) const { return folder_ / "work" / ("untitled-" + std::to_string(place)); }

fs::path ProjectDocument::readingFolder() const { return folder_ / "work" / ("reading-" + std::to_string(recovery_.number())); }

fs::path ProjectDocument::workFolder() const {
  if (document_.file().empty()) return untitledFolder(recovery_.number());
  const std::string whole = fs::absolute(document_.file()).lexically_normal().string();
  const QByteArray name = QCryptographicHash::hash(QByteArray::fromStdString(whole), QCryptographicHash::Sha1).toHex().left(16);
  return folder_ / "work" / name.toStdString();
}

void ProjectDocument::keep() {
  keepSoon_.stop();
  if (auto kept = document_.keepRecovery(); !kept) host_.log().warn(kept.error().sentence());
}

void ProjectDocument::edit(StitchProject next, const QString& what, const std::string& mergeKey) {
  left_.clear();  // who works on does not want to be asked; it stays where it is
  document_.edit(std::move(next), what.toStdString(), mergeKey);
  announce();
}

void ProjectDocument::undo() {
  document_.undo();
  announce();
}

void ProjectDocument::redo() {
  document_.redo();
  announce();
}

void ProjectDocument::announce() {
  keepSoon_.start();
  Q_EMIT edited();
}

void ProjectDocument::replace() {
  ++number_;
  Q_EMIT replaced();
}

void ProjectDocument::startAnew() {
  Q_EMIT notices_.problem({});  // it was about the project before
  Q_EMIT notices_.said({});
  document_.clear();
  replace();
  announce();
}

bool ProjectDocument::openProject(const fs::path& file) {
  Q_EMIT notices_.problem({});
  Q_EMIT notices_.said({});
  if (auto opened = document_.open(file); !opened) {
    notices_.say(opened.error());
    return false;
  }
  left_.clear();
  Q_EMIT fileOpened();
  replace();
  announce();
  Q_EMIT resultsWanted();
  return true;
}

void ProjectDocument::save(bool elsewhere) {
  if (project().volumes.empty()) {
    Q_EMIT notices_.problem(tr("The project has no volume yet; add one before it is saved."));
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

fs::path ProjectDocument::askForSaveName(const fs::path& before) {
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

ProjectDocument::OnDisk ProjectDocument::askAboutFileOnDisk() {
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

bool ProjectDocument::saveAs(const fs::path& file) {
  const fs::path before = workFolder();
  if (auto saved = document_.save(file); !saved) {
    notices_.say(saved.error());
    return false;
  }
  left_.clear();
  if (const fs::path after = workFolder(); before != after) Q_EMIT workFolderChanged(before, after);
  Q_EMIT notices_.problem({});
  if (const auto elsewhere = filesElsewhere(project(), file.parent_path()); !elsewhere.empty())
    Q_EMIT notices_.said(
        tr("%n files lie in other folders and are named by their whole path: to take the project to another machine, put them beside "
           "it first.",
           nullptr, static_cast<int>(elsewhere.size())));
  Q_EMIT saved();
  return true;
}

void ProjectDocument::reopenLeft() {
  if (left_.empty()) return;
  const RecoverableWork left = left_.front();
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
  replace();
  announce();
  Q_EMIT resultsWanted();
}

void ProjectDocument::discardLeft() {
  if (left_.empty()) return;
  recovery_.forget(left_.front().place);
  left_.erase(left_.begin());
  Q_EMIT leftChanged();
}

}  // namespace ew::stitching
