#include "panel/image_view.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "ew/widgets/figures.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/review_words.h"
#include "panel/session/review_session.h"

namespace ew::review {

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

ImageView::ImageView(Side side, ReviewSession& session, QWidget* parent)
    : QWidget(parent),
      side_(side),
      scans_(session.scans()),
      selection_(session.selection()),
      reviewer_(session.reviewer()),
      playback_(session.playback()),
      comments_(session.comments()) {
  setObjectName(side == kReviewed ? QStringLiteral("reviewedPicture") : QStringLiteral("comparedPicture"));
  setAccessibleName(side == kReviewed ? tr("The trainee's image") : tr("The expert's image"));
  setMinimumSize(160, 160);
  setFocusPolicy(Qt::ClickFocus);
  setLayoutDirection(Qt::LeftToRight);
  setAttribute(Qt::WA_OpaquePaintEvent);
  connect(&maker_, &ImageMaker::made, this, &ImageView::show);
  connect(&scans_, &ScanPair::changed, this, [this] {
    const auto scan = scans_.sharedScan(side_);
    shown_.reset();
    if (source_.lock() != scan) drawn_.clear();  // told as well when what it is compared with changes
    source_ = scan;
    maker_.show(scan ? scan->scan : nullptr, scan ? std::optional(scan->subject) : std::nullopt);
    ask();
    update();
  });
  connect(&playback_, &Playback::timeChanged, this, [this] {
    ask();
    update();
  });
  connect(&comments_, &AttemptComments::changed, this, [this] { update(); });
}

ImageView::~ImageView() = default;

bool ImageView::isIdle() const { return maker_.isIdle(); }

void ImageView::setTool(std::optional<CommentStroke::Kind> tool) {
  tool_ = tool;
  drawing_.reset();
  setCursor(tool_ ? Qt::CrossCursor : Qt::ArrowCursor);
}

void ImageView::setDrawn(std::vector<CommentStroke> strokes) {
  drawn_ = std::move(strokes);
  update();
  Q_EMIT drawnChanged();
}

int ImageView::headHeight() const { return scaled(28); }
/// Where all of them would leave the image less than twice their own height, only those are written that differ.
bool ImageView::showsAllSettings() const { return height() - headHeight() >= 3 * settingsHeight(kSettingRows); }
int ImageView::settingsHeight(int rows) const { return rows * scaled(17) + kGrid_px; }
int ImageView::settingsHeight() const { return settingsHeight(showsAllSettings() ? kSettingRows : 1); }

QRectF ImageView::imageRect() const { return QRectF(0, headHeight(), width(), std::max(40, height() - headHeight() - settingsHeight())); }

void ImageView::ask() {
  if (scans_.opened(side_) == nullptr || !isVisible()) return;
  const QSizeF room = imageRect().size();
  const double scale = std::min(1.0, kLargest_px / std::max(room.width(), room.height()));
  maker_.want(playback_.frame(side_), (room * scale).toSize());
}

void ImageView::show(const std::shared_ptr<const ReplayImage>& image) {
  shown_ = image;
  showSettings();
  if (other_ != nullptr) other_->showSettings();  // its settings may differ from new ones
}

void ImageView::showSettings() {
  setToolTip(showsAllSettings() ? QString() : shownSettings().join(QLatin1Char('\n')));
  update();
}

void ImageView::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  showSettings();
  ask();
}

QPointF ImageView::pixelOf(const glm::dvec2& p_mm) const {
  if (!shown_ || shown_->geometry.pixel_mm <= 0.0) return {};
  const glm::dvec3 at = carried(inverse(shown_->geometry.imageToProbe()), glm::dvec3(p_mm, 0.0));
  const QRectF box = imageRect();
  const double scale = box.width() / std::max(1, shown_->image.width());
  return box.topLeft() + scale * QPointF(at.x + 0.5, at.y + 0.5);
}

glm::dvec2 ImageView::pointAt(const QPointF& at) const {
  if (!shown_) return glm::dvec2(0.0);
  const QRectF box = imageRect();
  const double scale = std::max(1, shown_->image.width()) / box.width();
  const glm::dvec3 pixel((at.x() - box.left()) * scale - 0.5, (at.y() - box.top()) * scale - 0.5, 0.0);
  return glm::dvec2(carried(shown_->geometry.imageToProbe(), pixel));
}

QStringList ImageView::shownSettings() const {
  QStringList lines;
  if (!shown_) return lines;
  const std::vector<Setting> own = settingsOf(shown_->state);
  const std::vector<Setting> others = other_ != nullptr && other_->shown_ ? settingsOf(other_->shown_->state) : own;
  for (std::size_t n = 0; n < own.size(); ++n) {
    const QString line = words(own[n].name) + QLatin1Char(' ') + words(own[n].value);
    lines << (own[n].value == others[n].value ? line : QStringLiteral("≠ ") + line);
  }
  if (other_ != nullptr && other_->shown_ && shown_->state.scene != other_->shown_->state.scene)
    lines << QStringLiteral("≠ ") + tr("effects of the image");
  return lines;
}

void ImageView::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.fillRect(rect(), Qt::black);
  paintHead(painter);
  if (scans_.opened(side_) == nullptr) return paintEmpty(painter);
  paintImage(painter);
  paintSettings(painter);
  if (!hasFocus()) return;
  painter.setPen(QPen(palette().color(QPalette::Highlight), 1.0));
  painter.setBrush(Qt::NoBrush);
  painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
}

