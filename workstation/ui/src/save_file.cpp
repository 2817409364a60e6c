#include "save_file.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "ew/core/output_set.h"
#include "words.h"

namespace ew::ui {
namespace {

struct SaveFileWords {
  Q_DECLARE_TR_FUNCTIONS(ew::ui::SaveFile)
};

QString completed(const QString& file, const QStringList& endings) {
  const bool ends =
      std::any_of(endings.begin(), endings.end(), [&](const QString& ending) { return file.endsWith(ending, Qt::CaseInsensitive); });
  return ends || endings.isEmpty() ? file : file + endings.front();
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

}  // namespace

QString askSaveFile(QWidget* parent, const SaveFile& asked) {
  QString proposal = asked.proposal;
  while (true) {
    QFileDialog dialog(parent, asked.title, QFileInfo(proposal).path(), asked.filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setFileMode(QFileDialog::AnyFile);
    // The dialog knows the name that was typed, not the files that will be written: those are asked about below.
    dialog.setOption(QFileDialog::DontConfirmOverwrite);
    dialog.selectFile(proposal);
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
    const QString file = completed(dialog.selectedFiles().constFirst(), asked.endings);
    QStringList there;
    for (const QString& name : asked.written ? asked.written(file) : QStringList{file})
      for (const auto& written : filesNamedBy(pathOf(name)))
        if (const QFileInfo info(wordsOf(written)); info.exists() || info.isSymLink()) there << info.filePath();
    const Answer answer = there.isEmpty() ? Answer::replace : mayReplace(parent, asked.title, there);
    if (answer == Answer::replace) return file;
    if (answer == Answer::cancel) return {};
    proposal = file;
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

}  // namespace ew::ui
