#include "ew/widgets/save_file.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "ew/widgets/words.h"
#include "save_place.h"

namespace ew {
namespace {

struct SaveFileWords {
  Q_DECLARE_TR_FUNCTIONS(ew::SaveFile)
};

/// @param filter that was chosen: its first ending is meant by a name that has none
QString completed(const QString& file, const QStringList& endings, const QString& filter) {
  const auto isOf = [](const QString& name, const QString& ending) { return name.endsWith(ending, Qt::CaseInsensitive); };
  if (endings.isEmpty() || std::any_of(endings.begin(), endings.end(), [&](const QString& each) { return isOf(file, each); })) return file;
  const QString patterns = filter.section(QLatin1Char('('), -1).section(QLatin1Char(')'), 0, 0);
  for (const QString& pattern : patterns.split(QLatin1Char(' '), Qt::SkipEmptyParts))
    if (const QString ending = pattern.mid(1); endings.contains(ending, Qt::CaseInsensitive)) return file + ending;
  return file + endings.front();
}

/// Whether a file is one of `sources`, by whatever name, or lies in one that is a folder.
bool isOneOf(const std::filesystem::path& file, const std::vector<std::filesystem::path>& sources) {
  std::error_code failed;
  const auto there = std::filesystem::weakly_canonical(file, failed);
  if (failed) return false;
  for (const auto& source : sources)
    for (const auto& named : filesNamedBy(source)) {
      if (std::filesystem::equivalent(file, named, failed)) return true;
      if (!std::filesystem::is_directory(named, failed)) continue;
      const auto inside = there.lexically_relative(std::filesystem::weakly_canonical(named, failed));
      if (!inside.empty() && *inside.begin() != "..") return true;
    }
  return false;
}

/// @return whether to replace `there`; empty: another name is wanted
enum class Answer { replace, otherName, cancel };

Answer mayReplace(QWidget* parent, const QString& title, const QStringList& there) {
  QMessageBox question(parent);
  question.setObjectName(QStringLiteral("replaceQuestion"));
  question.setWindowTitle(title);
  QStringList names;
  for (const QString& file : there) names << QFileInfo(file).fileName();
  question.setText(
      there.size() == 1
          ? SaveFileWords::tr("There is a file '%1' already. It would be replaced.").arg(names.front())
          : SaveFileWords::tr("These files are there already and would be replaced: %1.").arg(names.join(QStringLiteral(", "))));
  question.setInformativeText(SaveFileWords::tr("Folder: %1").arg(QDir::toNativeSeparators(QFileInfo(there.front()).absolutePath())));
  auto* replace = question.addButton(SaveFileWords::tr("Replace"), QMessageBox::DestructiveRole);
  replace->setObjectName(QStringLiteral("replace"));
  auto* other = question.addButton(SaveFileWords::tr("Another name…"), QMessageBox::AcceptRole);
  other->setObjectName(QStringLiteral("otherName"));
  question.addButton(QMessageBox::Cancel);
  question.setDefaultButton(other);
  question.exec();
  if (question.clickedButton() == replace) return Answer::replace;
  return question.clickedButton() == other ? Answer::otherName : Answer::cancel;
}

/// What speaks against replacing one of `there`, a sentence; empty: nothing.
QString whyKept(const SaveFile& asked, const std::vector<std::filesystem::path>& sources, const QStringList& there) {
  for (const QString& file : there) {
    if (isOneOf(pathOf(file), sources))
      return SaveFileWords::tr("'%1' is not written over: what you see was made from it.").arg(QFileInfo(file).fileName());
    if (asked.whyKept)
      if (QString why = asked.whyKept(file); !why.isEmpty()) return why;
  }
  return {};
}

/// @return whether another name is wanted
bool asksForAnother(QWidget* parent, const QString& title, const QString& why) {
  QMessageBox refusal(parent);
  refusal.setObjectName(QStringLiteral("keptFileMessage"));
  refusal.setWindowTitle(title);
  refusal.setText(why);
  refusal.setInformativeText(SaveFileWords::tr("Choose another name, or another folder."));
  auto* other = refusal.addButton(SaveFileWords::tr("Another name…"), QMessageBox::AcceptRole);
  other->setObjectName(QStringLiteral("otherName"));
  refusal.addButton(QMessageBox::Cancel);
  refusal.setDefaultButton(other);
  refusal.exec();
  return refusal.clickedButton() == other;
}

QStringList thereAlready(const SaveFile& asked, const QString& file) {
  QStringList there;
  for (const QString& name : asked.written ? asked.written(file) : QStringList{file})
    for (const auto& written : filesNamedBy(pathOf(name)))
      if (const QFileInfo info(wordsOf(written)); info.exists() || info.isSymLink()) there << info.filePath();
  return there;
}

}  // namespace

SaveFile dated(SaveFile asked) {
  asked.isDated = true;
  return asked;
}

DisplaySources::DisplaySources(QWidget& window, Ask ask) : QObject(&window), ask_(std::move(ask)) {}

std::vector<std::filesystem::path> DisplaySources::around(const QWidget* widget) {
  std::vector<std::filesystem::path> all;
  for (const QObject* at = widget; at != nullptr; at = at->parent())
    for (const QObject* child : at->children())
      if (const auto* sources = dynamic_cast<const DisplaySources*>(child)) {
        const auto some = sources->ask_();
        all.insert(all.end(), some.begin(), some.end());
      }
  return all;
}

QString askSaveFile(QWidget* parent, const SaveFile& asked) {
  const bool hasFolder = !asked.isDated && asked.proposal.contains(QLatin1Char('/'));
  QSettings settings;
  QString proposal = asked.proposal;
  if (!hasFolder)
    proposal = folderForSaving(asked.endings, settings) + QLatin1Char('/') +
               (asked.isDated ? datedName(asked.proposal, asked.endings, QDateTime::currentDateTime()) : nameForFiles(asked.proposal));
  while (true) {
    QFileDialog dialog(parent, asked.title, QFileInfo(proposal).path(), asked.filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    // The dialog knows the name that was typed, not the files that will be written: those are asked about below.
    dialog.setOption(QFileDialog::DontConfirmOverwrite);
    dialog.selectFile(proposal);
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
    QString file = completed(dialog.selectedFiles().constFirst(), asked.endings, dialog.selectedNameFilter());
    if (!hasFolder) keepFolderForSaving(asked.endings, file, settings);
    const QStringList there = thereAlready(asked, file);
    if (there.isEmpty()) return file;
    proposal = file;
    auto sources = DisplaySources::around(parent);
    sources.insert(sources.end(), asked.madeFrom.begin(), asked.madeFrom.end());
    if (const QString why = whyKept(asked, sources, there); !why.isEmpty()) {
      if (!asksForAnother(parent, asked.title, why)) return {};
      continue;
    }
    const Answer answer = mayReplace(parent, asked.title, there);
    if (answer == Answer::replace) return file;
    if (answer == Answer::cancel) return {};
  }
}

Result<void> saveTogether(const std::vector<std::filesystem::path>& files, const std::function<Result<void>(const OutputSet&)>& write) {
  OutputSet outputs;
  for (const auto& file : files)
    if (auto announced = outputs.announce(file); !announced) return announced;
  auto written = write(outputs);
  if (written) return outputs.commit();
  return passOn(outputs.inGivenNames(std::move(written.error())));
}

}  // namespace ew
