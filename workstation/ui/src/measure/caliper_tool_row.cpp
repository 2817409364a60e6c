#include "measure/caliper_tool_row.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVariant>
#include <utility>

#include "keys/key_table.h"
#include "keys/key_tips.h"
#include "measure/calipers/calipers.h"
#include "measure/words/caliper_words.h"
#include "widgets/icons.h"
#include "widgets/theme.h"

namespace ew::ui {

using measurement::CaliperKind;

CaliperToolRow::CaliperToolRow(Calipers& calipers, std::vector<CaliperKind> kinds, const std::function<QString(CaliperKind)>& nameOf,
                               QWidget* parent)
    : QWidget(parent), calipers_(calipers), kinds_(std::move(kinds)) {
  auto* line = new QHBoxLayout(this);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(1);
  for (std::size_t n = 0; n < kinds_.size(); ++n) {
    const CaliperKind kind = kinds_[n];
    auto* button = new QPushButton;
    button->setObjectName(CaliperWords::iconOf(kind));
    button->setCheckable(true);
    button->setProperty("segment", n == 0 ? "first" : n + 1 == kinds_.size() ? "last" : "true");
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // an icon: all of them fit beside a scroll bar as well
    button->setAccessibleName(CaliperWords::nameOf(kind));
    button->setToolTip(tipWithKeys(nameOf(kind) + QStringLiteral(" (%1)"), caliperCommand(kind)));
    connect(button, &QPushButton::clicked, this, [this, kind] {
      calipers_.take(kind);
      showHeld();  // a tool that could not be taken is not checked
    });
    buttons_.push_back(button);
    line->addWidget(button, 1);
  }
  connect(&calipers_, &Calipers::changed, this, &CaliperToolRow::showHeld);
  refreshIcons();
  showHeld();
}

void CaliperToolRow::refreshIcons() {
  held_ = calipers_.drawing().tool();
  for (std::size_t n = 0; n < kinds_.size(); ++n)
    buttons_[n]->setIcon(icon(CaliperWords::iconOf(kinds_[n]), held_ == kinds_[n] ? currentTheme().onAccent : currentTheme().text));
}

void CaliperToolRow::showHeld() {
  const auto tool = calipers_.drawing().tool();
  for (std::size_t n = 0; n < kinds_.size(); ++n) buttons_[n]->setChecked(tool == kinds_[n]);
  if (tool != held_) refreshIcons();
}

}  // namespace ew::ui
