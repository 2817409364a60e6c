#include "panel/stitch_stage.h"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QMimeData>
#include <QPainter>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "ew/widgets/ellipsis_label.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/marks.h"
#include "panel/session_door.h"
#include "panel/stitch_session.h"

namespace ew::stitching {
namespace {

constexpr int kInspectorWidth_px = 312;
constexpr int kMostInspectorWidth_px = 420;  // with large words it scrolls to the side, and the views keep their room

void chooseIn(QComboBox* box, int data) {
  const int at = box->findData(data);
  if (at >= 0) box->setCurrentIndex(at);
}

QString titleOf(Tools::Fourth fourth) {
  switch (fourth) {
    case Tools::Fourth::placement:
      return StitchStage::tr("where they lie");
    case Tools::Fourth::displacement:
      return StitchStage::tr("10 mm grid");
    case Tools::Fourth::seam:
      return {};
    case Tools::Fourth::result:
      return StitchStage::tr("the result");
  }
  return {};
}

QComboBox* smallCombo(const char* name, const QString& hint) {
  auto* box = new QComboBox;
  box->setObjectName(QLatin1String(name));
  box->setToolTip(hint);
  setLook(box, Look::small);
  box->setFocusPolicy(Qt::TabFocus);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(5);
  box->setMinimumWidth(72);
  box->setMaximumWidth(128);
  return box;
}

QPushButton* smallToggle(const QString& text, const QString& hint, const char* name) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  button->setCheckable(true);
  setLook(button, Look::compact);
  setLook(button, Look::small);
  button->setToolTip(hint);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

}  // namespace

StitchStage::StitchStage(StitchSession& session, QWidget* parent)
    : QWidget(parent), document_(session.document()), inputs_(session.inputs()), look_(session.look()), edits_(session.edits()) {
  setObjectName(QStringLiteral("stitchStage"));
  setAccessibleName(tr("Views of the volumes"));
  setAcceptDrops(true);
  new SessionDoor(session, this);
  setFocusPolicy(Qt::ClickFocus);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);

  makeViews(session);
  makeCutControls();
  makeOverlayControls();
  makeFourthChoice();
  makeBrush();
  inspector_ = new PairInspector(session, tools_);
  inspector_->setFixedWidth(std::min(scaled(kInspectorWidth_px), kMostInspectorWidth_px));
  connect(inspector_, &PairInspector::handChosen, this, [this] { toolsChanged(); });
  row->addWidget(makeGrid(), 1);
  auto* line = new QWidget;
  line->setFixedWidth(1);
  line->setAutoFillBackground(true);
  line->setBackgroundRole(QPalette::Mid);
  row->addWidget(line);
  row->addWidget(inspector_);

  connectSession(session);
  showTitles();
  setFourth(tools_.fourth);
}

void StitchStage::makeViews(StitchSession& session) {
  const auto view = [&](SliceView::Kind kind, const char* name) {
    auto* made = new SliceView(kind, session, tools_);
    made->setObjectName(QLatin1String(name));
    made->keys = [this](QKeyEvent& event, bool act) { return handleKey(event, act); };
    return made;
  };
  fixed_ = view(SliceView::Kind::fixed, "fixedView");
  moving_ = view(SliceView::Kind::moving, "movingView");
  overlap_ = view(SliceView::Kind::overlap, "overlapView");
  fourth_ = view(SliceView::Kind::fourth, "fourthView");
  placement_ = new PlacementView(session);
  fourthPages_ = new QStackedWidget;
  fourthPages_->addWidget(placement_);
  fourthPages_->addWidget(fourth_);
}

void StitchStage::makeCutControls() {
  cut_ = smallCombo("cut", tr("Which way the plane lies (1, 2, 3); right drag in a view turns it"));
  cut_->addItem(tr("axial"), static_cast<int>(Cut::axial));
  cut_->addItem(tr("coronal"), static_cast<int>(Cut::coronal));
  cut_->addItem(tr("sagittal"), static_cast<int>(Cut::sagittal));
  connect(cut_, qOverload<int>(&QComboBox::activated), this, [this] { look_.setCut(static_cast<Cut>(cut_->currentData().toInt())); });
  linked_ =
      smallToggle(tr("Linked"), tr("Both cross-hairs mark the same place; unlink them to look at each volume for itself (L)"), "linked");
  connect(linked_, &QPushButton::clicked, this, [this](bool on) { look_.setLinked(on); });
}

