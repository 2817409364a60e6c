#include "annotate/annotation_layer.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QCursor>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QStringListModel>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <utility>

#include "annotate/annotation_paint.h"
#include "ew/widgets/theme.h"
#include "scan/scan_view.h"

namespace ew::ui {
namespace {

using annotation::AnnotationFound;
using annotation::AnnotationKind;
using annotation::AnnotationList;
using annotation::AnnotationPart;

constexpr double kTakenWithin_px = 7.0;
constexpr double kDrawn_px = 6.0;          // a shorter drag is a click
const QPointF kUsualArrow_px(34.0, 26.0);  // from the tip to the tail of an arrow that was clicked
constexpr int kFieldSide_px = 5;           // between the field's edge and its text

}  // namespace

/// While words are offered their list passes keys straight on to the field, past whoever looks at its events.
class AnnotationField final : public QLineEdit {
 public:
  using QLineEdit::QLineEdit;
  std::function<bool(int key, Qt::KeyboardModifiers modifiers)> onKey;

 protected:
  bool event(QEvent* event) override {
    if (event->type() == QEvent::KeyPress) {
      const auto* pressed = static_cast<QKeyEvent*>(event);
      if (onKey(pressed->key(), pressed->modifiers())) {
        event->accept();
        return true;
      }
    }
    return QLineEdit::event(event);
  }
};

AnnotationLayer::AnnotationLayer(Session& session, ImageAnnotations& images, ScanView& scan)
    : QWidget(&scan), session_(session), images_(images), scan_(scan) {
  setObjectName(QStringLiteral("annotationLayer"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  setAccessibleName(tr("Texts and arrows on the image"));
  auto* field = new AnnotationField(&scan);
  field->onKey = [this](int key, Qt::KeyboardModifiers modifiers) { return fieldKey(key, modifiers); };
  field_ = field;
  field_->setObjectName(QStringLiteral("annotationField"));
  field_->setFont(annotationFont());
  field_->setMaxLength(static_cast<int>(annotation::kLongestText));
  field_->setAccessibleName(tr("Text on the image"));
  field_->setToolTip(tr("Enter ends, Escape gives up, Tab takes the first word of the list, Ctrl+Home goes to the home position"));
  field_->hide();
  completions_ = new QStringListModel(this);
  completer_ = new QCompleter(completions_, this);
  completer_->setCompletionMode(QCompleter::UnfilteredPopupCompletion);
  completer_->setWidget(field_);
  hide();
  scan.installEventFilter(this);
  field_->installEventFilter(this);
  connect(completer_, QOverload<const QString&>::of(&QCompleter::activated), this, [this](const QString& whole) { take(whole); });
  connect(field_, &QLineEdit::textEdited, this, [this] {
    fitField();
    complete();
  });
  connect(&session_, &Session::imageChanged, this, &AnnotationLayer::follow);
  connect(&images_, &ImageAnnotations::changed, this, &AnnotationLayer::showOrHide);
}

void AnnotationLayer::watch(QWidget* over, std::function<bool()> isInUse) {
  over->installEventFilter(this);
  isOverInUse_ = std::move(isInUse);
}

void AnnotationLayer::finish() {
  if (isWriting()) endWriting(true);
}

void AnnotationLayer::follow() {
  // What stood still goes on: there is no image any more that the text would belong to.
  if (isWriting() && !session_.isFrozen() && !session_.isPlaying()) endWriting(false);
  if (!isHidden() && geometry() != scan_.imageRect()) setGeometry(scan_.imageRect());
  if (!isHidden()) update();
}

void AnnotationLayer::showOrHide() {
  const bool isWanted = !images_.all().empty() || images_.isArrowAtHand();
  if (isWanted) setGeometry(scan_.imageRect());
  if (isWanted && isHidden()) raise();
  setVisible(isWanted);
  if (!isWanted) drag_.reset();
  if (images_.isArrowAtHand()) {
    scan_.setCursor(Qt::CrossCursor);
    hasCursor_ = true;
  } else if (hasCursor_ && !drag_) {
    scan_.unsetCursor();
    hasCursor_ = false;
  }
  field_->raise();
  update();
}

QPointF AnnotationLayer::placeOf(const glm::dvec2& at_mm) const {
  return scan_.positionOf(Point<frame::Probe>{{at_mm.x, at_mm.y, 0.0}}) - QPointF(scan_.imageRect().topLeft());
}

glm::dvec2 AnnotationLayer::pointAt(const QPointF& at) const {
  const Point<frame::Probe> point = scan_.pointAt(at);
  return {point.at.x, point.at.y};
}

std::optional<AnnotationFound> AnnotationLayer::foundAt(const QPointF& at) const {
  if (images_.all().empty() || session_.geometry().pixel_mm <= 0.0 || isOverInUse_()) return std::nullopt;
  const double mm = scan_.mmPerWidgetPixel();
  const double alongX = session_.geometry().markerLeft ? -1.0 : 1.0;
  return annotationNear(images_.list().now(), pointAt(at), kTakenWithin_px * mm, [&](const annotation::Annotation& text) {
    const QSizeF size = annotationSize(text.text);
    return annotation::TextSize{{size.width() * mm, size.height() * mm}, alongX};
  });
}

QPointF AnnotationLayer::homePlace() const {
  const QRect image = scan_.imageRect();
  const glm::dvec2 share = images_.home().share;
  return QPointF(image.topLeft()) + QPointF(share.x * image.width(), share.y * image.height());
}

void AnnotationLayer::setHomeHere() {
  const QRect image = scan_.imageRect();
  QPointF at = scan_.mapFromGlobal(QCursor::pos());
  const annotation::Annotation* chosen = images_.list().now().find(images_.selected());
  if (isWriting())
    at = fieldAt_;
  else if (chosen != nullptr)
    at = placeOf(chosen->at_mm) + QPointF(image.topLeft());
  else if (!image.contains(at.toPoint()))
    return;
  images_.setHome({{(at.x() - image.left()) / image.width(), (at.y() - image.top()) / image.height()}});
}

bool AnnotationLayer::isWriting() const { return !field_->isHidden(); }

void AnnotationLayer::write(const QString& words) {
  if (isWriting()) {
    const QString before = field_->text().trimmed();
    field_->setText(before.isEmpty() ? words : before + QLatin1Char(' ') + words);
    return fitField();
  }
  const QPoint pointer = scan_.mapFromGlobal(QCursor::pos());
  const bool isOverImage = scan_.underMouse() && scan_.imageRect().contains(pointer) && words.isEmpty();
  writeAt(isOverImage ? QPointF(pointer) : homePlace(), words, 0);
}

void AnnotationLayer::writeAt(const QPointF& at, const QString& words, int number) {
  if (!images_.hold()) return;
  images_.putDown();
  rewritten_ = number;
  field_->setText(words);
  field_->show();
  field_->raise();
  moveField(at);
  field_->setFocus(Qt::OtherFocusReason);
  field_->end(false);
  Q_EMIT writingBegan();
}

void AnnotationLayer::moveField(const QPointF& at) {
  fieldAt_ = at;
  fitField();
}

void AnnotationLayer::fitField() {
  const QFontMetrics metrics(field_->font());
  const int width = std::max(120, metrics.horizontalAdvance(field_->text()) + 4 * kFieldSide_px + metrics.averageCharWidth());
  const int height = field_->sizeHint().height();
  // Where it begins is where the text will; at the right border it is moved so far that it can be read.
  const int left = static_cast<int>(std::lround(fieldAt_.x())) - kFieldSide_px;
  field_->setGeometry(std::clamp(left, 0, std::max(0, scan_.width() - width)), static_cast<int>(std::lround(fieldAt_.y())) - height / 2,
                      width, height);
}

void AnnotationLayer::complete() {
  QStringList offered;
  for (const std::string& whole : annotation::completionsOf(field_->text().toStdString(), images_.terms()))
    offered.push_back(QString::fromStdString(whole));
  completions_->setStringList(offered);
  if (offered.isEmpty())
    completer_->popup()->hide();
  else
    completer_->complete(QRect(0, 0, std::max(200, field_->width()), field_->height()));
}

void AnnotationLayer::endWriting(bool keeps) {
  if (!isWriting()) return;
  const std::string text = field_->text().toStdString();
  const bool hadFocus = field_->hasFocus();
  completer_->popup()->hide();
  field_->hide();
  if (hadFocus) scan_.setFocus(Qt::OtherFocusReason);
  if (!keeps) return;
  const glm::dvec2 at_mm = pointAt(fieldAt_);
  images_.change([&](AnnotationList& list) {
    if (rewritten_ != 0)
      list.setText(rewritten_, text);
    else
      list.addText(at_mm, text);
  });
}

bool AnnotationLayer::hasNothingTyped() const { return isWriting() && rewritten_ == 0 && field_->text().trimmed().isEmpty(); }

bool AnnotationLayer::press(const QPointF& at) {
  const bool isEmpty = std::exchange(isLeftEmpty_, false) || hasNothingTyped();
  if (isWriting()) endWriting(true);
  if (!scan_.imageRect().contains(at.toPoint())) return false;
  if (isEmpty) {
    writeAt(at, {}, 0);
    return true;
  }
  if (images_.isArrowAtHand()) {
    drag_ = Drag{0, AnnotationPart::tip, at, at, false};
    return true;
  }
  const auto found = foundAt(at);
  images_.select(found ? found->number : 0);
  if (!found) return false;
  images_.hold();
  drag_ = Drag{found->number, found->part, at, at, false};
  return true;
}

bool AnnotationLayer::move(const QPointF& at) {
  if (!drag_) {
    showCursor(at);
    return false;
  }
  if (drag_->number != 0) {
    const glm::dvec2 by_mm = pointAt(at) - pointAt(drag_->to);
    const Change change = drag_->hasMoved ? Change::goesOn : Change::begins;
    bool isMoved = false;
    images_.change([&](AnnotationList& list) { isMoved = list.move(drag_->number, drag_->part, by_mm, change); });
    if (!isMoved) return true;  // it stays where it was, and goes on from there
    drag_->hasMoved = true;
  }
  drag_->to = at;
  update();
  return true;
}

bool AnnotationLayer::release(const QPointF& at) {
  if (!drag_) return false;
  if (drag_->number != 0 && at != drag_->to) move(at);
  const Drag drag = *std::exchange(drag_, std::nullopt);
  if (drag.number != 0) return true;
  const QPointF along = at - drag.from;
  const bool isDrawn = std::hypot(along.x(), along.y()) >= kDrawn_px;
  const glm::dvec2 tail_mm = pointAt(isDrawn ? drag.from : at + kUsualArrow_px), tip_mm = pointAt(at);
  images_.change([&](AnnotationList& list) { list.addArrow(tail_mm, tip_mm); });
  images_.putDown();
  return true;
}

bool AnnotationLayer::isOwnKey(const QKeyEvent& event) const {
  const std::string command = keys_->meant(event, kWithChosen);
  return command == "escape" ? images_.selected() != 0 || images_.isArrowAtHand() : !command.empty() && images_.selected() != 0;
}

bool AnnotationLayer::key(const QKeyEvent& event) {
  const std::string command = keys_->meant(event, kWithChosen);
  if (command == "escape" && images_.isArrowAtHand()) {
    drag_.reset();
    images_.putDown();
    return true;
  }
  const int chosen = images_.selected();
  if (chosen == 0) return false;
  if (command == "escape")
    images_.select(0);
  else if (command == "chosen.delete")
    images_.change([&](AnnotationList& list) { list.remove(chosen); });
  else if (command == "chosen.deleteWord")
    images_.change([&](AnnotationList& list) { list.removeLastWord(chosen); });
  else
    return false;
  return true;
}

void AnnotationLayer::take(const QString& whole) {
  completions_->setStringList({});
  completer_->popup()->hide();
  field_->setText(whole);
  fitField();
}

bool AnnotationLayer::fieldKey(int key, Qt::KeyboardModifiers modifiers) {
  switch (key) {
    case Qt::Key_Escape:
      endWriting(false);
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter: {
      const QModelIndex chosen = completer_->popup()->isVisible() ? completer_->popup()->currentIndex() : QModelIndex();
      if (chosen.isValid())
        take(chosen.data().toString());
      else
        endWriting(true);
      return true;
    }
    case Qt::Key_Tab:
      if (completions_->rowCount() > 0) take(completions_->stringList().front());
      return true;  // the field keeps the focus
    case Qt::Key_Home:
      if ((modifiers & Qt::ControlModifier) == 0) return false;
      moveField(homePlace());
      return true;
    default:
      return false;
  }
}

void AnnotationLayer::showCursor(const QPointF& at) {
  if (images_.isArrowAtHand()) return;
  const bool isOver = scan_.imageRect().contains(at.toPoint()) && foundAt(at).has_value();
  if (isOver == hasCursor_) return;
  hasCursor_ = isOver;
  if (isOver)
    scan_.setCursor(Qt::SizeAllCursor);
  else
    scan_.unsetCursor();
}

bool AnnotationLayer::eventFilter(QObject* watched, QEvent* event) {
  if (watched == field_) {
    if (event->type() == QEvent::FocusOut && !completer_->popup()->isVisible()) {
      isLeftEmpty_ = hasNothingTyped() && static_cast<QFocusEvent*>(event)->reason() == Qt::MouseFocusReason;
      if (isLeftEmpty_) QTimer::singleShot(0, this, [this] { isLeftEmpty_ = false; });  // the click itself comes before that
      endWriting(true);
    }
    return false;
  }
  auto* widget = static_cast<QWidget*>(watched);
  const auto mouse = [&] {
    auto* moved = static_cast<QMouseEvent*>(event);
    return std::pair{QPointF(widget->mapTo(&scan_, QPoint(0, 0))) + moved->localPos(), moved};
  };
  switch (event->type()) {
    case QEvent::Resize:
      follow();
      if (isWriting() && watched == &scan_) fitField();
      return false;
    case QEvent::MouseButtonPress: {
      const auto [at, moved] = mouse();
      return moved->button() == Qt::LeftButton && (moved->modifiers() & Qt::AltModifier) == 0 && press(at);
    }
    case QEvent::MouseMove:
      return move(mouse().first);
    case QEvent::MouseButtonRelease:
      return mouse().second->button() == Qt::LeftButton && release(mouse().first);
    case QEvent::MouseButtonDblClick: {
      const auto [at, moved] = mouse();
      const auto found = moved->button() == Qt::LeftButton ? foundAt(at) : std::nullopt;
      const annotation::Annotation* text = found ? images_.list().now().find(found->number) : nullptr;
      if (text == nullptr) return false;
      drag_.reset();
      if (text->kind == AnnotationKind::text)
        writeAt(placeOf(text->at_mm) + QPointF(scan_.imageRect().topLeft()), QString::fromStdString(text->text), text->number);
      return true;
    }
    case QEvent::ShortcutOverride:
      if (!isOwnKey(*static_cast<QKeyEvent*>(event))) return false;
      event->accept();
      return true;
    case QEvent::KeyPress:
      return key(*static_cast<QKeyEvent*>(event));
    default:
      return false;
  }
}

void AnnotationLayer::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  const Theme theme = scanTheme();
  std::vector<annotation::Annotation> shown = images_.all();
  if (isWriting() && rewritten_ != 0) std::erase_if(shown, [&](const auto& each) { return each.number == rewritten_; });
  paintAnnotations(painter, shown, images_.selected(), [this](const glm::dvec2& at_mm) { return placeOf(at_mm); },
                   {theme.text, theme.accent});
  if (drag_ && drag_->number == 0) {
    const QPointF corner(scan_.imageRect().topLeft());
    paintArrow(painter, drag_->from - corner, drag_->to - corner, theme.accent);
  }
}

}  // namespace ew::ui
