#include "panel/images_field.h"

#include <QBuffer>
#include <QCryptographicHash>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace ew::case_authoring {
namespace {

constexpr int kThumbnail_px = 72;
constexpr int kJpegQuality = 92;
constexpr int kDigits = 16;

QImage pixelsOf(const QImage& image) {
  // Painted anew: whatever a file carries beside its pixels stays behind.
  QImage clean(image.size(), QImage::Format_RGB32);
  clean.fill(Qt::black);
  QPainter(&clean).drawImage(0, 0, image);
  return clean;
}

}  // namespace

Result<CleanImage> cleanImage(const std::filesystem::path& file) {
  const QString path = words(file.string());
  const QFileInfo info(path);
  if (!info.exists()) return failure(ErrorCode::notFound, say<"There is no image '%1'; choose it again.">(file), {{"file", file.string()}});
  if (info.size() > kMostImageBytes)
    return failure(ErrorCode::tooLarge, say<"The image '%1' is larger than 20 MB; make it smaller first.">(file.filename()),
                   {{"file", file.string()}});
  QImageReader reader(path);
  reader.setDecideFormatFromContent(true);
  reader.setAutoTransform(true);
  const QByteArray format = reader.format();
  if (format != "png" && format != "jpeg")
    return failure(ErrorCode::unsupported, say<"'%1' is not a PNG or JPEG image; save it as one of these first.">(file.filename()),
                   {{"file", file.string()}});
  const QSize size = reader.size();
  if (std::max(size.width(), size.height()) > kLongestSide_px)
    reader.setScaledSize(size.scaled(kLongestSide_px, kLongestSide_px, Qt::KeepAspectRatio));
  const QImage image = reader.read();
  if (image.isNull())
    return failure(ErrorCode::unsupported, say<"The image '%1' is damaged; choose another.">(file.filename()), {{"file", file.string()}});
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  const bool isPng = format == "png";
  if (!pixelsOf(image).save(&buffer, isPng ? "PNG" : "JPG", isPng ? -1 : kJpegQuality))
    return failure(ErrorCode::unsupported, say<"The image '%1' is damaged; choose another.">(file.filename()), {{"file", file.string()}});
  return CleanImage{bytes.toStdString(), isPng ? ".png" : ".jpg"};
}

std::string imageName(const CleanImage& image) {
  const QByteArray sum = QCryptographicHash::hash(QByteArray::fromStdString(image.bytes), QCryptographicHash::Sha256).toHex();
  return "media/" + sum.left(kDigits).toStdString() + image.ending;
}

ImagesField::ImagesField(const QString& name, const std::filesystem::path& folder, const std::vector<std::string>& images, QWidget* parent)
    : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  constexpr std::size_t kInARow = 3;
  QHBoxLayout* row = nullptr;
  for (std::size_t n = 0; n < images.size(); ++n) {
    if (n % kInARow == 0) {
      row = new QHBoxLayout;
      row->setSpacing(kGrid_px);
      column->addLayout(row);
    }
    auto* cell = new QWidget;
    cell->setFixedSize(kThumbnail_px, kThumbnail_px);
    auto* shown = new QLabel(cell);
    shown->setObjectName(name + QStringLiteral("picture_%1").arg(n));
    shown->setFixedSize(kThumbnail_px, kThumbnail_px);
    shown->setAlignment(Qt::AlignCenter);
    shown->setFrameShape(QFrame::StyledPanel);
    shown->setToolTip(words(images[n]));
    QImageReader reader(words((folder / images[n]).string()));
    const QSize size = reader.size();
    if (size.isValid()) reader.setScaledSize(size.scaled(kThumbnail_px, kThumbnail_px, Qt::KeepAspectRatio));
    const QImage image = reader.read();
    if (image.isNull())
      shown->setText(tr("missing"));
    else
      shown->setPixmap(QPixmap::fromImage(image));
    auto* away = new QToolButton(cell);
    away->setObjectName(name + QStringLiteral("removePicture_%1").arg(n));
    away->setText(QStringLiteral("×"));
    away->setToolTip(tr("Take this image out of the case"));
    away->setAccessibleName(tr("Take this image out of the case"));
    away->adjustSize();
    away->move(kThumbnail_px - away->sizeHint().width(), 0);
    connect(away, &QToolButton::clicked, this, [this, n] {
      if (onRemove) onRemove(n);
    });
    row->addWidget(cell);
    if (n + 1 == images.size() || (n + 1) % kInARow == 0) row->addStretch(1);
  }
  auto* add = new QPushButton(tr("Add images…"));
  add->setObjectName(name + QStringLiteral("addPictures"));
  add->setToolTip(
      tr("PNG or JPEG; kept without what their files say of patient and device. Look that no name stands in the image itself."));
  connect(add, &QPushButton::clicked, this, [this] {
    if (onAdd) onAdd();
  });
  column->addWidget(add, 0, Qt::AlignLeft);
}

}  // namespace ew::case_authoring
