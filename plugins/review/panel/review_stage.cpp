#include "panel/review_stage.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include "ew/bridge/scene3d.h"
#include "ew/sdk/window.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/figures.h"
#include "ew/widgets/flow_layout.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "panel/body_view.h"
#include "panel/class_page.h"
#include "panel/image_view.h"
#include "panel/review_words.h"
#include "panel/session/review_session.h"
#include "panel/session_door.h"
#include "panel/track_view.h"

namespace ew::review {

namespace {

constexpr double kSpeeds[] = {0.25, 0.5, 1.0, 2.0, 4.0};
constexpr double kMostOffset_s = 600.0;

QPushButton* segment(const QString& text, const QString& tip, const char* name, Look place) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  button->setCheckable(true);
  setLook(button, Look::small);
  setLook(button, place);
  button->setToolTip(tip);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

QPushButton* smallButton(const QString& text, const QString& tip, const char* name) {
  auto* button = new QPushButton(text);
  button->setObjectName(QLatin1String(name));
  setLook(button, Look::small);
  setLook(button, Look::compact);
  button->setToolTip(tip);
  button->setFocusPolicy(Qt::TabFocus);
  return button;
}

/// Buttons that are one choice: no gap between them, and no end of a line.
QWidget* together(const std::vector<QPushButton*>& segments) {
  auto* group = new QWidget;
  auto* row = new QHBoxLayout(group);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(0);
  for (QPushButton* each : segments) row->addWidget(each);
  return group;
}

/// A row of controls that goes on in a next line where text is large and the window small.
FlowLayout* controlRow(QWidget* bar) {
  auto* row = new FlowLayout(kGrid_px / 2);
  row->setContentsMargins(kGrid_px, kGrid_px / 2, kGrid_px, kGrid_px / 2);
  bar->setLayout(row);
  return row;
}

QWidget* hairline() {
  auto* line = new QWidget;
  line->setFixedHeight(1);
  line->setAutoFillBackground(true);
  line->setBackgroundRole(QPalette::Mid);
  return line;
}

}  // namespace

ReviewStage::ReviewStage(ReviewSession& session, QWidget* parent)
    : QWidget(parent),
      session_(session),
      selection_(session.selection()),
      scans_(session.scans()),
      playback_(session.playback()),
      comments_(session.comments()) {
  setObjectName(QStringLiteral("reviewStage"));
  setAccessibleName(tr("Both scans"));
  setFocusPolicy(Qt::ClickFocus);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  pages_ = new QStackedWidget;
  auto* scans = new QWidget;
  auto* column = new QVBoxLayout(scans);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(makeViews(), 1);
  column->addWidget(makeDrawing());
  column->addWidget(hairline());
  column->addWidget(makeTransport());
  tracks_ = new TrackView(playback_, scans_, comments_);
  column->addWidget(tracks_);
  pages_->addWidget(scans);
  pages_->addWidget(new ClassPage(session_));
  auto* look = new QPushButton(tr("Find new attempts"));
  look->setObjectName(QStringLiteral("reviewLookAgain"));
  connect(look, &QPushButton::clicked, this, [this] { session_.readShelf(); });
  pages_->addWidget(emptyState(tr("Nothing to review yet"),
                               tr("When trainees have worked through lessons at this library, their attempts are listed at the left. "
                                  "Open a case with lessons to see its expert's scans."),
                               look));
  rows->addWidget(pages_);
  for (QWidget* each :
       std::initializer_list<QWidget*>{reviewed_, compared_, tracks_, body_->findChild<QWidget*>(QStringLiteral("reviewBodyCanvas"))})
    each->installEventFilter(this);
  connect(&playback_, &Playback::clockChanged, this, &ReviewStage::showClock);
  connect(&playback_, &Playback::timeChanged, this, &ReviewStage::showClock);
  connect(&scans_, &ScanPair::changed, this, [this] {
    showClock();
    showTools();
  });
  connect(&comments_, &AttemptComments::changed, this, &ReviewStage::showTools);
  const auto page = [this] {
    const bool isEmpty = selection_.hasShelf() && selection_.shelf().lessons.empty() && scans_.opened(kReviewed) == nullptr &&
                         scans_.opened(kCompared) == nullptr && !scans_.isOpening();
    pages_->setCurrentIndex(session_.showsClass() ? kClassPage : isEmpty ? kEmptyPage : kScansPage);
  };
  connect(&session_, &ReviewSession::pageChanged, this, page);
  connect(&selection_, &ReviewSelection::shelfChanged, this, page);
  connect(&scans_, &ScanPair::changed, this, page);
  page();
  new SessionDoor(session_.reports(), *reviewed_, *compared_, *tracks_, *body_, this);
  held_ = session_.document().holdWork(
      {[this] { return writeComment(); },
       [this] { return isCommentBegun() ? tr("A comment was begun and not added.").toStdString() : std::string(); }});
  showIcons();
  showClock();
  showTools();
}

QWidget* ReviewStage::makeViews() {
  auto* splitter = new QSplitter(Qt::Horizontal);
  splitter->setChildrenCollapsible(false);
  splitter->setHandleWidth(2);
  compared_ = new ImageView(kCompared, session_);
  reviewed_ = new ImageView(kReviewed, session_);
  compared_->setOther(reviewed_);
  reviewed_->setOther(compared_);
  connect(reviewed_, &ImageView::drawnChanged, this, &ReviewStage::showTools);
  splitter->addWidget(compared_);
  splitter->addWidget(reviewed_);
  splitter->addWidget(makeBodyFrame());
  for (int n = 0; n < 3; ++n) splitter->setStretchFactor(n, 1);
  splitter->setSizes({340, 340, 280});
  return splitter;
}

QWidget* ReviewStage::makeBodyFrame() {
  auto* frame = new QWidget;
  auto* rows = new QVBoxLayout(frame);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);
  body_ = new BodyView(scans_, playback_);
  heat_ = new QComboBox;
  heat_->setObjectName(QStringLiteral("reviewHeat"));
  setLook(heat_, Look::small);
  heat_->setFocusPolicy(Qt::TabFocus);
  heat_->setAccessibleName(tr("Regions of the volume"));
  heat_->setToolTip(tr("Which regions of the volume were seen, and which were not (H)"));
  heat_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  heat_->setMinimumContentsLength(10);
  for (int n = 0; n < kHeats; ++n) heat_->addItem(titleOf(static_cast<Heat>(n)));
  connect(heat_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this](int n) { body_->setHeat(static_cast<Heat>(n)); });
  auto* planes = smallButton(tr("Planes"), tr("The planes where the probe rested or the image was frozen"), "reviewPlanes");
  planes->setCheckable(true);
  planes->setChecked(true);
  connect(planes, &QPushButton::toggled, this, [this](bool on) { body_->setPlanesShown(on); });
  auto* front = smallButton(tr("Front"), tr("Look from the front"), "reviewFront");
  connect(front, &QPushButton::clicked, this, [this] { body_->showFrom(bridge::CameraPreset::front); });
  heat_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  auto* head = new QWidget;
  FlowLayout* row = controlRow(head);
  row->setContentsMargins(kGrid_px / 2, kGrid_px / 2, kGrid_px / 2, kGrid_px / 2);
  row->addWidget(heat_);
  row->addWidget(planes);
  row->addWidget(front);
  rows->addWidget(head);
  rows->addWidget(body_, 1);
  return frame;
}

