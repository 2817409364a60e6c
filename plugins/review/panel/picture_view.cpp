#include "panel/picture_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "ew/sdk/panel.h"
#include "panel/look.h"

namespace ew::review {

using sdk::kGap_px;
using sdk::words;

namespace {

// On the black of a scan, whatever the window's theme.
const QColor kScanQuiet(0x9b, 0xa1, 0xa8);
const QColor kScanBright(0xe9, 0xeb, 0xed);
const QColor kDiffers(0xf2, 0xd0, 0x6b);
constexpr int kLargest_px = 720;       // of an image that is made live; a larger view scales it
constexpr double kComment_s = 1.0;     // so near to its moment a drawing is seen
constexpr double kLeastStep_mm = 0.3;  // between two points of a line

/// Two columns of settings below each other.
constexpr int kSettingColumns = 2, kSettingRows = 5;

}  // namespace

PictureView::PictureView(Side side, ReviewSession& session, QWidget* parent) : QWidget(parent), side_(side), session_(session) {
  setObjectName(side == kReviewed ? QStringLiteral("reviewedPicture") : QStringLiteral("comparedPicture"));
  setAccessibleName(side == kReviewed ? tr("The trainee's image") : tr("The expert's image"));
  setMinimumSize(160, 160);
  setFocusPolicy(Qt::ClickFocus);
  setLayoutDirection(Qt::LeftToRight);
  setAttribute(Qt::WA_OpaquePaintEvent);
  connect(&maker_, &PictureMaker::made, this, &PictureView::show);
  connect(&session_, &ReviewSession::scansChanged, this, [this] {
    const auto scan = session_.sharedScan(side_);
    picture_.reset();
    if (source_.lock() != scan) drawn_.clear();  // told as well when what it is compared with changes
    source_ = scan;
    maker_.show(scan ? scan->scan : nullptr, scan ? std::optional(scan->subject) : std::nullopt);
    ask();
    update();
  });
  connect(&session_, &ReviewSession::timeChanged, this, [this] {
    ask();
    update();
  });
  connect(&session_, &ReviewSession::commentsChanged, this, [this] { update(); });
}

PictureView::~PictureView() = default;

bool PictureView::isIdle() const { return maker_.isIdle(); }

void PictureView::setTool(std::optional<CommentStroke::Kind> tool) {
  tool_ = tool;
  drawing_.reset();
  setCursor(tool_ ? Qt::CrossCursor : Qt::ArrowCursor);
}

void PictureView::setDrawn(std::vector<CommentStroke> strokes) {
  drawn_ = std::move(strokes);
  update();
  Q_EMIT drawnChanged();
}

int PictureView::headHeight() const { return withText(28, font()); }
/// Where all of them would leave the image less than twice their own height, only those are written that differ.
bool PictureView::showsAllSettings() const { return height() - headHeight() >= 3 * settingsHeight(kSettingRows); }
int PictureView::settingsHeight(int rows) const { return rows * withText(17, font()) + kGap_px; }
int PictureView::settingsHeight() const { return settingsHeight(showsAllSettings() ? kSettingRows : 1); }

QRectF PictureView::imageRect() const { return QRectF(0, headHeight(), width(), std::max(40, height() - headHeight() - settingsHeight())); }

void PictureView::ask() {
  if (session_.opened(side_) == nullptr || !isVisible()) return;
  const QSizeF room = imageRect().size();
  const double scale = std::min(1.0, kLargest_px / std::max(room.width(), room.height()));
  maker_.want(session_.frame(side_), (room * scale).toSize());
}

void PictureView::show(const std::shared_ptr<const MadePicture>& picture) {
  picture_ = picture;
  showSettings();
  if (other_ != nullptr) other_->showSettings();  // its settings may differ from new ones
  Q_EMIT shown();
}

void PictureView::showSettings() {
  setToolTip(showsAllSettings() ? QString() : shownSettings().join(QLatin1Char('\n')));
  update();
}

void PictureView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showSettings();
  ask();
}

QPointF PictureView::pixelOf(const glm::dvec2& p_mm) const {
  if (!picture_ || picture_->geometry.pixel_mm <= 0.0) return {};
  const glm::dvec3 at = carried(inverse(picture_->geometry.imageToProbe()), glm::dvec3(p_mm, 0.0));
  const QRectF box = imageRect();
  const double scale = box.width() / std::max(1, picture_->image.width());
  return box.topLeft() + scale * QPointF(at.x + 0.5, at.y + 0.5);
}

