#include "measure/caliper_tool_row.h"

#include <QEvent>
#include <QGridLayout>
#include <QPushButton>
#include <QVariant>
#include <utility>

#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "keys/key_table.h"
#include "keys/key_tips.h"
#include "measure/calipers/calipers.h"
#include "measure/words/caliper_words.h"

namespace ew::ui {

using measurement::CaliperKind;

namespace {

constexpr int kGapOfTools_px = 4;

}  // namespace

std::vector<int> buttonsOnLines(const std::vector<int>& widths_px, int room_px, int gap_px) {
  std::vector<int> lines;
  const int half_px = (room_px - gap_px) / 2;
  for (std::size_t n = 0; n < widths_px.size(); n += static_cast<std::size_t>(lines.back())) {
    const bool isPair = n + 1 < widths_px.size() && widths_px[n] <= half_px && widths_px[n + 1] <= half_px;
    lines.push_back(isPair ? 2 : 1);
  }
  return lines;
}

CaliperToolRow::CaliperToolRow(Calipers& calipers, std::vector<CaliperKind> kinds, const std::function<QString(CaliperKind)>& nameOf,
                               QWidget* parent)
    : QWidget(parent), calipers_(calipers), kinds_(std::move(kinds)) {
  lines_ = new QGridLayout(this);
  lines_->setContentsMargins(0, 0, 0, 0);
  lines_->setSpacing(kGapOfTools_px);
  lines_->setColumnStretch(0, 1);
  lines_->setColumnStretch(1, 1);
  for (std::size_t n = 0; n < kinds_.size(); ++n) {
    const CaliperKind kind = kinds_[n];
    auto* button = new QPushButton(CaliperWords::nameOf(kind));
    button->setObjectName(CaliperWords::iconOf(kind));
    button->setCheckable(true);
    setLook(button, Look::compact);
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // as wide as its line, which fits beside a scroll bar as well
    button->setAccessibleName(CaliperWords::nameOf(kind));
    button->setToolTip(tipWithKeys(nameOf(kind) + QStringLiteral(" (%1)"), caliperCommand(kind)));
    connect(button, &QPushButton::clicked, this, [this, kind] {
      calipers_.take(kind);
      showHeld();  // a tool that could not be taken is not checked
    });
    buttons_.push_back(button);
  }
  arrange();
  connect(&calipers_, &Calipers::changed, this, &CaliperToolRow::showHeld);
  refreshIcons();
  showHeld();
}

void CaliperToolRow::arrange() {
  std::vector<int> widths_px;
  for (QPushButton* button : buttons_) {
    button->ensurePolished();
    widths_px.push_back(button->sizeHint().width());
  }
  const std::vector<int> onLines = buttonsOnLines(widths_px, width(), kGapOfTools_px);
  if (onLines == onLines_) return;
  onLines_ = onLines;
  std::size_t next = 0;
  for (std::size_t line = 0; line < onLines.size(); ++line) {
    for (int column = 0; column < onLines[line]; ++column)
      lines_->addWidget(buttons_[next++], static_cast<int>(line), column, 1, onLines[line] == 1 ? 2 : 1);
  }
}

void CaliperToolRow::resizeEvent(QResizeEvent*) { arrange(); }
void CaliperToolRow::showEvent(QShowEvent*) { arrange(); }

void CaliperToolRow::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange) arrange();
}

void CaliperToolRow::refreshIcons() {
  held_ = calipers_.drawing().tool();
  for (std::size_t n = 0; n < kinds_.size(); ++n)
    buttons_[n]->setIcon(held_ == kinds_[n] ? icon(CaliperWords::iconOf(kinds_[n]), currentTheme().onAccent)
                                            : icon(CaliperWords::iconOf(kinds_[n])));  // follows the theme
}

void CaliperToolRow::showHeld() {
  const auto tool = calipers_.drawing().tool();
  for (std::size_t n = 0; n < kinds_.size(); ++n) buttons_[n]->setChecked(tool == kinds_[n]);
  if (tool != held_) refreshIcons();
}

}  // namespace ew::ui
