#include "start/case_filters.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>

#include "ew/widgets/flow_layout.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "ew/widgets/words.h"
#include "start/case_catalogue.h"

namespace ew::ui {
namespace {

constexpr int kShortestChoice = 12;  // letters

}  // namespace

CaseFilters::CaseFilters(QWidget* parent) : QWidget(parent) {
  auto* line = new FlowLayout(kGrid_px);
  setLayout(line);
  kind_ = addChoice("kindFilter", tr("Where cases come from"));
  region_ = addChoice("regionFilter", tr("Region"));
  level_ = addChoice("levelFilter", tr("Level"));
  tag_ = addChoice("tagFilter", tr("Tag"));
  lessons_ = new QCheckBox(tr("With lessons"));
  lessons_->setObjectName(QStringLiteral("lessonsFilter"));
  lessons_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  lessons_->setMinimumHeight(kind_->sizeHint().height());
  line->addWidget(lessons_);
  clear_ = new QPushButton(tr("Show all"));
  clear_->setObjectName(QStringLiteral("clearFilters"));
  clear_->setToolTip(tr("Clear the search and all filters"));
  clear_->hide();
  line->addWidget(clear_);
  count_ = new QLabel;
  count_->setObjectName(QStringLiteral("caseCount"));
  setLook(count_, Look::quiet);
  count_->setMinimumHeight(kind_->sizeHint().height());
  line->addWidget(count_);
  connect(lessons_, &QCheckBox::toggled, this, &CaseFilters::changed);
  connect(clear_, &QPushButton::clicked, this, &CaseFilters::clearRequested);
  setChoices({});
}

QComboBox* CaseFilters::addChoice(const char* name, const QString& accessible) {
  auto* box = new QComboBox;
  box->setObjectName(QLatin1String(name));
  box->setAccessibleName(accessible);
  box->setToolTip(accessible);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(kShortestChoice);
  layout()->addWidget(box);
  connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &CaseFilters::changed);
  return box;
}

void CaseFilters::fillChoice(QComboBox& box, const QString& all, const std::vector<std::pair<QString, QVariant>>& choices) {
  const QSignalBlocker silent(box);
  const QVariant chosen = box.currentData();
  const QString chosenText = box.currentText();
  box.clear();
  box.addItem(all);
  for (const auto& [text, value] : choices) box.addItem(text, value);
  if (chosen.isValid()) {
    if (box.findData(chosen) < 0) box.addItem(chosenText, chosen);
    box.setCurrentIndex(box.findData(chosen));
  }
  box.setVisible(box.count() > 2);
}

void CaseFilters::setChoices(const CaseChoices& choices) {
  std::vector<std::pair<QString, QVariant>> kinds, regions, levels, tags;
  for (const LibraryKind kind : choices.kinds) kinds.emplace_back(kindWords(kind), static_cast<int>(kind));
  for (const std::string& region : choices.regions) regions.emplace_back(words(region), words(region));
  for (const int level : choices.levels) levels.emplace_back(levelWords(level), level);
  for (const std::string& tag : choices.tags) tags.emplace_back(words(tag), words(tag));
  fillChoice(*kind_, tr("All origins"), kinds);
  fillChoice(*region_, tr("All regions"), regions);
  fillChoice(*level_, tr("All levels"), levels);
  fillChoice(*tag_, tr("All tags"), tags);
}

void CaseFilters::fill(CaseQuery& query) const {
  if (const QVariant kind = kind_->currentData(); kind.isValid()) query.kind = static_cast<LibraryKind>(kind.toInt());
  query.region = region_->currentData().toString().toStdString();
  if (const QVariant level = level_->currentData(); level.isValid()) query.level = level.toInt();
  if (const QVariant tag = tag_->currentData(); tag.isValid()) query.tags = {tag.toString().toStdString()};
  query.lessonsOnly = lessons_->isChecked();
}

bool CaseFilters::isNarrowing() const {
  CaseQuery query;
  fill(query);
  return query != CaseQuery();
}

void CaseFilters::clear() {
  for (QComboBox* box : {kind_, region_, level_, tag_}) {
    const QSignalBlocker silent(box);
    box->setCurrentIndex(0);
  }
  const QSignalBlocker silent(lessons_);
  lessons_->setChecked(false);
}

void CaseFilters::setCount(const QString& words) { count_->setText(words); }

void CaseFilters::setClearable(bool clearable) { clear_->setVisible(clearable); }

std::vector<QWidget*> CaseFilters::inOrder() const { return {kind_, region_, level_, tag_, lessons_, clear_}; }

}  // namespace ew::ui
