#include "guide_panel.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include "ew/sdk/window.h"
#include "ew/widgets/fields.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"

namespace guided_sweep {

GuidePanel::GuidePanel(ew::sdk::Host& host, Guide& guide, QWidget* parent) : QWidget(parent), host_(host), guide_(guide) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(2 * ew::kGrid_px, 2 * ew::kGrid_px, 2 * ew::kGrid_px, 2 * ew::kGrid_px);
  rows->setSpacing(ew::kGrid_px);
  rows->addWidget(ew::quietLabel(tr("Hold the probe where the sweep begins, and keep the pose; then where it ends.")));
  const auto button = [&](const char* name, const QString& text, const QString& tip) {
    auto* made = new QPushButton(text);
    made->setObjectName(QLatin1String(name));
    made->setToolTip(tip);
    return made;
  };
  auto* start = button("guideStart", tr("Start here"), tr("The sweep begins where the probe is now"));
  auto* end = button("guideEnd", tr("End here"), tr("The sweep ends where the probe is now"));
  auto* poses = new QHBoxLayout;
  poses->setSpacing(ew::kGrid_px);
  poses->addWidget(start);
  poses->addWidget(end);
  rows->addLayout(poses);
  duration_ = new ew::NumberField(1.0, 60.0, 1, QStringLiteral("s"));
  duration_->setObjectName(QStringLiteral("guideDuration"));
  auto* form = new QFormLayout;
  form->setSpacing(ew::kGrid_px);
  form->addRow(ew::quietLabel(tr("Duration")), duration_);
  rows->addLayout(form);
  run_ = button("guideRun", {}, tr("The probe moves along the sweep by itself, and is yours again at its end"));
  ew::setLook(run_, ew::Look::primary);
  rows->addWidget(run_);
  state_ = ew::quietLabel({});
  state_->setObjectName(QStringLiteral("guideState"));
  rows->addWidget(state_);
  rows->addStretch(1);

  connect(start, &QPushButton::clicked, this, [this] { tell(guide_.takeStart(tr("Start of the sweep").toStdString())); });
  connect(end, &QPushButton::clicked, this, [this] { tell(guide_.takeEnd(tr("End of the sweep").toStdString())); });
  connect(duration_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
          [this](double seconds) { tell(guide_.setDuration(seconds, tr("Duration of the sweep").toStdString())); });
  connect(run_, &QPushButton::clicked, this, [this] { guide_.isRunning() ? guide_.giveBack() : guide_.run(); });
  guide_.onChanged = [this] { show_(); };
  show_();
}

GuidePanel::~GuidePanel() { guide_.onChanged = {}; }

void GuidePanel::show_() {
  const SweepPlan& plan = guide_.plan();
  const QSignalBlocker quiet(duration_);
  duration_->setValue(plan.duration_s);
  duration_->setEnabled(plan.isWhole());
  run_->setEnabled(plan.isWhole());
  run_->setText(guide_.isRunning() ? tr("Give the probe back") : tr("Show the sweep"));
  state_->setText(!plan.start ? tr("The sweep has no start yet.")
                  : !plan.end
                      ? tr("The sweep has no end yet.")
                      : tr("%1 mm in %2 s").arg(QLocale().toString(length_mm(plan), 'f', 0), QLocale().toString(plan.duration_s, 'f', 1)));
}

void GuidePanel::tell(const ew::Result<void>& done) {
  if (!done) host_.window().error(ew::words(done.error()).toStdString(), "guided sweep");
}

}  // namespace guided_sweep
