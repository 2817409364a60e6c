#include "editor/step_image.h"

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
QImage pixelsAlone(const QImage& image, bool hasAlpha) {
  QImage made(image.size(), hasAlpha ? QImage::Format_ARGB32 : QImage::Format_RGB32);
  made.fill(hasAlpha ? Qt::transparent : Qt::black);
  QPainter painter(&made);
  painter.drawImage(0, 0, image);
  return made;
}

}  // namespace

Result<CleanImage> cleanImage(const std::filesystem::path& file) {
  const QString name = QString::fromStdString(file.string());
  if (std::error_code ignored; !std::filesystem::is_regular_file(file, ignored))
    return failure(ErrorCode::notFound, say<"There is no image '%1'; choose another.">(file), {{"file", file.string()}});
  QImageReader reader(name);
  reader.setDecideFormatFromContent(true);
  reader.setAutoTransform(true);  // as the camera was held: what says so goes with the rest
  const QByteArray format = reader.format();
  if (format != "png" && format != "jpeg")
    return failure(ErrorCode::unsupported, say<"'%1' is neither a PNG nor a JPEG image; choose one of these.">(file),
                   {{"file", file.string()}});
  const QSize size = reader.size();
  if (static_cast<qint64>(size.width()) * size.height() > kMostPixels)
    return failure(ErrorCode::tooLarge, say<"The image '%1' has more than 100 million pixels; make it smaller first.">(file),
                   {{"file", file.string()}});
  QImage image = reader.read();
  if (image.isNull())
    return failure(ErrorCode::notReadable,
                   say<"The image '%1' cannot be read (%2); choose another.">(file, reader.errorString().toStdString()),
                   {{"file", file.string()}});
  if (image.colorSpace().isValid()) image.convertToColorSpace(QColorSpace::SRgb);
  if (std::max(image.width(), image.height()) > kLongestSide_px)
    image = image.scaled(kLongestSide_px, kLongestSide_px, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  const bool isJpeg = format == "jpeg";
  CleanImage made;
  made.ending = isJpeg ? ".jpg" : ".png";
  QBuffer buffer(&made.bytes);
  buffer.open(QIODevice::WriteOnly);
  QImageWriter writer(&buffer, isJpeg ? "jpeg" : "png");
  if (isJpeg) writer.setQuality(90);
  if (!writer.write(pixelsAlone(image, image.hasAlphaChannel() && !isJpeg)))
    return failure(ErrorCode::notReadable,
                   say<"The image '%1' cannot be read (%2); choose another.">(file, writer.errorString().toStdString()),
                   {{"file", file.string()}});
  return made;
}

}  // namespace ew::lessons
