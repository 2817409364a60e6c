#include "body/view3d.h"

#include <QElapsedTimer>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QResizeEvent>
#include <QTimer>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ew/body/body_canvas.h"
#include "ew/core/contract.h"
#include "ew/widgets/focus_ring.h"
#include "ew/widgets/handler_watch.h"
#include "ew/widgets/look.h"

namespace ew::ui {
namespace {

constexpr double kTranslucent = 0.45;

constexpr int kOverlayMargin_px = 16;
constexpr int kBarMargin_px = 4;
constexpr int kLeastForHint_px = 280;
constexpr qint64 kLongestRest_ms = 100;  // longer, and it would not follow the hand any more

/// A trunk's size, so that there is something to slide on before a mannequin is loaded.
class EllipsoidSkin final : public Skin {
 public:
  [[nodiscard]] std::optional<Contact> hit(const glm::dvec3& from_mm, const glm::dvec3& direction) const override {
    const glm::dvec3 p = from_mm / kRadii_mm;
    const glm::dvec3 d = direction / kRadii_mm;
    const double a = glm::dot(d, d);
    const double b = glm::dot(p, d);
    const double c = glm::dot(p, p) - 1.0;
    const double root = b * b - a * c;
    if (root < 0.0 || -b < std::sqrt(root)) return std::nullopt;
    return at(from_mm + (-b - std::sqrt(root)) / a * direction);
  }
  /// Eberly's one-dimensional root: p scaled by r^2 / (r^2 + t) lies on the surface for one t.
  [[nodiscard]] Contact nearest(const glm::dvec3& p_mm) const override {
    const glm::dvec3 r2 = kRadii_mm * kRadii_mm;
    const glm::dvec3 p = glm::length(p_mm) > 1e-6 ? p_mm : glm::dvec3(0.0, -1e-6, 0.0);
    const auto excess = [&](double t) {
      const glm::dvec3 q = kRadii_mm * p / (r2 + t);
      return glm::dot(q, q) - 1.0;
    };
    double low = -std::min({r2.x, r2.y, r2.z}) * (1.0 - 1e-12);
    double high = glm::length(kRadii_mm * p);
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (low + high);
      (excess(middle) > 0.0 ? low : high) = middle;
    }
    const glm::dvec3 foot = r2 * p / (r2 + high);
    return at(foot / glm::length(foot / kRadii_mm));
  }

 private:
  static constexpr glm::dvec3 kRadii_mm{160.0, 105.0, 420.0};
  static Contact at(const glm::dvec3& p_mm) { return {p_mm, glm::normalize(p_mm / (kRadii_mm * kRadii_mm))}; }
};

/// Above the drawn scene, and through it goes every click.
class Glass final : public QWidget {
 public:
  explicit Glass(QWidget* view) : QWidget(view) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    hide();
  }
  std::function<void(QPainter&)> paint;

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    if (paint) paint(painter);
  }
};

}  // namespace

struct View3D::Parts {
  double opacity = 1.0;  ///< the user's choice
  std::optional<Aids> aids;
  explicit Parts(View3D* view)
      : canvas(new BodyCanvas(view)),
        glass(new Glass(view)),
        hint(new QLabel(view)),
        noBody(new QLabel(view)),
        buttons(new QWidget(view)) {}

  [[nodiscard]] glm::dvec2 device(const QPointF& at) const {
    const double ratio = canvas->devicePixelRatioF();
    return {at.x() * ratio, at.y() * ratio};
  }

  BodyCanvas* canvas;
  Glass* glass;
  QLabel* hint;
  QLabel* noBody;
  QWidget* buttons;
  std::vector<QToolButton*> viewButtons;

