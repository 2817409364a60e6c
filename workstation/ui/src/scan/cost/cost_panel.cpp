#include "scan/cost/cost_panel.h"

#include <QButtonGroup>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <QVBoxLayout>
#include <QVariant>

#include "ew/widgets/look.h"
#include "ew/widgets/words.h"
#include "scan/cost/cost_chart.h"
#include "scan/status_line.h"

namespace ew::ui {

CostPanel::CostPanel(Session& session, Jobs& jobs, QWidget* parent) : QDialog(parent), session_(session), jobs_(jobs) {
  setObjectName(QStringLiteral("costPanel"));
  setWindowTitle(tr("Cost of accuracy"));
  resize(720, 520);
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(16, 16, 16, 16);
  rows->setSpacing(12);

  addCurves(rows);
  chart_ = new CostChart;
  rows->addWidget(chart_, 1);
  reference_ = new QLabel;
  reference_->setObjectName(QStringLiteral("costReference"));
  setLook(reference_, Look::quiet);
  setLook(reference_, Look::small);
  reference_->setWordWrap(true);
  rows->addWidget(reference_);

  layout_ = new QLabel;
  layout_->setObjectName(QStringLiteral("costLayout"));
  setLook(layout_, Look::quiet);
  setLook(layout_, Look::small);
  layout_->setWordWrap(true);
  layout_->setToolTip(
      tr("Timed on this machine when the first volume of about this size was opened: slices of 200 x 140 pixels of every quality in "
         "directions of six kinds, one thread"));
  rows->addWidget(layout_);

  addWishes(rows);
  addProgress(rows);
  connectParts();
  showAll();
}

void CostPanel::addCurves(QVBoxLayout* rows) {
  curves_ = new QWidget;
  auto* curves = new QHBoxLayout(curves_);
  curves->setContentsMargins(0, 0, 0, 0);
  curves->setSpacing(0);
  curve_ = new QButtonGroup(this);
  const std::pair<QString, QString> names[] = {{tr("Slicing"), QStringLiteral("costSlicing")},
                                               {tr("Slice thickness"), QStringLiteral("costPlanes")}};
  for (int i = 0; i < 2; ++i) {
    auto* button = new QPushButton(names[i].first);
    button->setObjectName(names[i].second);
    button->setCheckable(true);
    setLook(button, i == 0 ? Look::firstOf : Look::lastOf);
    curve_->addButton(button, i);
    curves->addWidget(button, 1);
  }
  curve_->button(0)->setChecked(true);
  rows->addWidget(curves_);
}

void CostPanel::addWishes(QVBoxLayout* rows) {
  auto* wishes = new QHBoxLayout;
  wishes->setSpacing(8);
  auto* wishName = new QLabel(tr("PSNR at least"));
  wish_ = new QDoubleSpinBox;
  wish_->setObjectName(QStringLiteral("costWish"));
  wish_->setRange(10.0, 90.0);
  wish_->setDecimals(0);
  wish_->setSuffix(tr(" dB"));
  wish_->setValue(QSettings().value(QStringLiteral("wishedPsnr_db"), 40.0).toDouble());
  wish_->setToolTip(tr("The accuracy that is wanted: peak signal to noise ratio against the reference"));
  wish_->setAccessibleName(tr("PSNR at least"));
  wishName->setBuddy(wish_);
  use_ = new QPushButton(tr("Use the fastest that meets it"));
  use_->setObjectName(QStringLiteral("costUse"));
  setLook(use_, Look::primary);
  use_->setToolTip(tr("Sets the console to the fastest setting at or above the dashed line (Enter)"));
  use_->setDefault(true);
  answer_ = new QLabel;
  answer_->setObjectName(QStringLiteral("costAnswer"));
  answer_->setWordWrap(true);
  wishes->addWidget(wishName);
  wishes->addWidget(wish_);
  wishes->addWidget(use_);
  wishes->addWidget(answer_, 1);
  rows->addLayout(wishes);
}

void CostPanel::addProgress(QVBoxLayout* rows) {
  progress_ = new QProgressBar;
  progress_->setTextVisible(false);
  progress_->setRange(0, 1000);
  QSizePolicy keepsPlace = progress_->sizePolicy();
  keepsPlace.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(keepsPlace);
  rows->addWidget(progress_);
  auto* last = new QHBoxLayout;
  last->setSpacing(8);
  state_ = new QLabel;
  state_->setObjectName(QStringLiteral("costState"));
  setLook(state_, Look::quiet);
  setLook(state_, Look::small);
  state_->setWordWrap(true);
  again_ = new QPushButton;
  again_->setObjectName(QStringLiteral("costMeasure"));
  again_->setAutoDefault(false);
  auto* close = new QPushButton(tr("Close"));
  close->setObjectName(QStringLiteral("costClose"));
  close->setToolTip(tr("Close (Escape)"));
  close->setAutoDefault(false);
  last->addWidget(state_, 1);
  last->addWidget(again_);
  last->addWidget(close);
  rows->addLayout(last);
  connect(close, &QPushButton::clicked, this, &QDialog::reject);
}

void CostPanel::connectParts() {
  poll_ = new QTimer(this);
  poll_->setInterval(80);
  connect(poll_, &QTimer::timeout, this, [this] {
    for (const Jobs::Seen& seen : jobs_.seen()) {
      if (seen.id == job_) progress_->setValue(static_cast<int>(seen.fraction * 1000.0));
    }
  });
  connect(curve_, &QButtonGroup::idClicked, this, &CostPanel::showAll);
  connect(wish_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double db) {
    QSettings().setValue(QStringLiteral("wishedPsnr_db"), db);
    answer_->clear();
    showAll();
  });
  connect(use_, &QPushButton::clicked, this, &CostPanel::useFastest);
  connect(again_, &QPushButton::clicked, this, [this] {
    if (isMeasuring()) {
      cancel();
    } else {
      measure();
    }
  });
  connect(this, &QDialog::finished, this, &CostPanel::cancel);
  connect(&session_.console(), &ScanConsole::knobsChanged, this, &CostPanel::showAll);
  connect(&session_.console(), &ScanConsole::sceneChanged, this, [this] {
    // Slices and live echoes have figures of their own.
    if (measured_ && measured_->ofEchoes != showsEchoes()) {
      cancel();
      measured_.reset();
    }
    showAll();
  });
  connect(&session_, &Session::subjectChanged, this, [this] {
    // Figures of another volume would be read as this one's.
    cancel();
    measured_.reset();
    showAll();
  });
}