void StitchStage::makeOverlayControls() {
  overlay_ = smallCombo("overlayKind", tr("How both are laid over each other (C)"));
  overlay_->addItem(tr("checkerboard"), static_cast<int>(Overlay::checkerboard));
  overlay_->addItem(tr("difference"), static_cast<int>(Overlay::difference));
  overlay_->addItem(tr("flicker"), static_cast<int>(Overlay::flicker));
  overlay_->addItem(tr("colours"), static_cast<int>(Overlay::colours));
  overlay_->setMinimumContentsLength(11);
  overlay_->setMinimumWidth(84);  // in the narrowest window all of a head's controls stay beside each other
  overlay_->setMaximumWidth(136);
  connect(overlay_, qOverload<int>(&QComboBox::activated), this,
          [this] { setOverlay(static_cast<Overlay>(overlay_->currentData().toInt())); });
  stageChoice_ = smallCombo("stageChoice", tr("As it was at the start, as matched, or with the elastic step (X)"));
  connect(stageChoice_, qOverload<int>(&QComboBox::activated), this,
          [this] { look_.setStage(static_cast<StitchLook::Stage>(stageChoice_->currentData().toInt())); });
  halves_ = smallToggle(QStringLiteral("◧"), tr("Before and after side by side: the start at the left, the present at the right (B)"),
                        "beforeAfter");
  halves_->setAccessibleName(tr("Before and after"));
  halves_->setFixedWidth(32);
  connect(halves_, &QPushButton::clicked, this, [this](bool on) {
    tools_.sideBySide = on;
    toolsChanged();
  });
}

void StitchStage::makeFourthChoice() {
  fourthChoice_ = smallCombo("fourthChoice", tr("What this view shows (G)"));
  fourthChoice_->addItem(tr("placement"), static_cast<int>(Tools::Fourth::placement));
  fourthChoice_->addItem(tr("displacement"), static_cast<int>(Tools::Fourth::displacement));
  fourthChoice_->addItem(tr("seam"), static_cast<int>(Tools::Fourth::seam));
  fourthChoice_->addItem(tr("result"), static_cast<int>(Tools::Fourth::result));
  fourthChoice_->setMinimumWidth(124);
  connect(fourthChoice_, qOverload<int>(&QComboBox::activated), this,
          [this] { setFourth(static_cast<Tools::Fourth>(fourthChoice_->currentData().toInt())); });
}

void StitchStage::makeBrush() {
  brushRow_ = new QWidget;
  auto* brushes = new QHBoxLayout(brushRow_);
  brushes->setContentsMargins(0, 0, 0, 0);
  brushes->setSpacing(kGrid_px / 2);
  paint_ = smallToggle(tr("Prefer"), tr("Paint where a view is to be preferred (V); here and in the overlap"), "paintSeam");
  connect(paint_, &QPushButton::clicked, this, [this](bool on) { setHand(on ? Tools::Hand::paint : Tools::Hand::look); });
  brushView_ = smallCombo("brushView", tr("The view that is preferred where you paint"));
  brushView_->setMinimumContentsLength(1);
  brushView_->setMinimumWidth(48);
  connect(brushView_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
    tools_.brushView = static_cast<std::size_t>(std::max(0, index));
    toolsChanged();
  });
  brush_ = new NumberField(1.0, 50.0, 0, tr("mm"));
  brush_->setObjectName(QStringLiteral("brush"));
  setLook(brush_, Look::small);
  brush_->setMinimumWidth(68);
  brush_->setValue(tools_.brush_mm);
  brush_->setToolTip(tr("Radius of the brush ([ and ])"));
  connect(brush_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    tools_.brush_mm = value;
    toolsChanged();
  });
  brushes->addWidget(paint_);
  brushes->addWidget(brushView_);
  brushes->addWidget(brush_);
}