QToolButton* ReviewStage::iconButton(const char* name, const char* icon, const QString& tip) {
  auto* button = new QToolButton;
  button->setObjectName(QLatin1String(name));
  button->setToolTip(tip);
  button->setAccessibleName(tip);
  button->setFocusPolicy(Qt::TabFocus);
  button->setIconSize({scaled(18), scaled(18)});
  icons_.emplace_back(button, QLatin1String(icon));
  return button;
}

QWidget* ReviewStage::makeTransport() {
  auto* bar = new QWidget;
  FlowLayout* row = controlRow(bar);
  const auto button = [&](const char* name, const char* icon, const QString& tip, auto does) {
    auto* made = iconButton(name, icon, tip);
    connect(made, &QToolButton::clicked, this, does);
    row->addWidget(made);
    return made;
  };
  button("reviewPrevious", "step-back", tr("To the event before (P)"), [this] { playback_.jump(false); });
  play_ = button("reviewPlay", "play", tr("Play or rest (Space)"),
                 [this] { playback_.clock().isPlaying() ? playback_.pause() : playback_.play(); });
  button("reviewNext", "step-on", tr("To the next event (N)"), [this] { playback_.jump(true); });
  time_ = new QLabel;
  time_->setObjectName(QStringLiteral("reviewTime"));
  time_->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-00:00.0 / 00:00.0 ")));
  row->addWidget(time_);
  speed_ = new QComboBox;
  speed_->setObjectName(QStringLiteral("reviewSpeed"));
  setLook(speed_, Look::small);
  speed_->setFocusPolicy(Qt::TabFocus);
  speed_->setAccessibleName(tr("Speed"));
  speed_->setToolTip(tr("Speed (- and +)"));
  for (const double speed : kSpeeds) speed_->addItem(QStringLiteral("× ") + QLocale().toString(speed), speed);
  speed_->setCurrentIndex(2);
  connect(speed_, qOverload<int>(&QComboBox::activated), this, [this] { playback_.setSpeed(speed_->currentData().toDouble()); });
  row->addWidget(speed_);
  button("reviewLoopBegin", "mark-in", tr("The loop begins here; again: no longer ([)"), [this] { playback_.markLoop(true); });
  button("reviewLoopEnd", "mark-out", tr("The loop ends here; again: no longer (])"), [this] { playback_.markLoop(false); });
  atEnd_ = smallButton(tr("Repeat"), tr("Goes on from the beginning at the end"), "reviewRepeat");
  atEnd_->setCheckable(true);
  connect(atEnd_, &QPushButton::clicked, this, [this](bool on) { playback_.setAtEnd(on ? AtEnd::beginAnew : AtEnd::rest); });
  row->addWidget(atEnd_);
  row->addStretch();
  oneClock_ =
      segment(tr("One clock"), tr("Both scans go on in the same seconds, each from its beginning"), "reviewOneClock", Look::firstOf);
  aligned_ = segment(tr("Aligned"), tr("The expert's scan follows the trainee's probe: the same places at the same time (T)"),
                     "reviewAligned", Look::lastOf);
  connect(oneClock_, &QPushButton::clicked, this, [this] { playback_.setAligned(false); });
  connect(aligned_, &QPushButton::clicked, this, [this] { playback_.setAligned(true); });
  row->addWidget(together({oneClock_, aligned_}));
  offset_ = new NumberField(-kMostOffset_s, kMostOffset_s, 1, QStringLiteral("s"));
  offset_->setObjectName(QStringLiteral("reviewOffset"));
  setLook(offset_, Look::small);
  offset_->setSingleStep(0.5);
  offset_->setAccessibleName(tr("The expert's scan begins later by"));
  offset_->setToolTip(tr("The expert's scan begins so much later than the trainee's"));
  connect(offset_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double value) {
    if (!showing_) playback_.setOffset(value);
  });
  row->addWidget(offset_);
  return bar;
}