  /// One row above the body. Where it has no room only those stay that no key has: looking from a side is in the menu, too. Longer words
  /// make more rows of these, never cut ones.
  void arrangeButtons(int room_px) {
    for (const bool all : {true, false}) {
      for (QToolButton* each : viewButtons) each->setVisible(all || !looksFromSide(*each));
      if (gridButtons(room_px) == 1) return;
    }
  }
  [[nodiscard]] static bool looksFromSide(const QToolButton& button) {
    const QString name = button.objectName();
    return name == QLatin1String("viewFront") || name == QLatin1String("viewRight") || name == QLatin1String("viewLeft") ||
           name == QLatin1String("viewTop");
  }
  /// All of one width as far as their words let them be, in as many rows as it takes. @return how many
  int gridButtons(int room_px) {
    auto* grid = static_cast<QGridLayout*>(buttons->layout());
    std::vector<QToolButton*> shown;
    int widest_px = 0;
    for (QToolButton* each : viewButtons) {
      if (each->isHidden()) continue;
      shown.push_back(each);
      widest_px = std::max(widest_px, each->sizeHint().width());
    }
    const int count = static_cast<int>(shown.size());
    int columns = count;
    for (;; columns = (columns + 1) / 2) {
      for (int i = 0; i < count; ++i) grid->addWidget(shown[static_cast<std::size_t>(i)], i / columns, i % columns);
      for (int i = 0; i < static_cast<int>(viewButtons.size()); ++i) grid->setColumnStretch(i, i < columns ? 1 : 0);
      grid->invalidate();
      if (grid->sizeHint().width() <= room_px || columns == 1) break;
    }
    const QMargins margins = grid->contentsMargins();
    const int even_px = columns * widest_px + (columns - 1) * grid->horizontalSpacing() + margins.left() + margins.right();
    buttons->resize(std::max(grid->sizeHint().width(), std::min(room_px, even_px)), grid->sizeHint().height());
    return (count + columns - 1) / columns;
  }
  std::shared_ptr<const Skin> bareSkin = std::make_shared<EllipsoidSkin>();
  std::function<void()> beforeDrawing;
  bool renderAsked = false;
  bool isSmooth = false;     ///< what is drawn, or was last
  QElapsedTimer sinceDrawn;  ///< runs from the end of the last drawing
  QTimer rest;               ///< runs out when what is asked for may be drawn
  QTimer still;              ///< runs out when nothing was asked for a moment: then there is time for smooth edges
};

View3D::View3D(QWidget* parent) : QWidget(parent), parts_(std::make_unique<Parts>(this)) {
  setMinimumSize(240, 240);
  setFocusPolicy(Qt::StrongFocus);
  parts_->canvas->setFocusPolicy(Qt::StrongFocus);
  parts_->canvas->setObjectName(QStringLiteral("view3dCanvas"));
  setFocusProxy(parts_->canvas);
  parts_->canvas->setMouseTracking(true);
  parts_->canvas->grabGesture(Qt::PinchGesture);

  parts_->hint->setObjectName(QStringLiteral("viewHints"));
  parts_->hint->setAttribute(Qt::WA_TransparentForMouseEvents);
  setLook(parts_->hint, Look::small);
  parts_->noBody->setObjectName(QStringLiteral("noBody"));
  parts_->noBody->setAttribute(Qt::WA_TransparentForMouseEvents);
  parts_->noBody->setAlignment(Qt::AlignCenter);
  parts_->noBody->setWordWrap(true);
  parts_->noBody->setMargin(kOverlayMargin_px);
  parts_->noBody->hide();
  parts_->buttons->setObjectName(QStringLiteral("viewButtons"));
  auto* grid = new QGridLayout(parts_->buttons);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(4);
  const auto addButton = [&](const char* name, auto action) {
    auto* button = new QToolButton(parts_->buttons);
    button->setObjectName(QString::fromLatin1(name));
    button->setFocusPolicy(Qt::TabFocus);  // a click must not take the arrow keys away from the probe
    button->setAutoRaise(true);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setLook(button, Look::small);
    connect(button, &QToolButton::clicked, this, action);
    parts_->viewButtons.push_back(button);
  };
  addButton("viewOverview", [this] { showFrom(bridge::CameraPreset::overview); });
  addButton("viewFront", [this] { showFrom(bridge::CameraPreset::front); });
  addButton("viewRight", [this] { showFrom(bridge::CameraPreset::right); });
  addButton("viewLeft", [this] { showFrom(bridge::CameraPreset::left); });
  addButton("viewTop", [this] { showFrom(bridge::CameraPreset::top); });
  addButton("viewFit", [this] { fitToVolume(); });
  auto* skinButton = new QToolButton(parts_->buttons);
  skinButton->setObjectName(QStringLiteral("viewThrough"));
  skinButton->setFocusPolicy(Qt::TabFocus);
  skinButton->setAutoRaise(true);
  skinButton->setCheckable(true);
  skinButton->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  setLook(skinButton, Look::small);
  connect(skinButton, &QToolButton::toggled, this, [this](bool through) { setBodyOpacity(through ? kTranslucent : 1.0); });
  parts_->viewButtons.push_back(skinButton);
  new FocusRing(*this, *parts_->canvas);
  parts_->rest.setSingleShot(true);
  parts_->rest.setTimerType(Qt::PreciseTimer);
  connect(&parts_->rest, &QTimer::timeout, this, [this] { draw(bridge::Scene3D::Edges::quick); });
  parts_->still.setSingleShot(true);
  parts_->still.setInterval(250);
  connect(&parts_->still, &QTimer::timeout, this, [this] { draw(bridge::Scene3D::Edges::smooth); });
  connect(parts_->canvas, &BodyCanvas::drawn, this, &View3D::rest);
  connect(parts_->canvas, &BodyCanvas::notDrawn, this, [this] {
    parts_->noBody->setVisible(!parts_->canvas->isValid());
    rest();
  });
  connect(parts_->canvas, &BodyCanvas::pixelsChanged, this, [this] {
    placeOverlays();
    render();
  });
  retranslate();
}

