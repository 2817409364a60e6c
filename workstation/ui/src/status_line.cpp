#include "status_line.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVariant>
#include <cmath>

#include "figures.h"
#include "theme.h"

namespace ew::ui {

QString nameOfStep(StepKind kind) {
  switch (kind) {
    case StepKind::sampleWeave:
      return StatusLine::tr("sample weave");
    case StepKind::sampleLinear:
      return StatusLine::tr("sample linear");
    case StepKind::zoomStretch:
      return StatusLine::tr("stretch");
    case StepKind::table:
      return StatusLine::tr("table");
    case StepKind::sampleCubic:
      return StatusLine::tr("cubic");
    case StepKind::elevationPlanes:
      return StatusLine::tr("slice thickness");
    case StepKind::labels:
      return StatusLine::tr("tissues");
    case StepKind::contact:
      return StatusLine::tr("contact");
    case StepKind::attenuation:
      return StatusLine::tr("shadow");
    case StepKind::reverberation:
      return StatusLine::tr("reverberation");
    case StepKind::focusStretch:
      return StatusLine::tr("focus");
    case StepKind::focusKernel:
      return StatusLine::tr("focus");
    case StepKind::noise:
      return StatusLine::tr("noise");
    case StepKind::scanConversion:
      return StatusLine::tr("scan conversion");
    case StepKind::edges:
      return StatusLine::tr("edges");
    case StepKind::persistence:
      return StatusLine::tr("persistence");
    case StepKind::mMode:
      return StatusLine::tr("M-mode");
  }
  return {};
}

StatusLine::StatusLine(Session& session, QWidget* parent) : QWidget(parent), session_(session) {
  setObjectName(QStringLiteral("statusLine"));
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(40);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 0, 16, 0);
  row->setSpacing(32);
  position_ = new FigureLabel(QStringLiteral("x -888.8  y -888.8  z -888.8 mm"));
  depth_ = new FigureLabel(tr("depth %1 mm").arg(888));
  plan_ = new FigureLabel;
  contact_ = new FigureLabel(tr("contact %1 %").arg(888));
  edit_ = new QLabel;
  position_->setObjectName(QStringLiteral("position"));
  depth_->setObjectName(QStringLiteral("statusDepth"));
  plan_->setObjectName(QStringLiteral("plan"));
  contact_->setObjectName(QStringLiteral("contact"));
  edit_->setObjectName(QStringLiteral("lastEdit"));
  position_->setToolTip(tr("Middle of the transducer's face: left, back, up from the mannequin's origin"));
  plan_->setToolTip(tr("What the picture runs and how long each step takes (median of the last frames)"));
  contact_->setToolTip(tr("How much of the transducer's face touches the skin"));
  for (QLabel* label : {static_cast<QLabel*>(position_), static_cast<QLabel*>(depth_), static_cast<QLabel*>(plan_),
                        static_cast<QLabel*>(contact_), edit_}) {
    label->setProperty("small", true);
    label->setProperty("quiet", true);
    label->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  }
  contact_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(position_);
  row->addWidget(depth_);
  row->addWidget(plan_, 1);
  row->addWidget(edit_);
  row->addWidget(contact_);

  // Figures that change with every frame cannot be read, and contact asks the skin: four times a second is enough.
  soon_.setSingleShot(true);
  soon_.setInterval(250);
  connect(&soon_, &QTimer::timeout, this, &StatusLine::showPlan);
  connect(&session_, &Session::holdChanged, this, &StatusLine::showPose);
  connect(&session_, &Session::knobsChanged, this, &StatusLine::showPose);
  connect(&session_, &Session::subjectChanged, this, &StatusLine::showPose);
  connect(&session_, &Session::pictureChanged, this, [this] {
    if (!soon_.isActive()) soon_.start();
  });
  showPose();
  showPlan();
}

void StatusLine::setEdit(const QString& text) { edit_->setText(text); }

void StatusLine::showPose() {
  const glm::dvec3 at = session_.pose().probeToWorld.matrix[3];
  // A value that rounds to zero is shown as 0.0, never as -0.0.
  const auto figure = [](double value) { return QString::number(std::round(value * 10.0) / 10.0 + 0.0, 'f', 1).rightJustified(6); };
  position_->setText(session_.subject() ? QStringLiteral("x %1  y %2  z %3 mm").arg(figure(at.x), figure(at.y), figure(at.z)) : QString());
  depth_->setText(session_.subject() ? tr("depth %1 mm").arg(static_cast<int>(std::lround(session_.depth_mm()))) : QString());
  if (!soon_.isActive()) soon_.start();
}

void StatusLine::showPlan() {
  if (!session_.subject()) {
    plan_->setText({});
    contact_->setText({});
    return;
  }
  QStringList parts;
  double total_ms = 0.0;
  for (const StepTime& step : session_.stepTimes()) {
    total_ms += step.measured_us / 1000.0;
    parts << QStringLiteral("%1 %2").arg(nameOfStep(step.kind)).arg(step.measured_us / 1000.0, 0, 'f', 2);
  }
  if (parts.size() == 1) {
    plan_->setText(tr("plan: %1 ms").arg(parts.front()));
  } else {
    plan_->setText(parts.isEmpty() ? QString() : tr("plan: %1 = %2 ms").arg(parts.join(QStringLiteral(" | "))).arg(total_ms, 0, 'f', 2));
  }
  const auto contact = session_.contact();
  contact_->setText(contact ? tr("contact %1 %").arg(static_cast<int>(std::lround(*contact * 100.0))) : QString());
}

}  // namespace ew::ui
