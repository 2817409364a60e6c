#include "panel/place_panel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <glm/gtc/constants.hpp>

#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/fields.h"

namespace ew::case_authoring {
namespace {

constexpr int kOblique = 6;  // in the choice of faces: the beams enter none of them squarely

QString placingNumber(double value, int decimals = 1) { return QLocale().toString(value, 'f', decimals); }
QString placingPercent(double share) { return QLocale().toString(std::lround(100.0 * share)); }

}  // namespace

PlacePanel::PlacePanel(sdk::Host& host, QWidget* parent) : QWidget(parent), host_(host) {
  setObjectName(QStringLiteral("placePanel"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  pages_ = new QStackedWidget(this);
  pages_->addWidget(emptyState(tr("No case is open"), tr("Open a case. Then its volume can be placed in the body here.")));
  pages_->addWidget(makeForm());
  column->addWidget(pages_, 1);
  contactSoon_.setSingleShot(true);
  connect(&contactSoon_, &QTimer::timeout, this, &PlacePanel::showContact);
  changed_ = host_.cases().onChanged([this] { showCase(); });
  // What is scanned is told by its images: a volume that has been loaded, a mannequin that has come.
  seen_ = host_.scan().onEvent([this](const ScanEvent&) {
    if (!isVisible()) return;
    const auto scanned = host_.scan().scanned();
    if (scanned && scanned->skin != skinSeen_) showCase();
  });
  showCase();
}

QWidget* PlacePanel::makeForm() {
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  auto* body = new QWidget;
  auto* column = new QVBoxLayout(body);
  column->setContentsMargins(2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px, 2 * kGrid_px);
  column->setSpacing(kGrid_px);
  column->addWidget(headingLabel(tr("On the skin")));
  remark_ = quietLabel({});
  remark_->setObjectName(QStringLiteral("placeRemark"));
  column->addWidget(remark_);
  column->addWidget(makeContact());
  column->addSpacing(kGrid_px);
  column->addWidget(headingLabel(tr("Move")));
  column->addWidget(makeButtons());
  numbers_ = new sdk::PlacementFields<frame::World, frame::File>;
  numbers_->setObjectName(QStringLiteral("placement"));
  numbers_->onChanged = [this](const FilePlace& fileToWorld, const std::string& axis) {
    place(fileToWorld, tr("Move the volume, %1").arg(words(axis)), "volume.file_to_world" + axis);
  };
  column->addWidget(numbers_);
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("placeProblem"));
  column->addWidget(problem_);
  column->addSpacing(kGrid_px);
  column->addWidget(headingLabel(tr("By places")));
  column->addWidget(makePairs());
  column->addStretch(1);
  scroll->setWidget(body);
  return scroll;
}

QWidget* PlacePanel::makeContact() {
  contact_ = new QWidget;
  auto* column = new QVBoxLayout(contact_);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(kGrid_px);
  verdict_ = new QLabel;
  verdict_->setObjectName(QStringLiteral("contactVerdict"));
  verdict_->setWordWrap(true);
  column->addWidget(verdict_);
  share_ = new QProgressBar;
  share_->setObjectName(QStringLiteral("contactShare"));
  share_->setRange(0, 100);
  share_->setTextVisible(false);
  share_->setAccessibleName(tr("Part of the near face that touches the skin"));
  column->addWidget(share_);
  figures_ = quietLabel({});
  figures_->setObjectName(QStringLiteral("contactFigures"));
  column->addWidget(figures_);
  auto* row = new QHBoxLayout;
  row->setSpacing(kGrid_px);
  auto* name = quietLabel(tr("Near face"));
  name->setWordWrap(false);
  row->addWidget(name);
  auto* face = new ChoiceField;
  face_ = face;
  face->setObjectName(QStringLiteral("nearFace"));
  face->setFocusPolicy(Qt::StrongFocus);
  face->setAccessibleName(tr("Near face"));
  face->setToolTip(tr("The side of the volume on which the probe was"));
  name->setBuddy(face);
  connect(face, QOverload<int>::of(&QComboBox::activated), this, &PlacePanel::chooseFace);
  row->addWidget(face, 1);
  column->addLayout(row);
  return contact_;
}

QPushButton* PlacePanel::addButton(QWidget* row, const char* name, const QString& text, const QString& tip, std::function<void()> run) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  button->setToolTip(tip);
  connect(button, &QPushButton::clicked, this, [run = std::move(run)] { run(); });
  row->layout()->addWidget(button);
  needVolume_.push_back(button);
  return button;
}

QWidget* PlacePanel::makeButtons() {
  auto* box = new QWidget;
  auto* grid = new QGridLayout(box);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(kGrid_px);
  handles_ =
      addButton(box, "placeHandles", tr("Handles"),
                tr("Arrows and rings in the 3D view: drag one (Shift: whole millimetres and degrees), or use the arrows, Page up and "
                   "Page down there; with Alt they turn"),
                [this] { showHandles(); });
  handles_->setCheckable(true);
  onSkin_ = addButton(box, "placeOnSkin", tr("Put on the skin…"), tr("Click on the body: the near face is put flush on the skin there"),
                      [this] { askForSkin(); });
  onSkin_->setCheckable(true);
  auto* usual = addButton(box, "placeUsual", tr("Usual place"), tr("Where a probe is usually put for the region of this case"),
                          [this] { putAtUsualPlace(); });
  auto* flip = addButton(box, "placeFlip", tr("Flip left and right"), tr("Half a turn about the beams"),
                         [this] { turn(glm::pi<double>(), tr("Flip the volume left and right")); });
  auto* back =
      addButton(box, "placeTurnBack", tr("Turn 90° back"), tr("A quarter turn about the beams, anticlockwise as seen from outside"),
                [this] { turn(-glm::half_pi<double>(), tr("Turn the volume by 90°")); });
  auto* on = addButton(box, "placeTurnOn", tr("Turn 90° on"), tr("A quarter turn about the beams, clockwise as seen from outside"),
                       [this] { turn(glm::half_pi<double>(), tr("Turn the volume by 90°")); });
  int n = 0;
  for (QPushButton* button : {handles_, onSkin_, usual, flip, back, on}) {
    grid->addWidget(button, n / 2, n % 2);
    ++n;
  }
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  return box;
}

void PlacePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  showCase();
}

void PlacePanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  stopAsking();
  handlesShown_.reset();
  over_.reset();
  aids_.reset();
  drag_.reset();
}

std::optional<PlacePanel::Placed> PlacePanel::placed() const {
  const auto opened = host_.cases().current();
  const auto scan = host_.cases().scan();
  const auto scanned = host_.scan().scanned();
  if (!opened || !scan || !scanned || !scanned->skin) return std::nullopt;
  Placed now;
  now.fileToWorld = opened->volume.fileToWorld;
  const auto worldToFile = inverse(now.fileToWorld);
  now.own = ew::placed(scanned->volume, renamed<frame::World, frame::World>(worldToFile));
  now.skin = scanned->skin;
  now.voxels = scanned->voxels;
  const auto said = sweepAxesOf(*opened);
  now.isFaceSaid = said.has_value();
  const glm::dvec3 patientsRight = (worldToFile * Direction<frame::World>{{-1.0, 0.0, 0.0}}).along;
  const auto& start = opened->startPose;
  const auto beam = start ? std::optional(glm::dvec3(start->probeToWorld.matrix[1])) : std::nullopt;
  now.axes = said.value_or(axesOfFaces(now.own, patientsRight)[likelyFace(now.own, now.fileToWorld, *now.skin, beam)]);
  return now;
}

const PlacingShape& PlacePanel::shapeNow(const Placed& now) {
  const auto isSame = [&](const Grid& a, const Grid& b) {
    return a.dims == b.dims && a.spacing_mm == b.spacing_mm && glm::distance(a.origin_mm, b.origin_mm) < 1e-3;
  };
  if (!shaped_ || shaped_->voxels != now.voxels || !(shaped_->shape.axes == now.axes) || !isSame(shaped_->own, now.own))
    shaped_ = {now.voxels, now.own, now.voxels ? shapeOf(*now.voxels, now.own, now.axes) : placingShapeOf(now.own, now.axes)};
  return shaped_->shape;
}

void PlacePanel::showCase() {
  const auto opened = host_.cases().current();
  pages_->setCurrentIndex(opened ? 1 : 0);
  if (!opened) {
    stopAsking();
    handlesShown_.reset();
    over_.reset();
    aids_.reset();
    shaped_.reset();
    return;
  }
  numbers_->setTransform(opened->volume.fileToWorld);
  setProblem(problem_, {});
  const auto now = placed();
  skinSeen_ = now ? now->skin : nullptr;
  remark_->setText(
      now ? QString()
          : tr("The volume of this case is not what is scanned at the moment, so that nobody can say how it lies. Give the case a "
               "volume, prepare it, or choose View, Scan the case's volume."));
  remark_->setVisible(!now);
  contact_->setVisible(now.has_value());
  for (QPushButton* button : needVolume_) {
    button->setEnabled(now.has_value());
  }
  showFace(now);
  showPairs();
  if (!isVisible()) return;
  showHandles();
  showContactSoon();
}

void PlacePanel::showFace(const std::optional<Placed>& now) {
  if (!now) return;
  const QSignalBlocker quiet(face_);
  const auto face = faceOf(now->own, now->axes);
  // Faces are called by where they look in the body now; the file's own names would say nothing to an author.
  const std::array<QString, 6> sides = {tr("towards the left"),  tr("towards the right"), tr("towards the back"),
                                        tr("towards the front"), tr("towards the head"),  tr("towards the feet")};
  const auto all = axesOfFaces(now->own, now->axes.lateral);
  face_->clear();
  for (const SweepAxes& each : all) {
    const glm::dvec3 outward = -(now->fileToWorld * Direction<frame::File>{each.depth}).along;
    int axis = 0;
    for (int other = 1; other < 3; ++other)
      if (std::abs(outward[other]) > std::abs(outward[axis])) axis = other;
    face_->addItem(tr("the side %1").arg(sides[static_cast<std::size_t>(2 * axis + (outward[axis] < 0.0 ? 1 : 0))]));
  }
  if (!face) face_->addItem(tr("as the beams were recorded"));
  face_->setCurrentIndex(face ? static_cast<int>(*face) : kOblique);
}