glm::dvec2 PictureView::pointAt(const QPointF& at) const {
  if (!picture_) return glm::dvec2(0.0);
  const QRectF box = imageRect();
  const double scale = std::max(1, picture_->image.width()) / box.width();
  const glm::dvec3 pixel((at.x() - box.left()) * scale - 0.5, (at.y() - box.top()) * scale - 0.5, 0.0);
  return glm::dvec2(carried(picture_->geometry.imageToProbe(), pixel));
}

QStringList PictureView::shownSettings() const {
  QStringList lines;
  if (!picture_) return lines;
  const std::vector<Setting> own = settingsOf(picture_->state);
  const std::vector<Setting> others = other_ != nullptr && other_->picture_ ? settingsOf(other_->picture_->state) : own;
  for (std::size_t n = 0; n < own.size(); ++n) {
    const QString line = words(own[n].name) + QLatin1Char(' ') + words(own[n].value);
    lines << (own[n].value == others[n].value ? line : QStringLiteral("≠ ") + line);
  }
  if (other_ != nullptr && other_->picture_ && picture_->state.scene != other_->picture_->state.scene)
    lines << QStringLiteral("≠ ") + tr("effects of the image");
  return lines;
}

void PictureView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), Qt::black);
  paintHead(painter);
  if (session_.opened(side_) == nullptr) return paintEmpty(painter);
  paintImage(painter);
  paintSettings(painter);
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

void PictureView::paintHead(QPainter& painter) const {
  const Who who = session_.whoOf(side_);
  const QColor colour = colourOf(who, true);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  drawMarkOf(painter, who, QPointF(2.0 * kGap_px, 0.5 * headHeight()), withText(5, font()));
  QFont bold = font();
  bold.setWeight(QFont::DemiBold);
  painter.setFont(bold);
  const QString word = wordOf(who);
  const int wide = QFontMetrics(bold).horizontalAdvance(word);
  painter.setPen(colour);
  painter.drawText(QRect(4 * kGap_px, 0, wide + 2, headHeight()), Qt::AlignLeft | Qt::AlignVCenter, word);
  painter.setFont(smaller(*this));
  painter.setPen(kScanQuiet);
  const QString time =
      session_.opened(side_) == nullptr ? QString() : clockText(session_.time_s(side_) - session_.opened(side_)->scan->part.begin_s);
  const int timeWide = painter.fontMetrics().horizontalAdvance(QStringLiteral("-00:00.0"));
  painter.drawText(QRect(width() - timeWide - kGap_px, 0, timeWide, headHeight()), Qt::AlignRight | Qt::AlignVCenter, time);
  const QRect room(4 * kGap_px + wide + kGap_px, 0, width() - timeWide - wide - 7 * kGap_px, headHeight());
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                   painter.fontMetrics().elidedText(session_.titleOfScan(side_), Qt::ElideRight, room.width()));
}

void PictureView::paintEmpty(QPainter& painter) const {
  painter.setFont(smaller(*this));
  painter.setPen(kScanQuiet);
  const QString sentence = session_.isOpening()            ? tr("Opening …")
                           : !session_.problem().isEmpty() ? session_.problem()
                           : side_ == kReviewed            ? (session_.attempt() == nullptr ? tr("No attempt is chosen.")
                                                                                            : tr("This step was not recorded in this attempt."))
                                                           : tr("Nothing to compare with is chosen.");
  painter.drawText(imageRect().adjusted(2 * kGap_px, 0, -2 * kGap_px, 0), Qt::AlignCenter | Qt::TextWordWrap, sentence);
}