View3D::~View3D() {
  delete parts_->canvas;  // while this is still a View3D: event filters on the canvas ask it for more than a QWidget
}

void View3D::retranslate() {
  const auto name = [this](const char* button, const QString& text, const QString& tip) {
    if (auto* found = parts_->buttons->findChild<QToolButton*>(QString::fromLatin1(button))) {
      found->setText(text);
      found->setToolTip(tip);
      found->setAccessibleName(tip);
    }
  };
  name("viewOverview", tr("Overview"), tr("Look from the front and above, where the fan is seen best"));
  name("viewFront", tr("Front"), tr("Look from the front"));
  name("viewRight", tr("Right"), tr("Look from the patient's right"));
  name("viewLeft", tr("Left"), tr("Look from the patient's left"));
  name("viewTop", tr("Head"), tr("Look from the head"));
  name("viewFit", tr("Fit"), tr("Show the whole volume"));
  name("viewThrough", tr("Translucent"), tr("Make the body translucent"));
  parts_->hint->setText(defaultHint());
  parts_->noBody->setText(whyNoBody());
  parts_->canvas->setAccessibleName(tr("Body with probe"));
  parts_->canvas->setAccessibleDescription(defaultHint());
  placeOverlays();
}

QString View3D::defaultHint() const {
  return tr("drag: slide on skin   wheel: tilt   Shift: rock   Ctrl: rotate   right drag: look around");
}

QString View3D::whyNoBody() { return tr("The body cannot be drawn, as OpenGL fails here; a newer graphics driver may help."); }

void View3D::setMannequin(std::shared_ptr<const bridge::Mannequin> mannequin) {
  EW_EXPECTS(mannequin != nullptr);
  parts_->canvas->change([mannequin = std::move(mannequin)](bridge::Scene3D& scene) { scene.setMannequin(mannequin); });
  render();
  Q_EMIT mannequinChanged();
}

std::shared_ptr<const Skin> View3D::skin() const {
  if (const auto mannequin = scene().mannequin()) return mannequin->skin;
  return parts_->bareSkin;
}

void View3D::setCoverage(std::vector<float> shares) {
  changeLooks([shares = std::move(shares)](bridge::Scene3D& scene) { scene.setCoverage(shares); });
}