CostPanel::~CostPanel() { cancel(); }

void CostPanel::cancel() {
  if (job_ != 0) jobs_.cancel(job_);
}

void CostPanel::measure() {
  if (isMeasuring() || !session_.subject() || session_.image().isEmpty()) return;
  problem_.clear();
  answer_->clear();
  auto result = std::make_shared<CostOfAccuracy>();
  const ScanSubject& subject = *session_.subject();
  const DisplayImage& image = session_.image();
  about_ = tr("%1, %2 x %3 pixels, %4")
               .arg(nameOfProbe(session_.console().probe().name))
               .arg(image.width())
               .arg(image.height())
               .arg(words(subject.title));
  const QPointer<CostPanel> panel(this);
  job_ = jobs_.start(
      tr("Measuring the cost of accuracy"),
      [result, subject, probe = session_.console().probe(), knobs = session_.console().knobs(),
       scene = subject.known(session_.console().scene()), pose = session_.probeControl().pose(), width = image.width(),
       height = image.height()](Progress& progress) -> Result<void> {
        CostOptions options;
        options.threads = 0;  // as the window makes its own frames
        FrameInput seen;
        const ScanVoxels voxels = formsEchoes(scene) ? subject.voxels : subject.voxels.withBricks();
        seen.echo = voxels.source(subject.placedGrid, 0.0);
        if (subject.labels) seen.labels = VolumeView<const std::uint8_t>{subject.labels->echo.data(), subject.placedLabels};
        seen.tissue = subject.tissue.get();
        seen.tissueGrid = subject.placedTissue;
        auto measured = formsEchoes(scene) ? measureCostOfEchoes(seen, probe, knobs, scene, pose, width, height, options, progress)
                                           : measureCostOfAccuracy(seen.echo, probe, knobs, scene, pose, width, height, options, progress);
        if (!measured) return passOn(measured.error());
        *result = std::move(*measured);
        return {};
      },
      [panel, result](const Result<void>& outcome) {
        if (CostPanel* shown = panel.data(); shown != nullptr) shown->take(outcome, *result);
      });
  showAll();
}

void CostPanel::take(const Result<void>& outcome, const CostOfAccuracy& result) {
  job_ = 0;
  if (outcome) {
    measured_ = result;
  } else if (outcome.error().code != ErrorCode::cancelled) {
    problem_ = words(outcome.error().message);
  } else {
    problem_ = tr("Cancelled.");
  }
  showAll();
}

bool CostPanel::showsEchoes() const { return session_.subject() && formsEchoes(session_.subject()->known(session_.console().scene())); }

bool CostPanel::showsPlanes() const { return measured_ && !measured_->planes.empty() && curve_->checkedId() == 1; }

const std::vector<CostPoint>& CostPanel::shownPoints() const {
  static const std::vector<CostPoint> none;
  if (!measured_) return none;
  return showsPlanes() ? measured_->planes : measured_->qualities;
}

