#include "measure/worksheets/worksheet_list.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ew/widgets/figures.h"
#include "ew/widgets/look.h"
#include "ew/widgets/words.h"
#include "keys/key_tips.h"
#include "measure/calipers/calipers.h"
#include "measure/words/caliper_words.h"
#include "measure/words/worksheet_words.h"
#include "measure/worksheets/worksheets.h"

namespace ew::ui {

using measurement::Examination;
using measurement::ItemMeasure;
using measurement::PackageItem;
using measurement::Quantity;

namespace {

/// The mean of what was measured, without its uncertainty: the worksheet has that.
QString meanOf(const std::vector<Quantity>& values, measurement::Unit unit) {
  if (values.empty()) return {};
  double sum = 0.0;
  for (const Quantity& each : values) sum += converted(each, unit).value;
  return CaliperWords::textOf({sum / static_cast<double>(values.size()), 0.0, unit});
}

}  // namespace

WorksheetList::WorksheetList(Worksheets& worksheets, Calipers& calipers, QWidget* parent)
    : QWidget(parent), worksheets_(worksheets), calipers_(calipers) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  choice_ = new QComboBox;
  choice_->setObjectName(QStringLiteral("worksheetChoice"));
  choice_->setToolTip(tr("Which worksheet the measurements go to"));
  choice_->setAccessibleName(tr("Worksheet"));
  choice_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  rows->addWidget(choice_);
  items_ = new QWidget;
  auto* list = new QVBoxLayout(items_);
  list->setContentsMargins(0, 0, 0, 0);
  list->setSpacing(1);
  rows->addWidget(items_);
  open_ = new QPushButton(tr("Show worksheet…"));
  open_->setObjectName(QStringLiteral("showWorksheet"));
  open_->setAccessibleName(open_->text());
  setLook(open_, Look::compact);
  open_->setToolTip(tipWithKeys(tr("Results, usual ranges and charts, answers; save it (%1)"), "calipers.worksheet"));
  rows->addWidget(open_);
  connect(open_, &QPushButton::clicked, this, &WorksheetList::worksheetAsked);
  connect(choice_, qOverload<int>(&QComboBox::activated), this,
          [this](int index) { worksheets_.choose(choice_->itemData(index).toString().toStdString()); });
  connect(&worksheets_, &Worksheets::packagesChanged, this, &WorksheetList::showPackages);
  connect(&worksheets_, &Worksheets::changed, this, &WorksheetList::showItems);
  connect(&calipers_, &Calipers::changed, this, &WorksheetList::showHeld);
  showPackages();
}

void WorksheetList::showPackages() {
  choice_->clear();
  choice_->addItem(tr("No worksheet"), QString());
  for (const auto& package : worksheets_.packages()) choice_->addItem(words(package->title), QString::fromStdString(package->id));
  showItems();
}

void WorksheetList::showItems() {
  const Examination* examination = worksheets_.current();
  const void* package = examination != nullptr ? &examination->package() : nullptr;
  if (package != shownPackage_) {
    shownPackage_ = package;
    for (const Entry& entry : entries_) {
      entry.button->hide();
      entry.button->deleteLater();  // its click may be what is handled now
    }
    entries_.clear();
    if (examination != nullptr) {
      for (const PackageItem& item : examination->package().items) {
        if (item.measure == ItemMeasure::choice) continue;  // answered in the worksheet
        for (const char* side : item.isSided ? std::vector<const char*>{"right", "left"} : std::vector<const char*>{""}) {
          Entry entry{item.label, side, new QPushButton, new FigureLabel, {}};
          const QString title = words(item.title);
          const QString named = *side == 0 ? title : tr("%1, %2", "an item and its side").arg(title, WorksheetWords::sideOf(side));
          entry.button->setObjectName(QStringLiteral("worksheetItem"));
          setLook(entry.button, Look::listed);
          entry.button->setCheckable(true);
          entry.button->setFocusPolicy(Qt::TabFocus);
          entry.button->setAccessibleName(named);
          entry.tip = words(item.convention).isEmpty()
                          ? named
                          : tr("%1\n%2", "an item, and where its calipers go").arg(named, words(item.convention));
          entry.button->setToolTip(entry.tip);
          auto* line = new QHBoxLayout(entry.button);
          line->setContentsMargins(6, 2, 6, 2);
          auto* name = new QLabel(named);
          name->setWordWrap(true);
          setLook(name, Look::small);
          for (QLabel* each : {name, entry.value}) each->setAttribute(Qt::WA_TransparentForMouseEvents);
          entry.value->setObjectName(QStringLiteral("worksheetValue"));
          line->addWidget(name, 1);
          line->addWidget(entry.value);
          connect(entry.button, &QPushButton::clicked, this,
                  [this, label = entry.item, of = entry.side] { worksheets_.measure(label, of); });
          items_->layout()->addWidget(entry.button);
          entries_.push_back(entry);
        }
      }
    }
    const int index = examination != nullptr ? choice_->findData(QString::fromStdString(examination->package().id)) : 0;
    choice_->setCurrentIndex(index);
  }
  items_->setVisible(!entries_.empty());
  open_->setVisible(examination != nullptr);
  showValues();
  showHeld();
}

void WorksheetList::showValues() {
  const Examination* examination = worksheets_.current();
  if (examination == nullptr) return;
  for (const Entry& entry : entries_) {
    const PackageItem* item = examination->package().item(entry.item);
    entry.value->setText(meanOf(examination->of(entry.item, entry.side), item->unit));
    const QString images = imagesOf(entry);
    entry.button->setToolTip(images.isEmpty() ? entry.tip : entry.tip + QLatin1Char('\n') + images);
    entry.button->setMinimumHeight(entry.button->layout()->heightForWidth(std::max(entry.button->width(), 160)));
  }
}

/// Where the values of an item were measured, when there are several images.
QString WorksheetList::imagesOf(const Entry& entry) const {
  QStringList names;
  if (!worksheets_.nameOfImage) return {};
  for (const auto& found : worksheets_.current()->found()) {
    if (found.entry.label != entry.item || found.entry.side != entry.side) continue;
    const QString name = worksheets_.nameOfImage(found.image);
    if (!name.isEmpty() && !names.contains(name)) names << name;
  }
  return names.isEmpty() ? QString() : tr("Measured on image %1").arg(names.join(QStringLiteral(", ")));
}

/// An item whose caliper is in the hand is checked.
void WorksheetList::showHeld() {
  const auto& drawing = calipers_.drawing();
  for (const Entry& entry : entries_)
    entry.button->setChecked(drawing.tool() && drawing.purpose().item == entry.item && drawing.purpose().side == entry.side);
}

}  // namespace ew::ui