void View3D::setVolumeBox(const Grid& grid) {
  change([grid](bridge::Scene3D& scene) { scene.setVolumeBox(grid); });
}

void View3D::clearVolumeBox() {
  change([](bridge::Scene3D& scene) { scene.clearVolumeBox(); });
}

void View3D::setProbe(const Probe& probe, double depth_mm, const Knobs& knobs) {
  change([=](bridge::Scene3D& scene) { scene.setProbe(probe, depth_mm, knobs); });
}

void View3D::setPose(const Pose& pose) {
  change([pose](bridge::Scene3D& scene) { scene.setPose(pose); });
}

void View3D::setProbeVisible(bool visible) {
  change([visible](bridge::Scene3D& scene) { scene.setProbeVisible(visible); });
}

void View3D::setFanImage(const DisplayImage& image, const DisplayGeometry& geometry) {
  bringFanImage(image, geometry);
  render();
}

void View3D::bringFanImage(const DisplayImage& image, const DisplayGeometry& geometry) {
  const auto grey = std::make_shared<const GreyImage>(copyOf(image.grey));
  const auto colour = std::make_shared<const Image<Rgba>>(copyOf(image.colour));
  parts_->canvas->changeLooks([=](bridge::Scene3D& scene) { scene.setFanImage({viewOf(*grey), viewOf(*colour)}, geometry); });
}

void View3D::change(const std::function<void(bridge::Scene3D&)>& change) {
  parts_->canvas->change(change);
  render();
}

void View3D::changeLooks(std::function<void(bridge::Scene3D&)> change) {
  parts_->canvas->changeLooks(std::move(change));
  render();
}

void View3D::clearFanImage() {
  changeLooks([](bridge::Scene3D& scene) { scene.clearFanImage(); });
}

void View3D::setBeforeDrawing(std::function<void()> bring) { parts_->beforeDrawing = std::move(bring); }

void View3D::setDarkTheme(bool dark) {
  parts_->canvas->changeLooks(
      [colours = dark ? bridge::darkColours() : bridge::lightColours()](bridge::Scene3D& scene) { scene.setColours(colours); });
  render();
}

void View3D::setBodyOpacity(double opacity) {
  parts_->opacity = opacity;
  showAids();
}

void View3D::setAids(std::optional<Aids> aids) {
  parts_->aids = std::move(aids);
  showAids();
}

void View3D::showAids() {
  Parts& p = *parts_;
  const double opacity = !p.aids ? p.opacity : p.aids->translucent || p.aids->organs ? kTranslucent : 1.0;
  p.canvas->changeLooks([opacity, aids = p.aids](bridge::Scene3D& scene) {
    scene.setBodyOpacity(opacity);
    scene.setBoxVisible(!aids || aids->box);
    scene.setOrgans(aids ? aids->organs : nullptr);
  });
  render();
}

void View3D::showFrom(bridge::CameraPreset preset) {
  change([preset](bridge::Scene3D& scene) { scene.showFrom(preset); });
}

void View3D::fitToVolume() {
  change([](bridge::Scene3D& scene) { scene.fitToVolume(); });
}

void View3D::render() {
  if (std::exchange(parts_->renderAsked, true)) return;
  if (!parts_->canvas->isDrawing()) drawRested();
}

/// A drawing has ended. What was asked for meanwhile comes after the whole of the rest.
void View3D::rest() {
  parts_->sinceDrawn.start();
  parts_->glass->update();  // what lies over it moves with the camera
  if (parts_->renderAsked)
    drawRested();
  else if (!parts_->isSmooth)
    parts_->still.start();
}

void View3D::drawRested() {
  const BodyCanvas& canvas = *parts_->canvas;
  // At most a third of the time goes into it, and without a graphics processor a tenth: there it takes what the scan could use.
  const auto rest_ms = static_cast<qint64>(std::min((canvas.isSoftware() ? 10.0 : 2.0) * canvas.took_ms(), double{kLongestRest_ms}));
  const qint64 rested_ms = parts_->sinceDrawn.isValid() ? parts_->sinceDrawn.elapsed() : kLongestRest_ms;
  // Not at the end of this turn: what is asked for in it, the scan's painting above all, comes first.
  parts_->rest.start(static_cast<int>(std::clamp(rest_ms - rested_ms, qint64{1}, kLongestRest_ms)));
}

