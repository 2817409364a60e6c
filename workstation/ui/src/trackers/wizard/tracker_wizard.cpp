#include "trackers/wizard/tracker_wizard.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "trackers/control/tracker_control.h"
#include "trackers/wizard/tracker_align_step.h"
#include "trackers/wizard/tracker_camera_steps.h"
#include "trackers/wizard/tracker_check_step.h"
#include "trackers/wizard/tracker_face_step.h"
#include "trackers/wizard/tracker_print_step.h"

namespace ew::ui {
namespace {

constexpr int kWizardPoll_ms = 50;
constexpr QSize kWizard_px(940, 640);

}  // namespace

TrackerWizard::TrackerWizard(Trackers& trackers, std::string tracker, TrackerCourse course, QWidget* parent)
    : QDialog(parent), trackers_(trackers), tracker_(std::move(tracker)) {
  setObjectName(QStringLiteral("trackerWizard"));
  setAttribute(Qt::WA_DeleteOnClose);
  setWindowTitle(course == TrackerCourse::camera ? tr("Set up a camera as tracker") : tr("Align the tracker with the mannequin"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(24, 24, 24, 24);
  rows->setSpacing(16);
  auto* middle = new QHBoxLayout;
  middle->setSpacing(24);
  pages_ = new QStackedWidget;
  addSteps(course);
  auto* column = new QWidget;
  addColumn(*column);
  middle->addWidget(column);
  auto* area = new QScrollArea;
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  area->setFocusPolicy(Qt::NoFocus);
  area->setWidget(pages_);
  pages_->setAutoFillBackground(false);
  area->viewport()->setAutoFillBackground(false);
  middle->addWidget(area, 1);
  rows->addLayout(middle, 1);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  auto* later = new QPushButton(tr("Go on later"));
  later->setObjectName(QStringLiteral("trackerLater"));
  later->setToolTip(tr("Closes this; what was done is kept, and it begins here the next time (Escape)"));
  back_ = new QPushButton(tr("Back"));
  back_->setObjectName(QStringLiteral("trackerBack"));
  next_ = new QPushButton;
  next_->setObjectName(QStringLiteral("trackerNext"));
  setLook(next_, Look::primary);
  next_->setDefault(true);
  for (QPushButton* each : {later, back_}) each->setAutoDefault(false);
  buttons->addWidget(later);
  buttons->addStretch(1);
  buttons->addWidget(back_);
  buttons->addWidget(next_);
  rows->addLayout(buttons);
  connect(later, &QPushButton::clicked, this, &QDialog::reject);
  connect(back_, &QPushButton::clicked, this, [this] { showStep(neighbour(-1)); });
  connect(next_, &QPushButton::clicked, this, &TrackerWizard::goOn);
  connect(&poll_, &QTimer::timeout, this, [this] { current().poll(); });
  poll_.start(kWizardPoll_ms);
  next_->setFocus();
  const auto undone =
      std::find_if(steps_.begin(), steps_.end(), [](const TrackerStep* each) { return each->isNeeded() && !each->isDone(); });
  showStep(undone == steps_.end() ? stepCount() - 1 : static_cast<int>(undone - steps_.begin()));
}

TrackerWizard::~TrackerWizard() { current().leave(); }

void TrackerWizard::addSteps(TrackerCourse course) {
  if (course == TrackerCourse::camera) {
    steps_.push_back(new TrackerPrintStep(trackers_, tracker_));
    steps_.push_back(new TrackerCameraStep(trackers_, tracker_));
    steps_.push_back(new TrackerLensStep(trackers_, tracker_));
    steps_.push_back(new TrackerHoldStep(trackers_, tracker_));
  }
  if (course != TrackerCourse::align) steps_.push_back(new TrackerFaceStep(trackers_, tracker_));
  steps_.push_back(new TrackerAlignStep(trackers_, tracker_));
  steps_.push_back(new TrackerCheckStep(trackers_, tracker_));
  for (TrackerStep* each : steps_) {
    pages_->addWidget(each);
    connect(each, &TrackerStep::changed, this, &TrackerWizard::refresh);
  }
}

/// The steps by their names; what was done can be gone back to.
void TrackerWizard::addColumn(QWidget& column) {
  auto* rows = new QVBoxLayout(&column);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  for (int n = 0; n < stepCount(); ++n) {
    auto* name = new QPushButton;
    name->setObjectName(QStringLiteral("trackerStep%1").arg(n + 1));
    setLook(name, Look::flat);
    name->setCheckable(true);
    name->setAutoDefault(false);
    name->setFocusPolicy(Qt::ClickFocus);  // Back and Next do the same from the keyboard
    name->setStyleSheet(QStringLiteral("text-align: left; padding: 6px 8px;"));
    connect(name, &QPushButton::clicked, this, [this, n] { showStep(n); });
    names_.push_back(name);
    rows->addWidget(name);
  }
  rows->addStretch(1);
}

int TrackerWizard::step() const { return pages_->currentIndex(); }
TrackerStep& TrackerWizard::current() const { return *steps_[static_cast<std::size_t>(std::max(0, step()))]; }

void TrackerWizard::showStep(int wanted) {
  const int to = std::clamp(wanted, 0, stepCount() - 1);
  const bool isShown = to == step() && current().property("entered").toBool();
  if (!isShown) {
    current().leave();
    current().setProperty("entered", false);
    pages_->setCurrentIndex(to);
    current().setProperty("entered", true);
    current().enter();
  }
  refresh();
}

/// The nearest step in that direction that is needed; beyond the ends where there is none.
int TrackerWizard::neighbour(int by) const {
  int to = step() + by;
  while (to >= 0 && to < stepCount() && !steps_[static_cast<std::size_t>(to)]->isNeeded()) to += by;
  return to;
}

void TrackerWizard::goOn() {
  const int next = neighbour(1);
  if (next < stepCount()) return showStep(next);
  accept();
}

void TrackerWizard::refresh() {
  int number = 0;
  for (int n = 0; n < stepCount(); ++n) {
    QPushButton& name = *names_[static_cast<std::size_t>(n)];
    const TrackerStep& each = *steps_[static_cast<std::size_t>(n)];
    name.setVisible(each.isNeeded());
    if (!each.isNeeded()) continue;
    ++number;
    name.setText((each.isDone() ? QStringLiteral("✓") : QString::number(number)) + QStringLiteral("  ") + each.title());
    name.setAccessibleName(each.isDone() ? tr("Step %1, done: %2").arg(number).arg(each.title())
                                         : tr("Step %1: %2").arg(number).arg(each.title()));
    name.setChecked(n == step());
  }
  back_->setEnabled(neighbour(-1) >= 0);
  const bool isLast = neighbour(1) >= stepCount();
  next_->setText(isLast ? tr("Finish") : current().isDone() || !current().mayGoOn() ? tr("Next") : tr("Skip"));
  next_->setEnabled(current().mayGoOn());
}

void TrackerWizard::showEvent(QShowEvent* event) {
  const QSize room = screen()->availableSize() - QSize(32, 64);
  resize(QSize(scaled(kWizard_px.width()), scaled(kWizard_px.height())).boundedTo(room));
  QDialog::showEvent(event);
}

}  // namespace ew::ui