QWidget* StitchStage::makeGrid() {
  auto* grid = new QWidget;
  auto* cells = new QGridLayout(grid);
  cells->setContentsMargins(0, 0, 0, 0);
  cells->setSpacing(1);
  cells->addWidget(makeFrame(titles_[0], fixed_, {cut_}), 0, 0);
  cells->addWidget(makeFrame(titles_[1], overlap_, {overlay_, stageChoice_, halves_}), 0, 1);
  cells->addWidget(makeFrame(titles_[2], moving_, {linked_}), 1, 0);
  cells->addWidget(makeFrame(titles_[3], fourthPages_, {brushRow_, fourthChoice_}), 1, 1);
  for (const int n : {0, 1}) {
    cells->setRowStretch(n, 1);
    cells->setColumnStretch(n, 1);
  }
  return grid;
}

void StitchStage::connectSession(StitchSession& session) {
  flicker_.setInterval(450);
  connect(&flicker_, &QTimer::timeout, this, [this] {
    tools_.flickerSecond = !tools_.flickerSecond;
    overlap_->refresh();
    showTitles();
  });
  connect(&session, &StitchSession::changed, this, &StitchStage::showTitles);
  connect(&session, &StitchSession::lookChanged, this, &StitchStage::showTitles);
  connect(&session.runs(), &StitchRuns::resultMade, this, [this] {
    if (tools_.fourth != Tools::Fourth::seam) setFourth(Tools::Fourth::result);  // a seam that is being edited stays in view
  });
}

QWidget* StitchStage::makeFrame(QLabel*& title, QWidget* content, const std::vector<QWidget*>& controls) {
  auto* frame = new QWidget;
  frame->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Expanding);  // all four of one width, whatever stands in their heads
  auto* column = new QVBoxLayout(frame);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  auto* head = new QWidget;
  head->setFixedHeight(kGrid_px + scaled(28));
  head->setAutoFillBackground(true);
  auto* row = new QHBoxLayout(head);
  row->setContentsMargins(kGrid_px, 3, kGrid_px / 2, 3);
  row->setSpacing(kGrid_px / 2);
  title = new EllipsisLabel;
  setLook(title, Look::small);
  title->setBuddy(content);  // and so its name for who has it read aloud
  row->addWidget(title, 1);
  for (QWidget* control : controls) row->addWidget(control);
  column->addWidget(head);
  column->addWidget(content, 1);
  return frame;
}