QWidget* ReviewStage::makeDrawing() {
  drawing_ = new QWidget;
  FlowLayout* row = controlRow(drawing_);
  const auto tool = [&](const QString& text, const QString& tip, const char* name, Look place, CommentStroke::Kind kind) {
    auto* made = segment(text, tip, name, place);
    connect(made, &QPushButton::clicked, this, [this, kind](bool on) { chooseTool(on ? std::optional(kind) : std::nullopt); });
    tools_.push_back(made);
  };
  tool(tr("Line"), tr("Draw a line on the trainee's image (D)"), "reviewLine", Look::firstOf, CommentStroke::Kind::line);
  tool(tr("Arrow"), tr("Draw an arrow on the trainee's image"), "reviewArrow", Look::segment, CommentStroke::Kind::arrow);
  tool(tr("Circle"), tr("Draw a circle on the trainee's image, from its middle"), "reviewCircle", Look::lastOf,
       CommentStroke::Kind::circle);
  row->addWidget(together(tools_));
  dropDrawing_ = smallButton(tr("Clear"), tr("Take away what was drawn (Escape)"), "reviewDropDrawing");
  connect(dropDrawing_, &QPushButton::clicked, this, [this] { reviewed_->setDrawn({}); });
  row->addWidget(dropDrawing_);
  commentText_ = new QLineEdit;
  commentText_->setObjectName(QStringLiteral("reviewCommentText"));
  commentText_->setMaxLength(2000);
  commentText_->setPlaceholderText(tr("What do you see at this moment?"));
  commentText_->setAccessibleName(tr("Comment at this moment"));
  row->addWidget(commentText_);
  addComment_ = smallButton(tr("Comment"), tr("Keep text and drawing as a comment at this moment (Enter)"), "reviewAddComment");
  row->addWidget(addComment_);
  connect(commentText_, &QLineEdit::returnPressed, this, &ReviewStage::writeComment);
  connect(commentText_, &QLineEdit::textEdited, this, [this] {
    playback_.pause();
    showTools();
  });
  connect(addComment_, &QPushButton::clicked, this, &ReviewStage::writeComment);
  return drawing_;
}

