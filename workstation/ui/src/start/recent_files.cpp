#include "start/recent_files.h"

#include <QDir>
#include <QFileInfo>

#include "ew/library/case.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

/// The folder of a case, by whichever of its names it was opened.
QString folderOf(const QString& path) {
  const QFileInfo info(path);
  const QString folder = info.isDir() || info.fileName() != QLatin1String("case.json") ? info.absoluteFilePath() : info.absolutePath();
  return QDir::cleanPath(folder);
}

}  // namespace

RecentFile recentFileOf(const QString& path, bool forAuthors) {
  const QFileInfo info(path);
  const bool isCase = (info.isDir() && QFileInfo::exists(path + QStringLiteral("/case.json"))) || info.suffix() == QLatin1String("json");
  if (isCase) {
    if (const auto opened = loadCase(pathOf(path))) {
      return {path, words(forAuthors ? opened->title : titleForTrainees(*opened)), forAuthors ? path : words(opened->region)};
    }
  }
  const QString name = info.fileName();
  return {path, name.isEmpty() ? path : name, path};
}

std::vector<RecentFile> recentFilesOf(const QStringList& paths, bool forAuthors, const QStringList& shownElsewhere) {
  std::vector<RecentFile> files;
  for (const QString& path : paths) {
    if (!shownElsewhere.contains(folderOf(path))) files.push_back(recentFileOf(path, forAuthors));
  }
  return files;
}

}  // namespace ew::ui
