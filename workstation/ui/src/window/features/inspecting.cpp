#include "window/features/inspecting.h"

#include <QMenu>
#include <QPoint>
#include <algorithm>

#include "ew/library/voxel_source.h"
#include "scan/cost/cost_panel.h"
#include "scan/source/source_dialog.h"
#include "window/frame/commands.h"
#include "window/frame/window_parts.h"
#include "window/frame/workspaces.h"

namespace ew::ui {

Inspecting::~Inspecting() {
  delete cost_;
  delete dialog_;
}

void Inspecting::addSourceAction(QMenu& scan) {
  source_ = parts_.commands->add(scan, "source", [this] {
    if (parts_.workspaces->isAtWork()) {
      parts_.sourcePicker->setPicking(!parts_.sourcePicker->isPicking());
    } else {
      source_->setChecked(false);
    }
  });
  source_->setCheckable(true);
}

void Inspecting::addCostAction(QMenu& scan) {
  parts_.commands->add(scan, "cost", [this] { showCost(); });
}

void Inspecting::connectParts() {
  WindowParts& p = parts_;
  connect(p.console, &ConsolePanel::costAsked, this, &Inspecting::showCost);
  connect(p.sourcePicker, &SourcePicker::asked, this, &Inspecting::showSource);
  connect(p.sourcePicker, &PickLayer::pickingChanged, source_, &QAction::setChecked);
}

void Inspecting::refresh() {
  const auto& subject = parts_.session.subject();
  const bool knowsSource = subject && subject->provenance;
  source_->setEnabled(knowsSource);
  source_->setToolTip(knowsSource ? tr("Click a point to see the recorded frame it came from")
                                  : tr("Only a volume made here from a recorded sweep knows which frame a point came from"));
}

void Inspecting::showCost() {
  CostPanel* panel = cost_.data();
  if (panel == nullptr) {
    panel = new CostPanel(parts_.session, parts_.jobs, &parts_.window);
    panel->setAttribute(Qt::WA_DeleteOnClose);
    cost_ = panel;
  }
  panel->show();
  panel->raise();
  panel->activateWindow();
  if (!panel->measured()) panel->measure();
}

void Inspecting::showSource(const QPoint& pixel) {
  WindowParts& p = parts_;
  const auto& subject = p.session.subject();
  if (!subject || p.session.image().isEmpty()) return;
  SourceDialog* dialog = dialog_.data();
  if (dialog == nullptr) {
    dialog = new SourceDialog(p.jobs, &p.window);
    dialog_ = dialog;
    connect(dialog, &QDialog::finished, this, [this] {
      parts_.sourcePicker->clearMark();
      parts_.sourcePicker->setPicking(false);
    });
    // Beside the scan, over the 3D view, where there is room for it.
    const QPoint corner = p.scanView->mapToGlobal(QPoint(0, 0));
    dialog->move(std::max(p.window.mapToGlobal(QPoint(8, 0)).x(), corner.x() - dialog->width() - 8), corner.y() + 8);
  }
  if (p.session.wide() != nullptr) {
    dialog->showNone(
        tr("A place in a wide image was seen by many images. Close it (%1), then click a point of one image.").arg(p.keys.words("wide")));
    dialog->show();
    return;
  }
  const Spans& fan = p.session.seen().spans();
  const auto row = static_cast<std::size_t>(pixel.y());
  const bool isInFan = pixel.y() >= 0 && row < fan.size() && std::any_of(fan[row].begin(), fan[row].end(), [&](const RowSpan& run) {
                         return run.begin <= pixel.x() && pixel.x() < run.end;
                       });
  if (p.session.imageKnobs().mode == DisplayMode::mMode) {
    dialog->showNone(
        tr("The strip of the M-mode shows one beam over time, no place in an image. Switch to B or B + M, then click a point of the "
           "image."));
  } else if (!isInFan) {
    dialog->showNone(tr("This point lies outside the image. Click a point inside the fan."));
  } else if (subject->provenance) {
    const Point<frame::World> at_world =
        pointShownAt(p.session.geometry(), p.session.imagePose(), {static_cast<double>(pixel.x()), static_cast<double>(pixel.y())});
    dialog->showSource(subject->provenance, voxelSourceAt(*subject->provenance, *subject->voxels.volume(), subject->placedGrid, at_world));
  } else {
    dialog->showNone(
        tr("This volume does not say which frame a voxel came from. A volume that is made here from a recorded sweep does: open "
           "the sweep (%1), leave 'Record source frame per voxel' switched on, and reconstruct it.")
            .arg(p.keys.words("open")));
  }
  dialog->show();
  dialog->raise();
  dialog->activateWindow();
}

}  // namespace ew::ui