bool ReviewStage::isCommentBegun() const {
  return comments_.history() != nullptr && (!commentText_->text().trimmed().isEmpty() || !reviewed_->drawn().empty());
}

/// @return false: what was begun could not become a comment, and is still there
bool ReviewStage::writeComment() {
  if (!isCommentBegun()) return true;
  if (comments_.add(commentText_->text().trimmed(), reviewed_->drawn()).empty()) {
    if (session_.reviewer().name().isEmpty())
      session_.host().window().warn(
          tr("Say who you are at the top of the column: a comment is kept under the name of whoever wrote it.").toStdString(),
          "review reviewer");
    return false;
  }
  commentText_->clear();
  reviewed_->setDrawn({});
  chooseTool(std::nullopt);
  return true;
}

void ReviewStage::chooseTool(std::optional<CommentStroke::Kind> tool) {
  for (std::size_t n = 0; n < tools_.size(); ++n) tools_[n]->setChecked(tool && static_cast<std::size_t>(*tool) == n);
  if (tool) playback_.pause();
  reviewed_->setTool(tool);
}

void ReviewStage::showTools() {
  // Without an attempt there is nowhere to keep what is said: the row is not there.
  drawing_->setVisible(comments_.history() != nullptr && scans_.opened(kReviewed) != nullptr);
  dropDrawing_->setVisible(!reviewed_->drawn().empty());
}

void ReviewStage::showIcons() {
  for (const auto& [button, name] : icons_) {
    const bool isPlaying = button == play_ && playback_.clock().isPlaying();
    button->setIcon(icon(isPlaying ? QStringLiteral("pause") : name));
  }
}

void ReviewStage::showClock() {
  showing_ = true;
  const ReviewClock& clock = playback_.clock();
  time_->setText(QStringLiteral("%1 / %2").arg(clockText(clock.at_s()), clockText(clock.last_s())));
  if (play_->property("playing").toBool() != clock.isPlaying()) {
    play_->setProperty("playing", clock.isPlaying());
    showIcons();
  }
  speed_->setCurrentIndex(speed_->findData(clock.speed()));
  atEnd_->setChecked(clock.atEnd() == AtEnd::beginAnew);
  const bool areTwo = scans_.opened(kReviewed) != nullptr && scans_.opened(kCompared) != nullptr;
  const bool isAligned = playback_.times().isAligned();
  for (QWidget* each : std::initializer_list<QWidget*>{oneClock_, aligned_}) each->setVisible(areTwo);
  oneClock_->setChecked(!isAligned && !playback_.isAligning());
  aligned_->setChecked(isAligned || playback_.isAligning());
  offset_->setVisible(areTwo && !isAligned);
  if (offset_->value() != playback_.times().offset_s() && !offset_->hasFocus()) offset_->setValue(playback_.times().offset_s());
  showing_ = false;
}

}  // namespace ew::review