void PictureView::paintImage(QPainter& painter) {
  if (!picture_) return;
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF box = imageRect();
  const double scale = box.width() / std::max(1, picture_->image.width());
  painter.drawImage(QRectF(box.topLeft(), QSizeF(picture_->image.size()) * scale), picture_->image);
  if (picture_->state.pose.status != PoseStatus::ok) {
    painter.setFont(smaller(*this));
    painter.setPen(kDiffers);
    painter.drawText(box, Qt::AlignCenter, tr("The pose of the probe is not known here"));
  }
  if (side_ != kReviewed) return;
  painter.save();
  painter.setClipRect(box);
  const double here_s = session_.time_s(kReviewed);
  for (const ReviewComment& each : session_.commentsHere()) {
    const bool isChosen = each.id == session_.chosenComment();
    if (std::abs(each.time_s - here_s) > kComment_s) continue;
    for (const CommentStroke& stroke : each.strokes) paintStroke(painter, stroke, isChosen ? kDiffers : kScanBright);
  }
  for (const CommentStroke& stroke : drawn_) paintStroke(painter, stroke, kDiffers);
  if (drawing_) paintStroke(painter, *drawing_, kDiffers);
  painter.restore();
}

void PictureView::paintStroke(QPainter& painter, const CommentStroke& stroke, const QColor& colour) const {
  if (stroke.points_mm.size() < 2) return;
  QPainterPath path(pixelOf(stroke.points_mm.front()));
  if (stroke.kind == CommentStroke::Kind::circle) {
    const QPointF middle = pixelOf(stroke.points_mm[0]);
    const QPointF way = pixelOf(stroke.points_mm[1]) - middle;
    const double radius = std::hypot(way.x(), way.y());
    path = QPainterPath();
    path.addEllipse(middle, radius, radius);
  } else {
    for (std::size_t n = 1; n < stroke.points_mm.size(); ++n) path.lineTo(pixelOf(stroke.points_mm[n]));
  }
  if (stroke.kind == CommentStroke::Kind::arrow) {
    const QPointF tip = pixelOf(stroke.points_mm[1]);
    const QPointF way = tip - pixelOf(stroke.points_mm[0]);
    const double length = std::hypot(way.x(), way.y());
    const QPointF along = length > 0.0 ? way / length : QPointF(0, 1);
    const QPointF across(-along.y(), along.x());
    for (const double side : {-1.0, 1.0}) {
      path.moveTo(tip);
      path.lineTo(tip - 10.0 * along + side * 5.0 * across);
    }
  }
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 150), 4.5, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
  painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.drawPath(path);
}

void PictureView::paintSettings(QPainter& painter) const {
  QStringList lines = shownSettings();
  if (!showsAllSettings()) lines = lines.filter(QRegularExpression(QStringLiteral("^≠"))).mid(0, kSettingColumns);
  painter.setFont(smaller(*this));
  const int row = withText(17, font());
  const double wide = (width() - 2.0 * kGap_px) / kSettingColumns;
  const double top = height() - settingsHeight() + 0.5 * kGap_px;
  const int rows = (static_cast<int>(lines.size()) + kSettingColumns - 1) / kSettingColumns;
  for (int n = 0; n < lines.size(); ++n) {
    const bool differs = lines[n].startsWith(QStringLiteral("≠"));
    painter.setPen(differs ? kDiffers : kScanQuiet);
    const QRectF room(kGap_px + wide * (n / rows), top + row * (n % rows), wide - kGap_px, row);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(lines[n], Qt::ElideRight, static_cast<int>(room.width())));
  }
}

void PictureView::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  if (!tool_ || side_ != kReviewed || !picture_ || event->button() != Qt::LeftButton) return;
  session_.pause();
  drawing_ = CommentStroke{*tool_, {pointAt(event->localPos())}};
}

void PictureView::mouseMoveEvent(QMouseEvent* event) {
  if (!drawing_) return;
  const glm::dvec2 here = pointAt(event->localPos());
  if (drawing_->kind == CommentStroke::Kind::line) {
    if (glm::distance(drawing_->points_mm.back(), here) >= kLeastStep_mm) drawing_->points_mm.push_back(here);
  } else {
    drawing_->points_mm.resize(1);
    drawing_->points_mm.push_back(here);
  }
  update();
}

void PictureView::mouseReleaseEvent(QMouseEvent* event) {
  if (!drawing_) return;
  mouseMoveEvent(event);
  const bool isDrawn = drawing_->points_mm.size() > 1 && glm::distance(drawing_->points_mm.front(), drawing_->points_mm.back()) > 0.0;
  if (isDrawn || drawing_->points_mm.size() > 2) drawn_.push_back(*drawing_);
  drawing_.reset();
  update();
  Q_EMIT drawnChanged();
}

}  // namespace ew::review