bool CostPanel::isInUse(const CostPoint& point) const {
  const Knobs& knobs = session_.console().knobs();
  return showsPlanes() ? point.knobs.elevationPlanes == knobs.elevationPlanes : point.knobs.quality == knobs.quality;
}

void CostPanel::useFastest() {
  const CostPoint* best = fastestWithin(shownPoints(), wish_->value());
  if (best == nullptr) {
    answer_->setText(tr("No setting reaches it."));
    return;
  }
  Knobs knobs = session_.console().knobs();
  QString name;
  if (showsPlanes()) {
    knobs.elevationPlanes = best->knobs.elevationPlanes;
    name = tr("%n planes", nullptr, knobs.elevationPlanes);
  } else {
    knobs.quality = best->knobs.quality;
    name = nameOfQuality(knobs.quality);
  }
  session_.console().setKnobs(knobs);
  answer_->setText(tr("In use: %1.").arg(name));
}

/// Which layouts of the voxels are in use, and what they were chosen by; nothing where nobody asked.
void CostPanel::showLayout() {
  const auto& subject = session_.subject();
  const auto times = subject && !showsEchoes() ? subject->voxels.layoutTimes() : std::nullopt;
  layout_->setVisible(times.has_value());
  if (!times) return;
  const auto ms = [](double time_us) { return QLocale().toString(1e-3 * time_us, 'f', 2); };
  const LayoutPair mean = times->mean();
  const QString rows_ms = ms(mean.rows_us), bricks_ms = ms(mean.bricks_us);
  if (!subject->voxels.readsBricks())
    layout_->setText(tr("Voxels are read as they lie: a slice takes %1 ms, in bricks %2 ms.").arg(rows_ms, bricks_ms));
  else if (times->choice().all())
    layout_->setText(tr("Voxels are read in bricks: a slice takes %1 ms, as they lie %2 ms.").arg(bricks_ms, rows_ms));
  else
    layout_->setText(tr("Voxels are read in bricks or as they lie, whichever is faster in the slice's direction: a slice takes %1 ms, in "
                        "bricks alone %2 ms, as they lie alone %3 ms.")
                         .arg(ms(times->chosen_us()), bricks_ms, rows_ms));
}

void CostPanel::showAll() {
  curves_->setVisible(measured_ && !measured_->planes.empty());
  std::vector<CostChart::Point> points;
  for (const CostPoint& point : shownPoints()) {
    points.push_back({showsPlanes() ? tr("%n planes", nullptr, point.knobs.elevationPlanes) : nameOfQuality(point.knobs.quality),
                      point.frame_ms, point.psnr_db, point.rms_grey, isInUse(point), point.psnr_db >= wish_->value()});
  }
  const QString empty = !session_.subject()  ? tr("Open a case or a volume first; then its own slices are measured.")
                        : isMeasuring()      ? tr("Measuring on this machine, with the open volume …")
                        : problem_.isEmpty() ? tr("Measure what each quality costs on this machine, with the open volume.")
                                             : problem_;
  chart_->show(std::move(points), wish_->value(), empty);
  if (!measured_) {
    reference_->clear();
  } else if (measured_->ofEchoes) {
    reference_->setText(tr("Error of whole frames against the same scatterers formed as finely as possible (%1 samples along a pulse, a "
                           "slice of %2 standard "
                           "deviations), %3 pixels in %4 poses around the present one.")
                            .arg(kFinestSamplesPerPulse)
                            .arg(kFinestReach)
                            .arg(measured_->comparedPixels)
                            .arg(measured_->poses));
  } else if (showsPlanes()) {
    reference_->setText(
        tr("Error of whole frames against those with 9 planes, %n poses around the present one.", nullptr, measured_->poses));
  } else {
    reference_->setText(
        tr("Error of the slice against a windowed sinc (Lanczos, 10 x 10 x 10 voxels) in double precision of the same voxels, "
           "%1 pixels in %2 poses around the present one. Times are medians of whole frames with the scene's effects.")
            .arg(measured_->comparedPixels)
            .arg(measured_->poses));
  }
  showLayout();
  use_->setEnabled(measured_.has_value() && !isMeasuring());
  progress_->setVisible(isMeasuring());
  if (!isMeasuring()) progress_->setValue(0);
  state_->setText(measured_ || isMeasuring() ? about_ : QString());
  again_->setText(isMeasuring() ? tr("Cancel") : measured_ ? tr("Measure again") : tr("Measure"));
  again_->setToolTip(isMeasuring() ? tr("Stop measuring") : tr("Time each setting on the open volume, around the present pose"));
  again_->setEnabled(session_.subject().has_value());
  if (isMeasuring()) {
    poll_->start();
  } else {
    poll_->stop();
  }
}

}  // namespace ew::ui