void StitchStage::showTitles() {
  const bool was = std::exchange(showing_, true);
  const auto& pair = look_.pair();
  const auto& volumes = document_.project().volumes;
  const auto put = [](QLabel* label, const QString& text, const QString& tip) {
    label->setText(text);
    label->setToolTip(tip);
  };
  if (pair) {
    const QString a = words(letterOf(pair->fixed));
    const QString b = words(letterOf(pair->moving));
    put(titles_[0], tr("%1 fixed").arg(a) + QStringLiteral(" · ") + words(volumes[pair->fixed].name), words(volumes[pair->fixed].name));
    put(titles_[2], tr("%1 moving").arg(b) + QStringLiteral(" · ") + words(volumes[pair->moving].name), words(volumes[pair->moving].name));
    const bool flickers = tools_.overlay == Overlay::flicker;
    put(titles_[1], flickers ? (tools_.flickerSecond ? b : a) : tr("%1 and %2").arg(a, b), tr("%1 and %2 over each other").arg(a, b));
  } else {
    put(titles_[0], tr("fixed"), {});
    put(titles_[1], tr("both"), {});
    put(titles_[2], tr("moving"), {});
  }
  put(titles_[3], titleOf(tools_.fourth), {});
  for (QWidget* control : {static_cast<QWidget*>(cut_), static_cast<QWidget*>(linked_), static_cast<QWidget*>(overlay_),
                           static_cast<QWidget*>(stageChoice_), static_cast<QWidget*>(halves_), static_cast<QWidget*>(fourthChoice_)})
    control->setVisible(pair.has_value());
  linked_->setChecked(look_.isLinked());
  const auto stage = look_.stage();
  stageChoice_->clear();
  stageChoice_->addItem(tr("start"), static_cast<int>(StitchLook::Stage::start));
  stageChoice_->addItem(tr("matched"), static_cast<int>(StitchLook::Stage::rigid));
  if (look_.hasElastic()) stageChoice_->addItem(tr("elastic"), static_cast<int>(StitchLook::Stage::elastic));
  chooseIn(stageChoice_, static_cast<int>(stage));
  if (brushView_->count() != static_cast<int>(volumes.size())) {
    brushView_->clear();
    for (std::size_t n = 0; n < volumes.size(); ++n) brushView_->addItem(words(letterOf(n)));
    if (tools_.brushView >= volumes.size()) tools_.brushView = 0;
    brushView_->setCurrentIndex(static_cast<int>(tools_.brushView));
  }
  showing_ = was;
  for (const QLabel* each : findChildren<QLabel*>()) {
    if (each->buddy() == nullptr) continue;
    each->buddy()->setAccessibleName(each->text());
    if (auto* views = qobject_cast<QStackedWidget*>(each->buddy()))
      for (int n = 0; n < views->count(); ++n) views->widget(n)->setAccessibleName(each->text());
  }
}

void StitchStage::toolsChanged() {
  if (tools_.overlay == Overlay::flicker && !flicker_.isActive()) flicker_.start();
  if (tools_.overlay != Overlay::flicker) flicker_.stop();
  chooseIn(overlay_, static_cast<int>(tools_.overlay));
  chooseIn(fourthChoice_, static_cast<int>(tools_.fourth));
  halves_->setChecked(tools_.sideBySide);
  paint_->setChecked(tools_.hand == Tools::Hand::paint);
  const Qt::CursorShape shape = tools_.hand == Tools::Hand::look ? Qt::ArrowCursor : Qt::CrossCursor;
  for (SliceView* each : {fixed_, moving_, overlap_, fourth_}) {
    each->setCursor(shape);
    each->refresh();
  }
  showTitles();
}

void StitchStage::setFourth(Tools::Fourth fourth) {
  tools_.fourth = fourth;
  fourthPages_->setCurrentWidget(fourth == Tools::Fourth::placement ? static_cast<QWidget*>(placement_) : fourth_);
  brushRow_->setVisible(fourth == Tools::Fourth::seam);
  if (fourth != Tools::Fourth::seam && tools_.hand == Tools::Hand::paint) tools_.hand = Tools::Hand::look;
  toolsChanged();
}

void StitchStage::setHand(Tools::Hand hand) {
  if (hand == Tools::Hand::paint && tools_.fourth != Tools::Fourth::seam) setFourth(Tools::Fourth::seam);
  if (tools_.hand == Tools::Hand::pick && hand != Tools::Hand::pick) look_.dropPick();
  tools_.hand = hand;
  toolsChanged();
  inspector_->refresh();
}

void StitchStage::setOverlay(Overlay overlay) {
  tools_.overlay = overlay;
  tools_.flickerSecond = false;
  toolsChanged();
}

