#include "annotate/shown_mark.h"

#include <QPainter>
#include <QPainterPath>
#include <QSettings>
#include <QSvgRenderer>
#include <algorithm>
#include <cmath>

#include "ew/imaging/probe.h"
#include "ew/widgets/theme.h"

namespace ew::ui {
namespace {

using annotation::BodyMark;
using annotation::ProbeGlyph;

const auto kShownSetting = QStringLiteral("bodyMarkShown");
constexpr double kShortestBar_px = 14.0, kLongestBar_px = 34.0;

}  // namespace

ShownMark::ShownMark(Session& session, QObject* parent)
    : QObject(parent), session_(session), isShown_(QSettings().value(kShownSetting, true).toBool()) {
  connect(&session_, &Session::pictureChanged, this, &ShownMark::look);
  connect(&session_, &Session::subjectReplaced, this, [this] {
    byHand_.forget();
    look();
  });
}

void ShownMark::setMarks(std::vector<BodyMark> marks) {
  mark_ = nullptr;
  marks_ = std::move(marks);
  look();
}

void ShownMark::setBody(const annotation::MarkedBody& body) {
  if (body.region == body_.region && body.mannequin == body_.mannequin) return;
  body_ = body;
  chosen_.clear();  // another patient, another examination
  variant_.clear();
  mark_ = nullptr;
  look();
}

void ShownMark::beginLike(const ShownMark& other) {
  mark_ = nullptr;
  marks_ = other.marks_;
  body_ = other.body_;
  first_ = other.first_;
  chosen_ = other.chosen_;
  variant_ = other.variant_;
  isShown_ = other.isShown_;
}

void ShownMark::exchange(ShownMark& other) {
  std::swap(byHand_, other.byHand_);
  std::swap(chosen_, other.chosen_);
  std::swap(variant_, other.variant_);
}

void ShownMark::follow(const ShownMark& other) {
  if (isShown_ == other.isShown_) return;
  isShown_ = other.isShown_;
  Q_EMIT changed();
}

std::vector<const BodyMark*> ShownMark::offered() const {
  std::vector<const BodyMark*> all = marksFor(marks_, body_);
  for (const BodyMark& mark : marks_)
    if (std::find(all.begin(), all.end(), &mark) == all.end()) all.push_back(&mark);
  const auto place = [this](const BodyMark* mark) { return std::find(first_.begin(), first_.end(), mark->id) - first_.begin(); };
  std::stable_sort(all.begin(), all.end(), [&](const BodyMark* a, const BodyMark* b) { return place(a) < place(b); });
  return all;
}

void ShownMark::setFirst(std::vector<std::string> ids) { first_ = std::move(ids); }

annotation::MarkChoice ShownMark::choice() const { return {isShown_, chosen_, variant_, byHand_.now()}; }

void ShownMark::setShown(bool shown) {
  isShown_ = shown;
  QSettings().setValue(kShownSetting, shown);
  Q_EMIT changed();
}

void ShownMark::choose(const std::string& mark, const std::string& variant) {
  chosen_ = mark;
  variant_ = variant;
  look();
}

void ShownMark::putByHand(const std::optional<ProbeGlyph>& glyph) {
  if (!standsStill()) return;
  byHand_.turnTo(stillOf(session_));
  byHand_.now() = glyph ? std::optional(limited(*glyph)) : std::nullopt;
  look();
}

void ShownMark::look() {
  if (!standsStill())
    byHand_.forget();
  else if (byHand_.picture())
    byHand_.turnTo(stillOf(session_));
  const auto& probeToWorld = session_.shownState().pose.probeToWorld;
  const BodyMark* named = chosen_.empty() ? nullptr : bodyMarkOf(marks_, chosen_);
  const BodyMark* mark = nullptr;
  std::optional<ProbeGlyph> glyph;
  if (session_.subject() && !session_.picture().isEmpty()) {
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

double ShownMark::faceShare() const { return mark_ != nullptr ? faceLength_mm(session_.pictureProbe()) / mark_->side_mm : 0.0; }

QString ShownMark::drawing() const { return mark() != nullptr ? QString::fromStdString(drawn_) : QString(); }

void paintMark(QPainter& painter, const ShownMark& mark, const QRectF& box) {
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
