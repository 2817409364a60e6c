#include "measure_page.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>

#include "caliper_words.h"
#include "figures.h"
#include "icons.h"
#include "theme.h"
#include "worksheet_list.h"

namespace ew::ui {

using measurement::CaliperDrawing;
using measurement::CaliperKind;

namespace {

constexpr int kLineSide_px = 6;
constexpr int kNumber_px = 12;
constexpr int kLineWidth_px = 208;  // of the console's page, less a scroll bar

}  // namespace

class MeasuredLine final : public QPushButton {
 public:
  explicit MeasuredLine(QWidget* parent) : QPushButton(parent) {
    setObjectName(QStringLiteral("measuredLine"));
    setCheckable(true);
    setProperty("listed", true);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(kLineSide_px, 4, kLineSide_px, 4);
    rows->setSpacing(0);
    auto* head = new QHBoxLayout;
    head->setSpacing(8);
    number_ = new QLabel;
    number_->setMinimumWidth(kNumber_px);
    name_ = new QLabel;
    value_ = new FigureLabel;
    value_->setObjectName(QStringLiteral("measuredValue"));
    head->addWidget(number_);
    head->addWidget(name_, 1);
    head->addWidget(value_);
    rows->addLayout(head);
    below_ = new FigureLabel;
    below_->setObjectName(QStringLiteral("measuredBelow"));
    below_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    rows->addWidget(below_);
    others_ = new QLabel;
    others_->setObjectName(QStringLiteral("measuredOthers"));
    others_->setProperty("small", true);
    others_->setProperty("quiet", true);
    others_->setContentsMargins(kNumber_px + 8, 0, 0, 0);
    rows->addWidget(others_);
    for (QLabel* each : {number_, name_, static_cast<QLabel*>(value_), static_cast<QLabel*>(below_), others_})
      each->setAttribute(Qt::WA_TransparentForMouseEvents);
  }
  void show(const Calipers::Line& line, bool isChosen) {
    number = line.measurement.number;
    const QString name = CaliperWords::titleOf(line.measurement), value = CaliperWords::mainResult(line.measured);
    const QString others = CaliperWords::otherResults(line.measured, QStringLiteral("\n"));
    number_->setText(QString::number(number));
    name_->setText(name);
    // A long name leaves its value no room: then it stands below, at the same side.
    const QFontMetrics metrics(value_->font());
    const int needed_px = 2 * kLineSide_px + kNumber_px + 16 + metrics.horizontalAdvance(name) + figuresWidth_px(metrics, value);
    const bool isBelow = needed_px > kLineWidth_px;
    value_->setText(isBelow ? QString() : value);
    below_->setText(isBelow ? value : QString());
    below_->setVisible(isBelow);
    value_->updateGeometry();
    others_->setText(others);
    others_->setVisible(!others.isEmpty());
    setChecked(isChosen);
    setAccessibleName(QStringLiteral("%1 %2 %3").arg(number).arg(name, value));
    setMinimumHeight(layout()->sizeHint().height());
  }
  int number = 0;