std::vector<std::pair<std::string, std::string>> StitchStage::keyLines() {
  const auto line = [](const char* keys, const QString& what) { return std::pair(std::string(keys), what.toStdString()); };
  const auto said = [](const QString& keys, const QString& what) { return std::pair(keys.toStdString(), what.toStdString()); };
  return {said(tr("Arrows, PgUp, PgDown"), tr("nudge by 0.5 mm, with Shift 2 mm, with Ctrl 0.1 mm")),
          line("Q, E", tr("rotate in the plane by 1°, with Shift 5°")),
          line("A, D, W, S", tr("rotate out of the plane")),
          said(tr("Drag"), tr("move the cross-hairs")),
          said(tr("Wheel; , ."), tr("step through by 1 mm, with Shift 5 mm")),
          said(tr("Ctrl + wheel; + -; 0"), tr("zoom; everything in view")),
          said(tr("Right drag, middle drag"), tr("rotate the plane, shift it")),
          line("1, 2, 3", tr("axial, coronal, sagittal")),
          line("N, Shift+N", tr("next, previous pair")),
          line("C, X, B", tr("overlay, start or result, before and after")),
          line("G", tr("placement, displacement, seam, result")),
          line("L", tr("cross-hairs linked or each for itself")),
          line("P, Esc", tr("pick landmarks, stop")),
          said(tr("Delete"), tr("remove the chosen landmark")),
          line("V, [ ]", tr("paint a preference, size of the brush")),
          said(tr("Enter, Backspace"), tr("accept, reject the pair")),
          line("Ctrl+Z, Ctrl+Shift+Z, Ctrl+S", tr("undo, redo, save the project"))};
}

bool StitchStage::handleKey(const QKeyEvent& event, bool act) {
  if (event.modifiers().testFlag(Qt::AltModifier)) return false;
  if (nudgeByKey(event, act)) return true;
  if (event.modifiers().testFlag(Qt::ControlModifier)) return false;
  return lookByKey(event, act) || chooseViewByKey(event, act) || useHandByKey(event, act) || judgeByKey(event, act);
}

/// Moves and turns the moving volume: with Shift far, with Ctrl a little.
bool StitchStage::nudgeByKey(const QKeyEvent& event, bool act) {
  const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
  const bool ctrl = event.modifiers().testFlag(Qt::ControlModifier);
  const double mm = ctrl ? 0.1 : shift ? 2.0 : 0.5;
  const double deg = shift ? 5.0 : 1.0;
  const auto nudge = [&](const glm::dvec3& shift_mm, const glm::dvec3& rotation_deg) {
    if (!act) return true;
    edits_.nudge(shift_mm, rotation_deg);
    return true;
  };
  switch (event.key()) {
    case Qt::Key_Left:
      return nudge({-mm, 0, 0}, {});
    case Qt::Key_Right:
      return nudge({mm, 0, 0}, {});
    case Qt::Key_Up:
      return nudge({0, -mm, 0}, {});
    case Qt::Key_Down:
      return nudge({0, mm, 0}, {});
    case Qt::Key_PageUp:
      return nudge({0, 0, mm}, {});
    case Qt::Key_PageDown:
      return nudge({0, 0, -mm}, {});
    default:
      break;
  }
  if (ctrl) return false;  // with Ctrl the letters are the window's
  switch (event.key()) {
    case Qt::Key_Q:
      return nudge({}, {0, 0, -deg});
    case Qt::Key_E:
      return nudge({}, {0, 0, deg});
    case Qt::Key_A:
      return nudge({}, {0, -deg, 0});
    case Qt::Key_D:
      return nudge({}, {0, deg, 0});
    case Qt::Key_W:
      return nudge({}, {-deg, 0, 0});
    case Qt::Key_S:
      return nudge({}, {deg, 0, 0});
    default:
      return false;
  }
}

/// The plane that all views show.
bool StitchStage::lookByKey(const QKeyEvent& event, bool act) {
  const auto run = [act](auto&& does) {
    if (act) does();
    return true;
  };
  const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
  switch (event.key()) {
    case Qt::Key_1:
    case Qt::Key_2:
    case Qt::Key_3:
      return run([&] {
        const int n = event.key() - Qt::Key_1;
        cut_->setCurrentIndex(n);
        look_.setCut(static_cast<Cut>(n));
      });
    case Qt::Key_0:
      return run([&] { look_.fit(); });
    case Qt::Key_Comma:
    case Qt::Key_Less:
    case Qt::Key_Semicolon:
      return run([&] { look_.setCross(look_.cross() - (shift ? 5.0 : 1.0) * look_.plane().normal()); });
    case Qt::Key_Period:
    case Qt::Key_Greater:
    case Qt::Key_Colon:
      return run([&] { look_.setCross(look_.cross() + (shift ? 5.0 : 1.0) * look_.plane().normal()); });
    case Qt::Key_Plus:
    case Qt::Key_Equal:
    case Qt::Key_Minus:
      return run([&] {
        Plane plane = look_.plane();
        plane.pixel_mm = std::clamp(plane.pixel_mm * (event.key() == Qt::Key_Minus ? 1.2 : 1.0 / 1.2), 0.01, 5.0);
        look_.setPlane(plane);
      });
    default:
      return false;
  }
}

