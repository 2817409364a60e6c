#include "ew/widgets/icons.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>
#include <optional>
#include <utility>

#include "ew/widgets/theme.h"

namespace ew {
namespace {

/// Renders the SVG at whatever size is asked for; a pixmap made once would blur on a dense screen. Without a colour of its own in that of
/// the theme's text at the moment it is painted, so that another theme needs no new icons.
class LineIcon final : public QIconEngine {
 public:
  LineIcon(QByteArray svg, std::optional<QColor> colour) : svg_(std::move(svg)), colour_(std::move(colour)) {}

  void paint(QPainter* painter, const QRect& box, QIcon::Mode mode, QIcon::State) override {
    QColor colour = colour_.value_or(currentTheme().text);
    if (mode == QIcon::Disabled) colour.setAlphaF(0.4);
    QByteArray coloured = svg_;
    coloured.replace("currentColor", colour.name().toLatin1());
    QSvgRenderer renderer(coloured);
    painter->save();
    painter->setOpacity(colour.alphaF());
    renderer.render(painter, box);
    painter->restore();
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap image(size);
    image.fill(Qt::transparent);
    QPainter painter(&image);
    paint(&painter, QRect(QPoint(0, 0), size), mode, state);
    return image;
  }

  [[nodiscard]] QIconEngine* clone() const override { return new LineIcon(svg_, colour_); }

 private:
  QByteArray svg_;
  std::optional<QColor> colour_;
};

QIcon iconFrom(const QString& name, std::optional<QColor> colour) {
  QFile file(QStringLiteral(":/ew/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QIcon(new LineIcon(file.readAll(), std::move(colour)));
}

}  // namespace

QIcon icon(const QString& name, const QColor& colour) { return iconFrom(name, colour); }

QIcon iconOf(const QByteArray& svg, const QColor& colour) { return QIcon(new LineIcon(svg, colour)); }

QIcon icon(const QString& name) { return iconFrom(name, std::nullopt); }

}  // namespace ew
