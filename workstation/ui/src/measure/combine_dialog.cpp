#include "measure/combine_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <array>

#include "ew/widgets/figures.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "measure/calipers/calipers.h"
#include "measure/words/finding_words.h"

namespace ew::ui {
namespace {

using measurement::CaliperFigure;
using measurement::CombinationKind;
using measurement::FigureKind;
using measurement::FigureRef;
using measurement::Finding;

constexpr std::size_t kMostInputs = 3;
constexpr int kLeastWidth_px = 440;
constexpr std::array kCombinationKinds{CombinationKind::ratio, CombinationKind::percent, CombinationKind::reduction,
                                       CombinationKind::ellipsoid, CombinationKind::biplane};

/// Whether a figure is offered for a kind: what cannot be is left out of a volume's lists; ratios say why two do not go together.
bool isOffered(CombinationKind kind, const Finding& finding, const CaliperFigure& figure) {
  if (kind == CombinationKind::biplane)
    return finding.measurement.caliper.kind == measurement::CaliperKind::discs && figure.kind == FigureKind::volume;
  if (kind == CombinationKind::ellipsoid) return measurement::areComparable(figure.quantity.unit, measurement::Unit::mm);
  return true;
}

}  // namespace

CombineDialog::CombineDialog(Calipers& calipers, QWidget* parent) : QDialog(parent), calipers_(calipers) {
  setObjectName(QStringLiteral("combineDialog"));
  setWindowTitle(tr("Combine measurements"));
  auto* rows = new QVBoxLayout(this);
  rows->setSpacing(8);
  auto* form = new QFormLayout;
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  kind_ = new QComboBox;
  kind_->setObjectName(QStringLiteral("combineKind"));
  kind_->setAccessibleName(tr("Result"));
  kind_->setToolTip(tr("What is computed from the measurements below"));
  for (const CombinationKind each : kCombinationKinds) kind_->addItem(FindingWords::nameOf(each), static_cast<int>(each));
  form->addRow(tr("Result"), kind_);
  for (std::size_t n = 0; n < kMostInputs; ++n) {
    Row row{new QLabel, new QComboBox};
    row.choice->setObjectName(QStringLiteral("combineInput%1").arg(n + 1));
    row.choice->setToolTip(tr("A measurement of any image of this patient, and what of it"));
    row.choice->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    form->addRow(row.label, row.choice);
    connect(row.choice, qOverload<int>(&QComboBox::activated), this, &CombineDialog::showResult);
    rows_.push_back(row);
  }
  rows->addLayout(form);
  result_ = new QLabel;
  result_->setObjectName(QStringLiteral("combinedValue"));
  result_->setFont(bold(result_->font()));
  rows->addWidget(result_);
  how_ = new QLabel;
  how_->setObjectName(QStringLiteral("combinedHow"));
  setLook(how_, Look::quiet);
  how_->setWordWrap(true);
  how_->setMinimumHeight(6 * how_->fontMetrics().lineSpacing());  // nothing jumps when another one is chosen
  how_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  rows->addWidget(how_, 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  add_ = buttons->addButton(tr("Add to the list"), QDialogButtonBox::ActionRole);
  add_->setObjectName(QStringLiteral("combineAdd"));
  add_->setDefault(true);
  rows->addWidget(buttons);
  setMinimumWidth(kLeastWidth_px);
  connect(kind_, qOverload<int>(&QComboBox::activated), this, &CombineDialog::showInputs);
  connect(add_, &QPushButton::clicked, this, [this] { calipers_.combine(kind(), chosen()); });
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
  connect(&calipers_, &Calipers::linesChanged, this, &CombineDialog::showInputs);
  showInputs();
}

CombinationKind CombineDialog::kind() const { return static_cast<CombinationKind>(kind_->currentData().toInt()); }

std::vector<FigureRef> CombineDialog::chosen() const {
  std::vector<FigureRef> of;
  for (std::size_t n = 0; n < measurement::inputCount(kind()); ++n) {
    const int index = rows_[n].choice->currentIndex();
    if (index >= 0 && static_cast<std::size_t>(index) < offered_.size()) of.push_back(offered_[static_cast<std::size_t>(index)]);
  }
  return of;
}

void CombineDialog::showInputs() {
  const std::vector<FigureRef> before = chosen();
  const auto& findings = calipers_.findings();
  offered_.clear();
  QStringList texts;
  for (const Finding& finding : findings.all())
    for (const CaliperFigure& each : finding.measured.figures) {
      if (!isOffered(kind(), finding, each)) continue;
      offered_.push_back({finding.image, finding.measurement.number, each.kind});
      texts << FindingWords::textOf(findings, finding, each);
    }
  const std::size_t count = measurement::inputCount(kind());
  for (std::size_t n = 0; n < rows_.size(); ++n) {
    const QSignalBlocker quiet(rows_[n].choice);
    const bool isUsed = n < count;
    rows_[n].label->setVisible(isUsed);
    rows_[n].choice->setVisible(isUsed);
    if (!isUsed) continue;
    rows_[n].label->setText(FindingWords::inputOf(kind(), n));
    rows_[n].choice->setAccessibleName(rows_[n].label->text());
    rows_[n].choice->clear();
    rows_[n].choice->addItems(texts);
    // What was chosen stays; else each row takes the next.
    const auto kept = n < before.size() ? std::find(offered_.begin(), offered_.end(), before[n]) : offered_.end();
    const int next = std::min(static_cast<int>(n), texts.size() - 1);
    rows_[n].choice->setCurrentIndex(kept != offered_.end() ? static_cast<int>(kept - offered_.begin()) : next);
  }
  showResult();
}

void CombineDialog::showResult() {
  const auto& findings = calipers_.findings();
  const measurement::Combination asked{0, kind(), chosen()};
  const bool isEmpty = offered_.empty();
  const bool isThere = !isEmpty && findings.combine(asked.kind, asked.of).has_value();
  result_->setText(isThere ? FindingWords::valueOf(findings, asked) : QStringLiteral("–"));
  how_->setText(
      isEmpty ? (kind() == CombinationKind::biplane
                     ? tr("Nothing is measured by discs yet. Take the tool for volumes by discs, and draw axis and outline in both planes.")
                     : tr("Nothing is measured yet that this could be computed from. Measure it first; this window may stay open."))
              : FindingWords::howItCameAbout(findings, asked));
  add_->setEnabled(isThere);
  for (const Row& row : rows_) row.choice->setEnabled(!isEmpty);
}

}  // namespace ew::ui