/// What the views show of it.
bool StitchStage::chooseViewByKey(const QKeyEvent& event, bool act) {
  const auto run = [act](auto&& does) {
    if (act) does();
    return true;
  };
  switch (event.key()) {
    case Qt::Key_C:
      return run([&] { setOverlay(static_cast<Overlay>((static_cast<int>(tools_.overlay) + 1) % 4)); });
    case Qt::Key_X:
      return run([&] {
        const int next = (static_cast<int>(look_.stage()) + 1) % (look_.hasElastic() ? 3 : 2);
        look_.setStage(static_cast<StitchLook::Stage>(next));
      });
    case Qt::Key_B:
      return run([&] {
        tools_.sideBySide = !tools_.sideBySide;
        toolsChanged();
      });
    case Qt::Key_G:
      return run([&] { setFourth(static_cast<Tools::Fourth>((static_cast<int>(tools_.fourth) + 1) % 4)); });
    case Qt::Key_L:
      return run([&] { look_.setLinked(!look_.isLinked()); });
    default:
      return false;
  }
}

/// What a click in a view does.
bool StitchStage::useHandByKey(const QKeyEvent& event, bool act) {
  const auto run = [act](auto&& does) {
    if (act) does();
    return true;
  };
  switch (event.key()) {
    case Qt::Key_P:
      return run([&] { setHand(tools_.hand == Tools::Hand::pick ? Tools::Hand::look : Tools::Hand::pick); });
    case Qt::Key_V:
      return run([&] { setHand(tools_.hand == Tools::Hand::paint ? Tools::Hand::look : Tools::Hand::paint); });
    case Qt::Key_BracketLeft:
    case Qt::Key_BracketRight:
      return run([&] { brush_->setValue(brush_->value() + (event.key() == Qt::Key_BracketLeft ? -1.0 : 1.0)); });
    case Qt::Key_Escape:
      if (tools_.hand == Tools::Hand::look) return false;
      return run([&] {
        if (look_.pickedFixed() || look_.pickedMoving())
          look_.dropPick();
        else
          setHand(Tools::Hand::look);
        inspector_->refresh();
      });
    default:
      return false;
  }
}

bool StitchStage::judgeByKey(const QKeyEvent& event, bool act) {
  const auto run = [act](auto&& does) {
    if (act) does();
    return true;
  };
  const bool shift = event.modifiers().testFlag(Qt::ShiftModifier);
  switch (event.key()) {
    case Qt::Key_N:
      return run([&] { Q_EMIT look_.nextPairAsked(shift ? -1 : 1); });
    case Qt::Key_Delete:
      return run([&] { edits_.removeLandmark(look_.chosenLandmark()); });
    case Qt::Key_Return:
    case Qt::Key_Enter:
      return run([&] { edits_.setDecision(Decision::accepted); });
    case Qt::Key_Backspace:
      return run([&] { edits_.setDecision(Decision::rejected); });
    default:
      return false;
  }
}

void StitchStage::keyPressEvent(QKeyEvent* event) {
  if (!handleKey(*event, true)) QWidget::keyPressEvent(event);
}

bool StitchStage::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride && hasFocus() && handleKey(*static_cast<QKeyEvent*>(event), false)) {
    event->accept();
    return true;
  }
  return QWidget::event(event);
}

void StitchStage::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void StitchStage::dropEvent(QDropEvent* event) { inputs_.addDropped(*event); }

}  // namespace ew::stitching
