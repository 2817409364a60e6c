#include "panel/pair_list.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>

#include "ew/widgets/fields.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "panel/fields.h"

namespace ew::case_authoring {
namespace {

// What stands first in the choice of places on the body.
constexpr int kNowhere = 0;
constexpr int kClick = 1;
constexpr int kClicked = 2;  // there once somebody has
constexpr int kFirstLandmark = 3;

QString nameOf(const BodyLandmark& landmark) { return words(landmark.name.in(QLocale().name().toStdString())); }

}  // namespace

PairList::PairList(QWidget* parent) : EntryRows(kGrid_px, parent) {}

void PairList::setLandmarks(std::vector<BodyLandmark> landmarks) {
  if (landmarks == landmarks_) return;
  landmarks_ = std::move(landmarks);
  rows_.clear();  // made anew with the next list: the choices are others
  remake(0);
}

void PairList::remake(std::size_t count) {
  QVBoxLayout& rows = emptied();
  rows_.clear();
  for (std::size_t pair = 0; pair < count; ++pair) rows_.push_back(addRow(pair, rows));
}

PairList::Row PairList::addRow(std::size_t pair, QVBoxLayout& rows) {
  const QString prefix = QStringLiteral("pair_%1_").arg(pair);
  Row row;
  auto* head = new QHBoxLayout;
  head->setSpacing(kGrid_px);
  row.name = new WithHostUndo<QLineEdit>;
  row.name->setObjectName(prefix + QStringLiteral("name"));
  row.name->setPlaceholderText(tr("Place %1").arg(pair + 1));
  row.name->setAccessibleName(tr("What place %1 is called").arg(pair + 1));
  connect(row.name, &QLineEdit::textEdited, this, [this, pair](const QString& text) { onNamed(pair, text); });
  head->addWidget(row.name, 1);
  row.residual = new QLabel;
  row.residual->setObjectName(prefix + QStringLiteral("residual"));
  row.residual->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row.residual->setMinimumWidth(8 * kGrid_px);
  row.residual->setToolTip(tr("How far the place in the volume then lies from the place on the body"));
  head->addWidget(row.residual);
  auto* away = new QPushButton(tr("Remove"));
  away->setObjectName(prefix + QStringLiteral("remove"));
  setLook(away, Look::flat);
  connect(away, &QPushButton::clicked, this, [this, pair] { onRemoved(pair); });
  head->addWidget(away);
  auto* places = new QHBoxLayout;
  places->setSpacing(kGrid_px);
  row.inImage = new QPushButton;
  row.inImage->setObjectName(prefix + QStringLiteral("inImage"));
  row.inImage->setCheckable(true);
  connect(row.inImage, &QPushButton::clicked, this, [this, pair](bool asks) { onInImage(pair, asks); });
  places->addWidget(row.inImage, 1);
  auto* onBody = new ChoiceField;
  row.onBody = onBody;
  onBody->setObjectName(prefix + QStringLiteral("onBody"));
  onBody->setFocusPolicy(Qt::StrongFocus);
  onBody->setAccessibleName(tr("Where place %1 is on the body").arg(pair + 1));
  onBody->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  onBody->setMinimumContentsLength(12);
  onBody->addItem(tr("On the body…"));
  onBody->addItem(tr("Click on the skin"));
  onBody->addItem(QString());
  for (const BodyLandmark& each : landmarks_) onBody->addItem(nameOf(each));
  connect(onBody, QOverload<int>::of(&QComboBox::activated), this, [this, pair](int index) { chooseBody(pair, index); });
  places->addWidget(onBody, 1);
  rows.addLayout(head);
  rows.addLayout(places);
  return row;
}

void PairList::chooseBody(std::size_t pair, int index) {
  if (index == kClick) return onOnBody(pair);
  const auto landmark = static_cast<std::size_t>(index - kFirstLandmark);
  if (index >= kFirstLandmark && landmark < landmarks_.size()) return onLandmark(pair, landmarks_[landmark]);
  if (onNamed) onNamed(pair, rows_[pair].name->text());  // nothing was chosen: what is shown is shown again
}

void PairList::show(const std::vector<DraftPair>& pairs, const PairsFit& fit, const std::optional<Asked>& asked) {
  if (rows_.size() != pairs.size()) remake(pairs.size());
  for (std::size_t pair = 0; pair < pairs.size(); ++pair) {
    const DraftPair& one = pairs[pair];
    const Row& row = rows_[pair];
    const QString name = words(one.name);
    if (row.name->text() != name) row.name->setText(name);
    const bool isWrong = fit.wrong == pair;
    row.residual->setText(fit.residuals_mm[pair] ? (isWrong ? QStringLiteral("⚠ ") : QString()) +
                                                       tr("%1 mm").arg(QLocale().toString(*fit.residuals_mm[pair], 'f', 1))
                                                 : QString());
    row.residual->setForegroundRole(isWrong ? QPalette::BrightText : QPalette::WindowText);
    const bool asksImage = asked == Asked{pair, true};
    row.inImage->setChecked(asksImage);
    row.inImage->setText(asksImage ? tr("Click in the image") : one.file_mm ? tr("In the image ✓") : tr("In the image…"));
    row.inImage->setToolTip(one.file_mm ? tr("Point at the place in the scan image again") : tr("Point at the place in the scan image"));
    showBody(*row.onBody, one, asked == Asked{pair, false});
  }
}

void PairList::showBody(QComboBox& choice, const DraftPair& pair, bool asked) const {
  const QSignalBlocker quiet(choice);
  const auto mm = [](double value) { return QLocale().toString(value, 'f', 0); };
  choice.setItemText(kClicked, pair.world_mm
                                   ? tr("Clicked ✓ (%1, %2, %3)").arg(mm(pair.world_mm->x), mm(pair.world_mm->y), mm(pair.world_mm->z))
                                   : tr("not clicked yet"));
  int index = kNowhere;
  if (asked) {
    index = kClick;
  } else if (pair.world_mm) {
    index = kClicked;
    for (std::size_t n = 0; n < landmarks_.size(); ++n)
      if (landmarks_[n].id == pair.landmark) index = kFirstLandmark + static_cast<int>(n);
  }
  choice.setCurrentIndex(index);
  choice.setToolTip(choice.currentText());
}

}  // namespace ew::case_authoring