QString ImageView::titleOfScan() const {
  const ReviewScan* scan = scans_.opened(side_);
  if (scan == nullptr) return {};
  const ScanChoice& choice = scan->scan->choice;
  const LessonAttempts* of = selection_.lesson();
  QString title = words(of != nullptr ? of->words.of(choice.title) : choice.title);
  if (choice.attempt.empty() || of == nullptr) return title;
  for (const auto& [folder, tried] : of->attempts)
    if (folder == choice.attempt) return tr("%1: %2", "person: step").arg(reviewer_.personOf(tried), title);
  return title;
}

void ImageView::paintHead(QPainter& painter) const {
  const Who who = whoOf(side_);
  const QColor colour = colourOf(who, true);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  drawMarkOf(painter, who, QPointF(2.0 * kGrid_px, 0.5 * headHeight()), scaled(5));
  painter.setFont(bold(font()));
  const QString word = wordOf(who);
  const int wide = painter.fontMetrics().horizontalAdvance(word);
  painter.setPen(colour);
  painter.drawText(QRect(4 * kGrid_px, 0, wide + 2, headHeight()), Qt::AlignLeft | Qt::AlignVCenter, word);
  painter.setFont(smallFont());
  painter.setPen(kScanQuiet);
  const QString time =
      scans_.opened(side_) == nullptr ? QString() : clockText(playback_.time_s(side_) - scans_.opened(side_)->scan->part.begin_s);
  const int timeWide = painter.fontMetrics().horizontalAdvance(QStringLiteral("-00:00.0"));
  painter.drawText(QRect(width() - timeWide - kGrid_px, 0, timeWide, headHeight()), Qt::AlignRight | Qt::AlignVCenter, time);
  const QRect room(4 * kGrid_px + wide + kGrid_px, 0, width() - timeWide - wide - 7 * kGrid_px, headHeight());
  painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter, painter.fontMetrics().elidedText(titleOfScan(), Qt::ElideRight, room.width()));
}

void ImageView::paintEmpty(QPainter& painter) const {
  painter.setFont(smallFont());
  painter.setPen(kScanQuiet);
  const QString sentence = scans_.isOpening()                ? tr("Opening …")
                           : !scans_.problem().isEmpty()     ? scans_.problem()
                           : side_ != kReviewed              ? tr("Nothing to compare with is chosen.")
                           : selection_.attempt() == nullptr ? tr("No attempt is chosen.")
                                                             : tr("This step was not recorded in this attempt.");
  painter.drawText(imageRect().adjusted(2 * kGrid_px, 0, -2 * kGrid_px, 0), Qt::AlignCenter | Qt::TextWordWrap, sentence);
}

void ImageView::paintImage(QPainter& painter) {
  if (!shown_) return;
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  const QRectF box = imageRect();
  const double scale = box.width() / std::max(1, shown_->image.width());
  painter.drawImage(QRectF(box.topLeft(), QSizeF(shown_->image.size()) * scale), shown_->image);
  if (shown_->state.pose.status != PoseStatus::ok) {
    painter.setFont(smallFont());
    painter.setPen(kDiffers);
    painter.drawText(box, Qt::AlignCenter, tr("The pose of the probe is not known here"));
  }
  if (side_ != kReviewed) return;
  painter.save();
  painter.setClipRect(box);
  const double here_s = playback_.time_s(kReviewed);
  for (const ReviewComment& each : comments_.here()) {
    const bool isChosen = each.id == comments_.chosen();
    if (std::abs(each.time_s - here_s) > kComment_s) continue;
    for (const CommentStroke& stroke : each.strokes) paintStroke(painter, stroke, isChosen ? kDiffers : kScanBright);
  }
  for (const CommentStroke& stroke : drawn_) paintStroke(painter, stroke, kDiffers);
  if (drawing_) paintStroke(painter, *drawing_, kDiffers);
  painter.restore();
}

void ImageView::paintStroke(QPainter& painter, const CommentStroke& stroke, const QColor& colour) const {
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

void ImageView::paintSettings(QPainter& painter) const {
  QStringList lines = shownSettings();
  if (!showsAllSettings()) lines = lines.filter(QRegularExpression(QStringLiteral("^≠"))).mid(0, kSettingColumns);
  painter.setFont(smallFont());
  const int row = scaled(17);
  const double wide = (width() - 2.0 * kGrid_px) / kSettingColumns;
  const double top = height() - settingsHeight() + 0.5 * kGrid_px;
  const int rows = (static_cast<int>(lines.size()) + kSettingColumns - 1) / kSettingColumns;
  for (int n = 0; n < lines.size(); ++n) {
    const bool differs = lines[n].startsWith(QStringLiteral("≠"));
    painter.setPen(differs ? kDiffers : kScanQuiet);
    const int column = n / rows;
    const QRectF room(kGrid_px + wide * column, top + row * (n % rows), wide - kGrid_px, row);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter,
                     painter.fontMetrics().elidedText(lines[n], Qt::ElideRight, static_cast<int>(room.width())));
  }
}

void ImageView::mousePressEvent(QMouseEvent* event) {
  setFocus(Qt::MouseFocusReason);
  if (!tool_ || side_ != kReviewed || !shown_ || event->button() != Qt::LeftButton) return;
  playback_.pause();
  drawing_ = CommentStroke{*tool_, {pointAt(event->localPos())}};
}

void ImageView::mouseMoveEvent(QMouseEvent* event) {
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

void ImageView::mouseReleaseEvent(QMouseEvent* event) {
  if (!drawing_) return;
  mouseMoveEvent(event);
  const bool isDrawn = drawing_->points_mm.size() > 1 && glm::distance(drawing_->points_mm.front(), drawing_->points_mm.back()) > 0.0;
  if (isDrawn || drawing_->points_mm.size() > 2) drawn_.push_back(*drawing_);
  drawing_.reset();
  update();
  Q_EMIT drawnChanged();
}

}  // namespace ew::review
