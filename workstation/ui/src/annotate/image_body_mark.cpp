#include "annotate/image_body_mark.h"

#include <QPainter>
#include <QPainterPath>
#include <QSettings>
#include <QSvgRenderer>
#include <algorithm>

#include "ew/imaging/probe.h"
#include "ew/widgets/theme.h"

namespace ew::ui {
namespace {

using annotation::BodyMark;
using annotation::ProbeGlyph;

const auto kShownSetting = QStringLiteral("bodyMarkShown");
constexpr double kShortestBar_px = 14.0, kLongestBar_px = 34.0;

}  // namespace

ImageBodyMark::ImageBodyMark(Session& session, QObject* parent)
    : QObject(parent), session_(session), isShown_(QSettings().value(kShownSetting, true).toBool()) {
  connect(&session_, &Session::imageChanged, this, &ImageBodyMark::look);
  connect(&session_, &Session::subjectReplaced, this, [this] {
    byHand_.forget();
    look();
  });
}

void ImageBodyMark::setMarks(std::vector<BodyMark> marks) {
  mark_ = nullptr;
  marks_ = std::move(marks);
  look();
}

void ImageBodyMark::setBody(const annotation::MarkSubject& body) {
  if (body.region == body_.region && body.mannequin == body_.mannequin) return;
  body_ = body;
  chosen_.clear();  // another patient, another examination
  variant_.clear();
  mark_ = nullptr;
  look();
}

void ImageBodyMark::beginLike(const ImageBodyMark& other) {
  mark_ = nullptr;
  marks_ = other.marks_;
  body_ = other.body_;
  first_ = other.first_;
  chosen_ = other.chosen_;
  variant_ = other.variant_;
  isShown_ = other.isShown_;
}

void ImageBodyMark::exchange(ImageBodyMark& other) {
  std::swap(byHand_, other.byHand_);
  std::swap(chosen_, other.chosen_);
  std::swap(variant_, other.variant_);
}

void ImageBodyMark::follow(const ImageBodyMark& other) {
  if (isShown_ == other.isShown_) return;
  isShown_ = other.isShown_;
  Q_EMIT changed();
}

std::vector<const BodyMark*> ImageBodyMark::offered() const {
  std::vector<const BodyMark*> all = marksFor(marks_, body_);
  for (const BodyMark& mark : marks_)
    if (std::find(all.begin(), all.end(), &mark) == all.end()) all.push_back(&mark);
  const auto place = [this](const BodyMark* mark) { return std::find(first_.begin(), first_.end(), mark->id) - first_.begin(); };
  std::stable_sort(all.begin(), all.end(), [&](const BodyMark* a, const BodyMark* b) { return place(a) < place(b); });
  return all;
}

void ImageBodyMark::setFirst(std::vector<std::string> ids) { first_ = std::move(ids); }

annotation::MarkChoice ImageBodyMark::choice() const { return {isShown_, chosen_, variant_, byHand_.now()}; }

void ImageBodyMark::setShown(bool shown) {
  isShown_ = shown;
  QSettings().setValue(kShownSetting, shown);
  Q_EMIT changed();
}

void ImageBodyMark::choose(const std::string& mark, const std::string& variant) {
  chosen_ = mark;
  variant_ = variant;
  look();
}

void ImageBodyMark::putByHand(const std::optional<ProbeGlyph>& glyph) {
  if (!standsStill()) return;
  byHand_.turnTo(stillOf(session_));
  byHand_.now() = glyph ? std::optional(limited(*glyph)) : std::nullopt;
  look();
}

void ImageBodyMark::look() {
  if (!standsStill())
    byHand_.forget();
  else if (byHand_.image())
    byHand_.turnTo(stillOf(session_));
  const auto& probeToWorld = session_.shownState().pose.probeToWorld;
  const BodyMark* named = chosen_.empty() ? nullptr : bodyMarkOf(marks_, chosen_);
  const BodyMark* mark = nullptr;
  std::optional<ProbeGlyph> glyph;
  if (session_.subject() && !session_.image().isEmpty()) {
    mark = named != nullptr ? named : markFor(marksFor(marks_, body_), probeToWorld, mark_ != nullptr ? mark_->id : std::string());
    if (byHand_.now())
      glyph = byHand_.now();
    else if (mark != nullptr)
      glyph = glyphFor(*mark, probeToWorld);
  }
  const std::string drawn = mark != nullptr ? mark->drawingOf(variant_).string() : std::string();
  if (mark == mark_ && glyph == glyph_ && drawn == drawn_) return;
  mark_ = mark;
  glyph_ = glyph;
  drawn_ = drawn;
  Q_EMIT changed();
}

double ImageBodyMark::faceShare() const { return mark_ != nullptr ? faceLength_mm(session_.imageProbe()) / mark_->side_mm : 0.0; }

QString ImageBodyMark::drawing() const { return mark() != nullptr ? QString::fromStdString(drawn_) : QString(); }

void paintMark(QPainter& painter, const ImageBodyMark& mark, const QRectF& box) {
  if (mark.mark() == nullptr) return;
  painter.save();
  painter.setRenderHint(QPainter::Antialiasing);
  QPainterPath ground;
  ground.addRoundedRect(box, 4.0, 4.0);
  painter.fillPath(ground, QColor(0, 0, 0, 210));
  painter.setClipPath(ground);
  QSvgRenderer(mark.drawing()).render(&painter, box);
  if (const auto& glyph = mark.glyph()) {
    const double length = std::clamp(mark.faceShare() * box.width(), kShortestBar_px, kLongestBar_px);
    painter.translate(box.left() + glyph->place.x * box.width(), box.top() + glyph->place.y * box.height());
    painter.rotate(glyph->angle_rad * 180.0 / 3.14159265358979323846);
    const QPointF half(0.5 * length, 0.0);
    painter.setPen(QPen(Qt::black, 6.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(-half, half);
    painter.setPen(QPen(scanTheme().accent, 3.5, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(-half, half);
    painter.setPen(QPen(Qt::black, 1.5));
    painter.setBrush(Qt::white);
    painter.drawEllipse(half, 3.6, 3.6);
  }
  painter.restore();
}

}  // namespace ew::ui
