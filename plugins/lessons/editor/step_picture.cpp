#include "editor/step_picture.h"

#include <QBuffer>
#include <QColorSpace>
#include <QImageReader>
#include <QImageWriter>
#include <QPainter>

namespace ew::lessons {
namespace {

constexpr int kLongestSide_px = 2048;
constexpr qint64 kMostPixels = 100'000'000;

/// The pixels in an image that has never held anything else: a copy would take texts and profiles along.
QImage pixelsAlone(const QImage& picture, bool hasAlpha) {
  QImage made(picture.size(), hasAlpha ? QImage::Format_ARGB32 : QImage::Format_RGB32);
  made.fill(hasAlpha ? Qt::transparent : Qt::black);
  QPainter painter(&made);
  painter.drawImage(0, 0, picture);
  return made;
}

}  // namespace

Result<CleanPicture> cleanPicture(const std::filesystem::path& file) {
  const QString name = QString::fromStdString(file.string());
  if (std::error_code ignored; !std::filesystem::is_regular_file(file, ignored))
    return failure(ErrorCode::notFound, say<"There is no picture '%1'; choose another.">(file), {{"file", file.string()}});
  QImageReader reader(name);
  reader.setDecideFormatFromContent(true);
  reader.setAutoTransform(true);  // as the camera was held: what says so goes with the rest
  const QByteArray format = reader.format();
  if (format != "png" && format != "jpeg")
    return failure(ErrorCode::unsupported, say<"'%1' is neither a PNG nor a JPEG picture; choose one of these.">(file),
                   {{"file", file.string()}});
  const QSize size = reader.size();
  if (static_cast<qint64>(size.width()) * size.height() > kMostPixels)
    return failure(ErrorCode::tooLarge, say<"The picture '%1' has more than 100 million pixels; make it smaller first.">(file),
                   {{"file", file.string()}});
  QImage picture = reader.read();
  if (picture.isNull())
    return failure(ErrorCode::notReadable,
                   say<"The picture '%1' cannot be read (%2); choose another.">(file, reader.errorString().toStdString()),
                   {{"file", file.string()}});
  if (picture.colorSpace().isValid()) picture.convertToColorSpace(QColorSpace::SRgb);
  if (std::max(picture.width(), picture.height()) > kLongestSide_px)
    picture = picture.scaled(kLongestSide_px, kLongestSide_px, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  const bool isJpeg = format == "jpeg";
  CleanPicture made;
  made.ending = isJpeg ? ".jpg" : ".png";
  QBuffer buffer(&made.bytes);
  buffer.open(QIODevice::WriteOnly);
  QImageWriter writer(&buffer, isJpeg ? "jpeg" : "png");
  if (isJpeg) writer.setQuality(90);
  if (!writer.write(pixelsAlone(picture, picture.hasAlphaChannel() && !isJpeg)))
    return failure(ErrorCode::notReadable,
                   say<"The picture '%1' cannot be read (%2); choose another.">(file, writer.errorString().toStdString()),
                   {{"file", file.string()}});
  return made;
}

}  // namespace ew::lessons
