#include "save_place.h"

#include <QFileInfo>
#include <QRegularExpression>
#include <QStandardPaths>
#include <algorithm>

namespace ew {
namespace {

constexpr int kLongestName_bytes = 160;  // of 255, less an ending, a date and what is written beside

QString keyOf(const QStringList& endings) {
  QString kind = endings.isEmpty() ? QStringLiteral("any") : endings.front();
  while (kind.startsWith(QLatin1Char('.'))) kind.remove(0, 1);
  return QStringLiteral("saveFolders/") + kind;
}

/// The ending with its dot; empty: there is none.
QString endingOf(const QString& name, const QStringList& endings) {
  QString longest;
  for (const QString& each : endings)
    if (each.size() > longest.size() && name.endsWith(each, Qt::CaseInsensitive)) longest = name.right(each.size());
  if (!longest.isEmpty()) return longest;
  const int dot = name.lastIndexOf(QLatin1Char('.'));
  return dot > 0 ? name.mid(dot) : QString();
}

}  // namespace

QString nameForFiles(const QString& text) {
  static const QRegularExpression refused(QStringLiteral(R"([<>:"/\\|?*\x00-\x1f\x7f])"));
  static const QRegularExpression kept(QStringLiteral("^(con|prn|aux|nul|com[0-9]|lpt[0-9])(\\.|$)"),
                                       QRegularExpression::CaseInsensitiveOption);
  QString name = text;
  name.replace(refused, QStringLiteral(" "));
  name = name.simplified();
  while (name.startsWith(QLatin1Char('.')) || name.startsWith(QLatin1Char(' '))) name.remove(0, 1);  // it would be hidden
  while (name.toUtf8().size() > kLongestName_bytes) name.chop(name.size() > 1 && name.at(name.size() - 1).isLowSurrogate() ? 2 : 1);
  while (name.endsWith(QLatin1Char('.')) || name.endsWith(QLatin1Char(' '))) name.chop(1);
  return kept.match(name).hasMatch() ? QLatin1Char('_') + name : name;
}

QString datedName(const QString& proposal, const QStringList& endings, const QDateTime& when) {
  const QString ending = endingOf(proposal, endings);
  const QString stem = nameForFiles(proposal.left(proposal.size() - ending.size()));
  const QString date = when.toString(QStringLiteral("yyyy-MM-dd HH.mm"));
  return (stem.isEmpty() ? date : stem + QLatin1Char(' ') + date) + ending;
}

QString folderForSaving(const QStringList& endings, const QSettings& settings) {
  if (const QString last = settings.value(keyOf(endings)).toString(); !last.isEmpty() && QFileInfo(last).isDir()) return last;
  const bool isImage = endings.contains(QStringLiteral(".png"), Qt::CaseInsensitive);
  for (const auto place : {isImage ? QStandardPaths::PicturesLocation : QStandardPaths::DocumentsLocation,
                           QStandardPaths::DocumentsLocation, QStandardPaths::HomeLocation})
    if (const QString folder = QStandardPaths::writableLocation(place); !folder.isEmpty() && QFileInfo(folder).isDir()) return folder;
  return QStandardPaths::writableLocation(QStandardPaths::HomeLocation);
}

void keepFolderForSaving(const QStringList& endings, const QString& file, QSettings& settings) {
  settings.setValue(keyOf(endings), QFileInfo(file).absolutePath());
}

}  // namespace ew