bool View3D::renderNow() {
  const HandlerWatch::Part part("waiting for the body");
  return prepareDrawing(bridge::Scene3D::Edges::smooth) && parts_->canvas->drawNow(bridge::Scene3D::Edges::smooth);
}

void View3D::draw(bridge::Scene3D::Edges edges) {
  if (prepareDrawing(edges)) parts_->canvas->draw(edges);
}

/// Brings what only a drawing needs. Without a context there is nothing to draw into; the widget asks again when it is shown.
bool View3D::prepareDrawing(bridge::Scene3D::Edges edges) {
  parts_->renderAsked = false;
  parts_->rest.stop();
  parts_->still.stop();
  if (!isVisible() || !parts_->canvas->isValid()) return false;
  parts_->isSmooth = edges == bridge::Scene3D::Edges::smooth;
  if (parts_->beforeDrawing) parts_->beforeDrawing();
  return true;
}

void View3D::setOver(std::function<void(QPainter&)> paint) {
  parts_->glass->paint = std::move(paint);
  parts_->glass->setVisible(parts_->glass->paint != nullptr);
  parts_->glass->update();
}

std::optional<Skin::Contact> View3D::contactAt(const QPoint& at) const {
  const bridge::Ray ray = rayAt(at);
  return skin()->hit(ray.from_mm, ray.direction);
}

bridge::Ray View3D::rayAt(const QPointF& at) const { return scene().rayAt(parts_->device(at)); }

bool View3D::isProbeAt(const QPoint& at) const { return scene().isProbeAt(parts_->device(at)); }

QPointF View3D::pixelOf(const glm::dvec3& p_world_mm) const {
  const glm::dvec2 at = scene().pixelOf(p_world_mm) / parts_->canvas->devicePixelRatioF();
  return {at.x, at.y};
}

bridge::Sight View3D::sight() const { return parts_->canvas->sight(); }

QWidget* View3D::canvas() const { return parts_->canvas; }
const bridge::Scene3D& View3D::scene() const { return parts_->canvas->scene(); }

/// The buttons have a row of their own above the body, so that no head lies under them; the hint lies over the body.
void View3D::placeOverlays() {
  QLabel& hint = *parts_->hint;
  // In a narrow column the words would take the place of the body; the page of keys (F1) has them too.
  const int cube_px = static_cast<int>(std::ceil(scene().cubeSide_px() / parts_->canvas->devicePixelRatioF()));
  hint.setVisible(!hint.text().isEmpty() && width() >= kLeastForHint_px + cube_px);
  // A narrow view wraps the words; it never cuts them.
  hint.setWordWrap(false);
  hint.adjustSize();
  const int room = std::max(80, width() - 2 * kOverlayMargin_px);
  if (const int beside = room - cube_px; hint.width() > beside) {
    hint.setWordWrap(true);
    hint.resize(beside, hint.heightForWidth(beside));
  }
  hint.move(kOverlayMargin_px, height() - kOverlayMargin_px - hint.height());
  parts_->arrangeButtons(std::max(80, width() - 2 * kBarMargin_px));
  parts_->buttons->move(kBarMargin_px, kBarMargin_px);
  const int top = parts_->buttons->height() + 2 * kBarMargin_px;
  const QRect body(0, top, width(), std::max(1, height() - top));
  parts_->canvas->setGeometry(body);
  parts_->glass->setGeometry(body);
  parts_->noBody->setGeometry(body);
  hint.raise();
}

void View3D::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeOverlays();
  render();
}

void View3D::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  placeOverlays();
  render();
}

void View3D::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::LanguageChange) retranslate();
  if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange) placeOverlays();
}

}  // namespace ew::ui
