#include "start/thumbnails.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QImageReader>
#include <QSaveFile>

#include "ew/core/version.h"
#include "ew/library/case.h"
#include "ew/library/case_card.h"
#include "ew/scanning/first_image.h"
#include "ew/widgets/qt_image.h"
#include "ew/widgets/words.h"

namespace ew::ui {
namespace {

QDir folder() { return {wordsOf(cacheFolder() / "thumbnails")}; }

/// Of one case, whatever its state.
QString stemOf(const Case& shown) {
  const QByteArray place = wordsOf(shown.folder).toUtf8();
  return words(shown.id) + QLatin1Char('-') +
         QString::fromLatin1(QCryptographicHash::hash(place, QCryptographicHash::Sha1).toHex().left(8));
}

QString fileOf(const Case& shown, const QSize& size) {
  // 3: as it is scanned, with labels and their tissues, and begins: with its preset.
  QStringList parts{QLatin1String(kVersion), QStringLiteral("3"), QStringLiteral("%1x%2").arg(size.width()).arg(size.height())};
  QDirIterator files(wordsOf(shown.folder), QDir::Files, QDirIterator::Subdirectories);
  while (files.hasNext()) {
    files.next();
    const QFileInfo info = files.fileInfo();
    parts << QStringLiteral("%1 %2 %3").arg(info.filePath()).arg(info.size()).arg(info.lastModified().toMSecsSinceEpoch());
  }
  parts.sort();
  const QByteArray key = QCryptographicHash::hash(parts.join(QLatin1Char('\n')).toUtf8(), QCryptographicHash::Sha1).toHex();
  return stemOf(shown) + QLatin1Char('-') + QString::fromLatin1(key.left(16)) + QStringLiteral(".png");
}

}  // namespace

QImage keptThumbnail(const Case& shown, const QSize& size) {
  QImage kept;
  if (!kept.load(folder().filePath(fileOf(shown, size)), "PNG") || kept.size() != size) return {};
  return kept;
}

void keepThumbnail(const Case& shown, const QImage& image) {
  if (image.isNull() || !folder().mkpath(QStringLiteral("."))) return;
  const QString name = fileOf(shown, image.size());
  QSaveFile file(folder().filePath(name));
  if (!file.open(QIODevice::WriteOnly) || !image.save(&file, "PNG") || !file.commit()) return;
  for (const QString& old : folder().entryList({stemOf(shown) + QStringLiteral("-*.png")}, QDir::Files)) {
    if (old != name) QFile::remove(folder().filePath(old));
  }
}

QImage thumbnailOf(const ScanSubject& subject, const Beginnings& there, const QSize& size) {
  Scanner scanner;
  const auto image = firstImage(scanner, subject, there, size.width(), size.height());
  return image ? imageOf(*image).copy() : QImage();
}

QImage broughtThumbnail(const Case& shown) {
  constexpr qint64 kMost_bytes = 4 << 20;
  const QSize whole(kCardImageWidth_px, kCardImageHeight_px + kCardStripHeight_px);
  QFile file(wordsOf(shown.folder / kCardName));
  if (file.size() > kMost_bytes || !file.open(QIODevice::ReadOnly)) return {};
  QImageReader reader(&file, "png");
  if (reader.size() != whole) return {};  // before anything is unpacked
  return reader.read().copy(0, 0, kCardImageWidth_px, kCardImageHeight_px);
}

}  // namespace ew::ui
