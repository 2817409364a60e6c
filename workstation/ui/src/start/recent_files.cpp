#include "start/recent_files.h"

#include <QDir>
#include <QFileInfo>
#include <QMetaObject>

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

QString fileNameOf(const QString& path) {
  const QString name = QFileInfo(path).fileName();
  return name.isEmpty() ? path : name;
}

RecentFiles::RecentFiles(QObject* parent) : QObject(parent) {}
RecentFiles::~RecentFiles() = default;

std::optional<RecentFiles::CaseNames> RecentFiles::namesAt(const QString& path) {
  const QFileInfo info(path);
  const bool isCase = (info.isDir() && QFileInfo::exists(path + QStringLiteral("/case.json"))) || info.suffix() == QLatin1String("json");
  if (!isCase) return std::nullopt;
  const auto opened = loadCase(pathOf(path));
  if (!opened) return std::nullopt;
  return CaseNames{words(opened->title), words(titleForTrainees(*opened)), words(opened->region)};
}

void RecentFiles::read(const QStringList& paths) {
  ++waiting_;
  worker_.add([this, paths] {
    Known found;
    for (const QString& path : paths) found.insert(path, namesAt(path));
    QMetaObject::invokeMethod(
        this, [this, found] { take(found); }, Qt::QueuedConnection);
  });
}

void RecentFiles::take(const Known& found) {
  --waiting_;
  const Known before = known_;
  for (auto each = found.begin(); each != found.end(); ++each) known_.insert(each.key(), each.value());
  if (known_ != before) Q_EMIT changed();
}

std::vector<RecentFile> RecentFiles::of(const QStringList& paths, bool forAuthors, const QStringList& shownElsewhere) const {
  std::vector<RecentFile> files;
  for (const QString& path : paths) {
    const auto known = known_.constFind(path);
    if (known == known_.constEnd() || shownElsewhere.contains(folderOf(path))) continue;
    if (const std::optional<CaseNames>& names = *known)
      files.push_back({path, forAuthors ? names->title : names->titleForTrainees, forAuthors ? path : names->region});
    else
      files.push_back({path, fileNameOf(path), path});
  }
  return files;
}

}  // namespace ew::ui