 private:
  QLabel* number_ = nullptr;
  QLabel* name_ = nullptr;
  FigureLabel* value_ = nullptr;
  FigureLabel* below_ = nullptr;
  QLabel* others_ = nullptr;
};

MeasurePage::MeasurePage(Calipers& calipers, Worksheets& worksheets, QWidget* parent) : QWidget(parent), calipers_(calipers) {
  setObjectName(QStringLiteral("measurePage"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(8);
  addTools(rows);
  auto* worksheet = new WorksheetList(worksheets, calipers);
  connect(worksheet, &WorksheetList::worksheetAsked, this, &MeasurePage::worksheetAsked);
  rows->addWidget(worksheet);
  addEdits(rows);  // above the list, which may become long
  empty_ = new QLabel;
  empty_->setProperty("quiet", true);
  empty_->setWordWrap(true);
  rows->addWidget(empty_);
  list_ = new QVBoxLayout;
  list_->setSpacing(4);
  rows->addLayout(list_);
  explanation_ = new QLabel;
  explanation_->setObjectName(QStringLiteral("measuredHow"));
  explanation_->setProperty("quiet", true);
  explanation_->setProperty("small", true);
  explanation_->setWordWrap(true);
  rows->addWidget(explanation_);
  rows->addStretch(1);
  connect(&calipers_, &Calipers::changed, this, &MeasurePage::showAll);
  refreshIcons();
  showAll();
}

MeasurePage::~MeasurePage() = default;

void MeasurePage::addTools(QVBoxLayout* rows) {
  auto* line = new QHBoxLayout;
  line->setSpacing(1);
  const auto& kinds = measurement::drawnKinds();
  for (std::size_t n = 0; n < kinds.size(); ++n) {
    auto* button = new QPushButton;
    button->setObjectName(CaliperWords::iconOf(kinds[n]));
    button->setCheckable(true);
    button->setProperty("segment", n == 0 ? "first" : n + 1 == kinds.size() ? "last" : "true");
    button->setFocusPolicy(Qt::TabFocus);
    button->setToolTip(tr("%1 (%2)", "a tool and its key").arg(CaliperWords::nameOf(kinds[n])).arg(n + 4));
    button->setAccessibleName(CaliperWords::nameOf(kinds[n]));
    connect(button, &QPushButton::clicked, this, [this, kind = kinds[n]] {
      calipers_.take(kind);
      showAll();  // a tool that could not be taken is not checked
    });
    tools_.push_back(button);
    line->addWidget(button, 1);
  }
  rows->addLayout(line);
  follows_ = new QCheckBox(tr("Outlines follow edges"));
  follows_->setObjectName(QStringLiteral("followEdges"));
  follows_->setAccessibleName(follows_->text());
  follows_->setToolTip(tr("A few clicks around it are enough: the outline is brought to the edge (0)"));
  connect(follows_, &QCheckBox::toggled, &calipers_, &Calipers::setFollowsEdges);
  rows->addWidget(follows_);
}

void MeasurePage::addEdits(QVBoxLayout* rows) {
  edits_ = new QWidget;
  auto* line = new QHBoxLayout(edits_);
  line->setContentsMargins(0, 0, 0, 0);
  line->setSpacing(4);
  const auto add = [&](const char* name, const QString& tip, const QString& text, void (*edit)(CaliperDrawing&)) {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    button->setProperty("compact", true);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    connect(button, &QPushButton::clicked, this, [this, edit] { calipers_.change(edit); });
    line->addWidget(button, text.isEmpty() ? 0 : 1);
    return button;
  };
  undo_ = add("undoCaliper", tr("Undo (Ctrl+Z)"), {}, [](CaliperDrawing& drawing) { drawing.undo(); });
  redo_ = add("redoCaliper", tr("Redo (Ctrl+Shift+Z)"), {}, [](CaliperDrawing& drawing) { drawing.redo(); });
  remove_ = add("removeCaliper", tr("Delete the chosen measurement, or else the last one (Backspace)"), tr("Delete"),
                [](CaliperDrawing& drawing) { drawing.takeBack(); });
  clear_ =
      add("clearCalipers", tr("Delete all measurements (Ctrl+Delete)"), tr("Delete all"), [](CaliperDrawing& drawing) { drawing.clear(); });
  rows->addWidget(edits_);
}

void MeasurePage::refreshIcons() {
  showIcons();
  undo_->setIcon(icon(QStringLiteral("undo")));
  redo_->setIcon(icon(QStringLiteral("redo")));
}

/// What is held stands on the accent.
void MeasurePage::showIcons() {
  held_ = calipers_.drawing().tool();
  const auto& kinds = measurement::drawnKinds();
  for (std::size_t n = 0; n < tools_.size(); ++n)
    tools_[n]->setIcon(icon(CaliperWords::iconOf(kinds[n]), held_ == kinds[n] ? currentTheme().onAccent : currentTheme().text));
}

void MeasurePage::showAll() {
  const CaliperDrawing& drawing = calipers_.drawing();
  const auto& kinds = measurement::drawnKinds();
  for (std::size_t n = 0; n < tools_.size(); ++n) tools_[n]->setChecked(drawing.tool() == kinds[n]);
  if (drawing.tool() != held_) showIcons();
  follows_->setChecked(calipers_.followsEdges());
  const auto& lines = calipers_.lines();
  while (lines_.size() > lines.size()) {
    lines_.back()->hide();
    lines_.back()->deleteLater();  // its click may be what is handled now
    lines_.pop_back();
  }
  while (lines_.size() < lines.size()) {
    auto* line = new MeasuredLine(this);
    connect(line, &QPushButton::clicked, this,
            [this, line] { calipers_.change([line](CaliperDrawing& each) { each.select(line->number); }); });
    list_->addWidget(line);
    lines_.push_back(line);
  }
  const Calipers::Line* chosen = nullptr;
  for (std::size_t n = 0; n < lines.size(); ++n) {
    const bool isChosen = lines[n].measurement.number == drawing.selected();
    if (isChosen) chosen = &lines[n];
    lines_[n]->show(lines[n], isChosen);
  }
  empty_->setVisible(lines.empty());
  empty_->setText(drawing.tool() ? CaliperWords::hintOf(*drawing.tool())
                                 : tr("Nothing is measured yet. Choose a tool: the image freezes, and the first click sets a point."));
  explanation_->setVisible(chosen != nullptr);
  if (chosen != nullptr) explanation_->setText(CaliperWords::howItCameAbout(chosen->measurement.caliper, calipers_.uncertainty()));
  edits_->setVisible(!drawing.isEmpty() || drawing.canUndo() || drawing.canRedo());
  undo_->setEnabled(drawing.canUndo());
  redo_->setEnabled(drawing.canRedo());
  remove_->setEnabled(!drawing.isEmpty());
  clear_->setEnabled(!drawing.isEmpty());
}

}  // namespace ew::ui