void PlacePanel::chooseFace(int index) {
  const auto now = placed();
  if (!now || index == kOblique) return;
  const SweepAxes axes = axesOfFaces(now->own, now->axes.lateral)[static_cast<std::size_t>(index)];
  if (now->isFaceSaid && axes == now->axes) return;
  const auto opened = host_.cases().current();
  if (const auto done = host_.cases().edit(withSweepAxes(*opened, axes), tr("Choose the near face").toStdString(), {}); !done)
    say(done.error());
}

void PlacePanel::showContactSoon() {
  if (contactSoon_.isActive()) return;
  // At most a third of the time goes into it, so that the volume follows the hand.
  contactSoon_.start(std::clamp(static_cast<int>(2.0 * contactCost_ms_), 0, 300));
}

void PlacePanel::showContact() {
  const auto now = placed();
  if (!now || !isVisible()) return;
  QElapsedTimer clock;
  const PlacingShape& shape = shapeNow(*now);
  clock.start();
  const Contact contact = contactOf(shape, now->fileToWorld, *now->skin);
  const auto words = [&] {
    switch (verdictOf(contact)) {
      case ContactVerdict::good:
        return tr("The near face lies on the skin.");
      case ContactVerdict::standsOff:
        return tr("The near face stands off the skin; move the volume in, or turn it flush.");
      case ContactVerdict::liesBelow:
        return tr("The near face lies below the skin; move the volume out.");
      case ContactVerdict::tipped:
        return tr("The near face is tipped: one side stands off the skin, another lies below it; turn it flush.");
      case ContactVerdict::outside:
        return tr("Part of the volume lies outside the body; turn it round, so that the beams look inwards.");
    }
    return QString();
  };
  verdict_->setText(words());
  share_->setValue(static_cast<int>(std::lround(100.0 * contact.faceShare)));
  QString figures =
      tr("%1 % of the near face touch the skin (within %2 mm). Largest gap %3 mm, deepest below %4 mm. %5 % of the volume lie outside "
         "the body.")
          .arg(placingPercent(contact.faceShare), placingNumber(kGel_mm, 0), placingNumber(contact.deepestGap_mm),
               placingNumber(contact.deepestIntrusion_mm), placingPercent(contact.outsideShare));
  for (const char* unit : {"%", "mm"}) figures.replace(QLatin1Char(' ') + QLatin1String(unit), QChar(QChar::Nbsp) + QLatin1String(unit));
  figures_->setText(figures);
  drawFace(*now, shape);
  contactCost_ms_ = static_cast<double>(clock.elapsed());
}

void PlacePanel::place(const FilePlace& fileToWorld, const QString& what, const std::string& mergeKey) {
  auto next = host_.cases().current();
  if (!next) return;
  setProblem(problem_, {});
  const auto before = std::exchange(next->volume.fileToWorld, fileToWorld);
  if (before == fileToWorld) return;
  const auto done = host_.cases().edit(*next, what.toStdString(), mergeKey);
  if (done) return;
  // Numbers and handles are where the author put them; the volume is not.
  numbers_->setTransform(before);
  showHandles();
  say(done.error());
}

void PlacePanel::turn(double angle_rad, const QString& what) {
  if (const auto now = placed()) place(turnedAboutBeam(now->own, now->axes, now->fileToWorld, angle_rad), what, {});
}

void PlacePanel::putAtUsualPlace() {
  const auto now = placed();
  const auto opened = host_.cases().current();
  if (!now || !opened) return;
  MannequinLandmarks known;
  known.sites = sites_;
  const PlacingSite* site = siteFor(known, opened->region);
  if (site == nullptr) {
    setProblem(problem_, tr("Nobody has said where a probe is usually put on this mannequin; use the handles, or click on the skin."));
    return;
  }
  place(firstPlacement(shapeNow(*now), *now->skin, *site), tr("Put the volume at its usual place"), {});
}

void PlacePanel::askForSkin() {
  const bool asks = onSkin_->isChecked();
  stopAsking();
  if (!asks) return;
  onSkin_->setChecked(true);
  asking_ = host_.overlays().askForBodyPoint(
      tr("Click where the middle of the near face is to lie. Escape leaves it where it is.").toStdString(),
      [this](const Point<frame::World>& at) {
        const auto now = placed();
        stopAsking();
        if (now) place(putOnSkin(shapeNow(*now), now->fileToWorld, *now->skin, at), tr("Put the volume on the skin"), {});
      },
      [this] { stopAsking(); });
}

void PlacePanel::say(const Error& problem) {
  host_.log().warn(problem.sentence());
  setProblem(problem_, words(problem.message));
}

}  // namespace ew::case_authoring
