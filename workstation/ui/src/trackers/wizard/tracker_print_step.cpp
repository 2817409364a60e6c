#include "trackers/wizard/tracker_print_step.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSettings>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>

#include "ew/widgets/save_file.h"
#include "ew/widgets/words.h"
#include "trackers/control/tracker_control.h"
#include "trackers/control/tracker_drawing.h"

namespace ew::ui {
namespace {

const auto kReady = QStringLiteral("tracker/paperIsReady");
constexpr double kLeastScale_mm = 90.0;
constexpr double kMostScale_mm = 110.0;

bool usesLetter() { return QLocale().measurementSystem() == QLocale::ImperialUSSystem; }

}  // namespace

QString saveTrackerSheet(Trackers& trackers, const std::string& body, bool isLetter, QWidget* parent, bool* isProblem) {
  *isProblem = false;
  const QString file = askSaveFile(parent, {TrackerPrintStep::tr("Save the sheet to print"),
                                            TrackerPrintStep::tr("markers.pdf"),
                                            TrackerPrintStep::tr("PDF (*.pdf)"),
                                            {QStringLiteral(".pdf")}});
  if (file.isEmpty()) return {};
  const Result<void> written = trackers.papers().writeSheet(pathOf(file), body, isLetter);
  *isProblem = !written;
  return written ? TrackerPrintStep::tr("Saved as %1. Print it at 100 %, without 'fit to page'.").arg(file) : words(written.error());
}

TrackerPrintStep::TrackerPrintStep(Trackers& trackers, std::string tracker, QWidget* parent)
    : TrackerStep(
          tr("Print and fold"),
          tr("Print the sheets on thick paper at 100 % ('actual size'), cut along the full lines, fold along the dashed ones and glue "
             "the tabs. The flat board goes beside the mannequin, the chess board on something stiff."),
          parent),
      trackers_(trackers),
      tracker_(std::move(tracker)) {
  rows().addWidget(
      new TrackerDrawing(QStringLiteral("tracker-step-print"),
                         tr("A sheet is cut and folded to a box with a nose; a camera looks at the box in the hand and at a board "
                            "that lies on the mannequin.")),
      1);
  auto* form = new QFormLayout;
  form->setHorizontalSpacing(16);
  form->setRowWrapPolicy(QFormLayout::WrapLongRows);
  bodies_ = new QComboBox;
  bodies_->setObjectName(QStringLiteral("trackerBodies"));
  bodies_->setAccessibleName(tr("Paper body"));
  form->addRow(tr("Paper body"), bodies_);
  auto* line = new QHBoxLayout;
  line->setSpacing(8);
  papers_ = new QComboBox;
  papers_->setObjectName(QStringLiteral("trackerPaper"));
  papers_->setAccessibleName(tr("Paper"));
  papers_->addItem(tr("A4"));
  papers_->addItem(tr("Letter"));
  papers_->setCurrentIndex(usesLetter() ? 1 : 0);
  auto* save = new QPushButton(tr("Save the sheets as PDF…"));
  save->setObjectName(QStringLiteral("trackerSaveSheet"));
  save->setAutoDefault(false);
  line->addWidget(papers_);
  line->addWidget(save);
  line->addStretch(1);
  form->addRow(tr("Paper"), line);
  scale_ = new QDoubleSpinBox;
  scale_->setObjectName(QStringLiteral("trackerScale"));
  scale_->setAccessibleName(tr("The line of 100 mm measures"));
  scale_->setRange(kLeastScale_mm, kMostScale_mm);
  scale_->setDecimals(1);
  scale_->setSingleStep(0.1);
  scale_->setSuffix(tr(" mm"));
  scale_->setToolTip(tr("Lay a ruler on the printed scale: printers often shrink a little, and the program takes it into account"));
  form->addRow(tr("The line of 100 mm measures"), scale_);
  rows().addLayout(form);
  ready_ = new QCheckBox(tr("Paper body and boards are ready"));
  ready_->setObjectName(QStringLiteral("trackerPaperReady"));
  ready_->setChecked(QSettings().value(kReady, false).toBool());
  rows().addWidget(ready_);
  answer_ = addSentence("trackerSheetAnswer");
  connect(save, &QPushButton::clicked, this, &TrackerPrintStep::save);
  connect(bodies_, qOverload<int>(&QComboBox::activated), this, &TrackerPrintStep::chooseBody);
  connect(scale_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double mm) { trackers_.setMeasuredScale(mm); });
  connect(ready_, &QCheckBox::toggled, this, [this](bool ready) {
    QSettings().setValue(kReady, ready);
    Q_EMIT changed();
  });
}

bool TrackerPrintStep::isDone() const { return ready_->isChecked(); }

void TrackerPrintStep::enter() {
  bodies_->clear();
  for (const PaperBody& each : trackers_.papers().all())
    if (each.kind == PaperKind::held) bodies_->addItem(words(each.name), QString::fromStdString(each.id));
  const QString chosen = QString::fromStdString(trackers_.bodyOf(tracker_));
  bodies_->setCurrentIndex(std::max(0, bodies_->findData(chosen)));
  if (bodies_->count() == 0)
    say(*answer_, words(trackers_.papers().problem()), Tone::bad);
  else if (bodies_->findData(chosen) < 0)
    chooseBody();
  const QSignalBlocker quietly(scale_);
  scale_->setValue(trackers_.papers().measuredScale_mm());
}

void TrackerPrintStep::chooseBody() { trackers_.chooseBody(tracker_, bodies_->currentData().toString().toStdString()); }

void TrackerPrintStep::save() {
  bool isProblem = false;
  const QString answer =
      saveTrackerSheet(trackers_, bodies_->currentData().toString().toStdString(), papers_->currentIndex() == 1, this, &isProblem);
  if (!answer.isEmpty()) say(*answer_, answer, isProblem ? Tone::bad : Tone::good);
}

}  // namespace ew::ui
