#include "measure/results_list.h"

#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ew/widgets/figures.h"
#include "ew/widgets/flow_layout.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "keys/key_tips.h"
#include "measure/calipers/calipers.h"
#include "measure/words/finding_words.h"

namespace ew::ui {
namespace {

constexpr int kPage_px = 208;  // of the console's page, less a scroll bar

}  // namespace

void holdHeight(QLabel& text, int width_px) { text.setMinimumHeight(std::max(0, text.heightForWidth(width_px))); }

ResultsList::ResultsList(Calipers& calipers, QWidget* parent) : QWidget(parent), calipers_(calipers) {
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(4);
  list_ = new QVBoxLayout;
  list_->setSpacing(4);
  rows->addLayout(list_);
  how_ = new QLabel;
  how_->setObjectName(QStringLiteral("resultHow"));
  setLook(how_, Look::quiet);
  setLook(how_, Look::small);
  how_->setWordWrap(true);
  rows->addWidget(how_);
  auto* line = new FlowLayout(4);
  const auto add = [&](const char* name, const QString& text, const QString& tip) {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    setLook(button, Look::compact);
    button->setAccessibleName(text);
    button->setToolTip(tip);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    line->addWidget(button);
    return button;
  };
  combine_ = add("combineMeasurements", tr("Combine…"),
                 tipWithKeys(tr("Ratio, stenosis, or volume from measurements of any image (%1)"), "calipers.combine"));
  save_ = add("saveMeasurements", tr("Save list…"), tr("All measurements of all images and their results, as CSV or JSON"));
  remove_ = add("removeResult", tr("Delete result"), tr("Delete the chosen result; its measurements stay"));
  rows->addLayout(line);
  connect(combine_, &QPushButton::clicked, this, &ResultsList::combineAsked);
  connect(save_, &QPushButton::clicked, this, &ResultsList::saveAsked);
  connect(remove_, &QPushButton::clicked, this, [this] { calipers_.removeCombination(chosen_); });
  connect(&calipers_, &Calipers::changed, this, &ResultsList::showAll);
  showAll();
}

void ResultsList::showAll() {
  const auto& findings = calipers_.findings();
  const auto& all = findings.combinations();
  while (lines_.size() > all.size()) {
    lines_.back().button->hide();
    lines_.back().button->deleteLater();  // its click may be what is handled now
    lines_.pop_back();
  }
  while (lines_.size() < all.size()) {
    Line line{new QPushButton, new QLabel, new FigureLabel, 0};
    line.button->setObjectName(QStringLiteral("resultLine"));
    line.button->setCheckable(true);
    setLook(line.button, Look::listed);
    auto* inside = new QVBoxLayout(line.button);
    inside->setContentsMargins(6, 4, 6, 4);
    inside->setSpacing(0);
    line.value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    line.value->setObjectName(QStringLiteral("resultValue"));
    for (QLabel* each : {line.name, line.value}) {
      each->setAttribute(Qt::WA_TransparentForMouseEvents);
      inside->addWidget(each);
      each->setVisible(true);  // a layout counts as empty what was never shown, and its height is asked for at once
    }
    const std::size_t index = lines_.size();
    connect(line.button, &QPushButton::clicked, this, [this, index] {
      if (index < lines_.size()) chosen_ = chosen_ == lines_[index].number ? 0 : lines_[index].number;
      showAll();
    });
    list_->addWidget(line.button);
    lines_.push_back(line);
  }
  const measurement::Combination* chosen = nullptr;
  for (std::size_t n = 0; n < all.size(); ++n) {
    Line& line = lines_[n];
    line.number = all[n].number;
    line.name->setText(QStringLiteral("%1  %2").arg(FindingWords::numberOf(all[n]), FindingWords::nameOf(all[n].kind)));
    line.value->setText(FindingWords::valueOf(findings, all[n]));
    line.button->setAccessibleName(line.name->text() + QLatin1Char(' ') + line.value->text());
    line.button->setToolTip(FindingWords::howItCameAbout(findings, all[n]));
    line.button->setChecked(line.number == chosen_);
    line.button->setMinimumHeight(line.button->layout()->sizeHint().height());
    if (line.number == chosen_) chosen = &all[n];
  }
  if (chosen == nullptr) chosen_ = 0;
  how_->setVisible(chosen != nullptr);
  if (chosen != nullptr) how_->setText(FindingWords::howItCameAbout(findings, *chosen));
  holdHeight(*how_, scaled(kPage_px));
  remove_->setVisible(chosen != nullptr);
  save_->setVisible(!findings.isEmpty() && chosen == nullptr);
  setVisible(!findings.isEmpty());
}

}  // namespace ew::ui
