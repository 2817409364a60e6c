#include "panel/give_volume_dialog.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QVBoxLayout>
#include <memory>

#include "ew/library/new_case.h"
#include "ew/sdk/window.h"
#include "ew/widgets/labels.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "logic/edits.h"
#include "panel/rights_form.h"
#include "panel/source_field.h"

namespace ew::case_authoring {

GiveVolumeDialog::GiveVolumeDialog(sdk::Host& host, QWidget* parent) : QDialog(parent), host_(host) {
  setObjectName(QStringLiteral("giveVolumeDialog"));
  const auto opened = host_.cases().current();
  const bool hasOne = opened && !hasNoVolume(*opened);
  setWindowTitle(hasOne ? tr("Another volume for the case") : tr("Give the case a volume"));
  setMinimumWidth(72 * kGrid_px);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3 * kGrid_px, 3 * kGrid_px, 3 * kGrid_px, 3 * kGrid_px);
  column->setSpacing(2 * kGrid_px);
  if (hasOne)
    column->addWidget(quietLabel(
        tr("The volume keeps its place in the body. Targets and measurements that only the present volume knows are left out; undo brings "
           "everything back.")));
  source_ = new SourceField(host_, false);
  column->addWidget(source_);
  rights_ = new RightsForm;
  column->addWidget(rights_);
  problem_ = problemLabel();
  problem_->setObjectName(QStringLiteral("giveVolumeProblem"));
  column->addWidget(problem_);
  column->addStretch(1);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(kGrid_px);
  buttons->addStretch(1);
  auto* cancel = new QPushButton(tr("Cancel"));
  cancel->setAutoDefault(false);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  buttons->addWidget(cancel);
  give_ = new QPushButton(hasOne ? tr("Replace the volume") : tr("Give the volume"));
  give_->setObjectName(QStringLiteral("giveVolumeNow"));
  setLook(give_, Look::primary);
  give_->setDefault(true);
  connect(give_, &QPushButton::clicked, this, &GiveVolumeDialog::give);
  buttons->addWidget(give_);
  column->addLayout(buttons);
  connect(source_, &SourceField::changed, this, &GiveVolumeDialog::look);
  look();
}

void GiveVolumeDialog::look() {
  const QString open = source_->openQuestion();
  give_->setEnabled(open.isEmpty());
  give_->setToolTip(open);
  setProblem(problem_, {});
}

void GiveVolumeDialog::give() {
  const auto source = source_->source();
  if (!source) return look();
  // Before anything is put into the folder, and before the job, for it may ask.
  if (const auto own = host_.cases().makeOwn(); !own) {
    if (own.error().code != ErrorCode::cancelled) setProblem(problem_, words(own.error()));
    return;
  }
  const auto opened = host_.cases().current();
  const auto folder = host_.cases().currentFolder();
  if (!opened) return;
  const RecordingRights rights = rights_->rights();
  auto given = std::make_shared<VolumeReplacement>();
  hide();
  host_.jobs().startSaving(
      tr("Putting the volume into the case").toStdString(),
      [given, opened = *opened, source = *source, rights](Progress& progress) -> Result<void> {
        auto made = giveVolume(opened, source, progress);
        if (!made) return passOn(made.error());
        *given = std::move(*made);
        if (rights != RecordingRights{}) given->edited = withRights(std::move(given->edited), rights);
        return {};
      },
      [this, alive = QPointer<GiveVolumeDialog>(this), &host = host_, given, folder](const Result<void>& outcome) {
        Result<void> done = outcome;
        if (outcome) {
          const auto now = host.cases().current();
          if (!now || host.cases().currentFolder() != folder) {
            // Another case is open by now: the volume lies in the folder, and nothing names it.
            done = failure(ErrorCode::badUsage,
                           say<"Another case was opened meanwhile; open the case again and give it the volume once more.">());
          } else {
            done = host.cases().edit(withVolumeGiven(*now, given->edited), tr("Give the case a volume").toStdString(), {});
          }
        }
        if (done) {
          for (const Message& note : given->notes) host.window().info(words(note).toStdString());
          if (given->lostTargets + given->lostMeasurements > 0)
            host.window().info(tr("Left out with the old volume: targets %1, measurements %2.")
                                   .arg(given->lostTargets)
                                   .arg(given->lostMeasurements)
                                   .toStdString());
          if (alive) deleteLater();
          return;
        }
        if (!alive) {
          if (done.error().code != ErrorCode::cancelled) host.window().error(words(done.error()).toStdString());
          return;
        }
        open();
        if (done.error().code != ErrorCode::cancelled) setProblem(problem_, words(done.error()));
      });
}

}  // namespace ew::case_authoring
