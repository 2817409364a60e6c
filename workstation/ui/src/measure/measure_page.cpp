#include "measure/measure_page.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <functional>
#include <utility>

#include "ew/widgets/figures.h"
#include "ew/widgets/flow_layout.h"
#include "ew/widgets/icons.h"
#include "ew/widgets/look.h"
#include "ew/widgets/theme.h"
#include "keys/key_table.h"
#include "keys/key_tips.h"
#include "measure/caliper_tool_row.h"
#include "measure/calipers/caliper_origin.h"
#include "measure/results_list.h"
#include "measure/strip_tools.h"
#include "measure/words/caliper_words.h"
#include "measure/worksheets/worksheet_list.h"

namespace ew::ui {

using measurement::CaliperDrawing;
using measurement::CaliperKind;

namespace {

constexpr int kLineSide_px = 6;
constexpr int kNumber_px = 12;
constexpr int kLineWidth_px = 208;    // of the console's page, less a scroll bar
constexpr int kConsoleEdges_px = 40;  // of the console, beside it

}  // namespace

class MeasurementLine final : public QPushButton {
 public:
  explicit MeasurementLine(QWidget* parent) : QPushButton(parent) {
    setObjectName(QStringLiteral("measuredLine"));
    setCheckable(true);
    setLook(this, Look::listed);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(kLineSide_px, 4, kLineSide_px, 4);
    rows->setSpacing(0);
    auto* head = new QHBoxLayout;
    head->setSpacing(8);
    number_ = new QLabel;
    number_->setMinimumWidth(scaled(kNumber_px));
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
    setLook(others_, Look::small);
    setLook(others_, Look::quiet);
    others_->setContentsMargins(kNumber_px + 8, 0, 0, 0);
    rows->addWidget(others_);
    for (QLabel* each : {number_, name_, static_cast<QLabel*>(value_), static_cast<QLabel*>(below_), others_}) {
      each->setAttribute(Qt::WA_TransparentForMouseEvents);
      each->setVisible(true);  // a layout counts as empty what was never shown, and its height is asked for at once
    }
  }
  void show(const Calipers::Line& line, bool isChosen) {
    number = line.measurement.number;
    where = line.where;
    const QString name = CaliperWords::titleOf(line.measurement), value = CaliperWords::mainResult(line.measured);
    QString others = CaliperWords::otherResults(line.measured, QStringLiteral("\n"));
    if (line.hasLeft) others += (others.isEmpty() ? QString() : QStringLiteral("\n")) + MeasurePage::tr("has left the strip");
    const QString shownNumber = CaliperWords::numberOf(where, number);
    number_->setText(shownNumber);
    name_->setText(name);
    // A long name leaves its value no room: then it stands below, at the same side.
    const QFontMetrics metrics(value_->font());
    const int needed_px = 2 * kLineSide_px + std::max(scaled(kNumber_px), metrics.horizontalAdvance(shownNumber)) + 16 +
                          metrics.horizontalAdvance(name) + figuresWidth_px(metrics, value);
    const bool isBelow = needed_px > scaled(kLineWidth_px + kConsoleEdges_px) - kConsoleEdges_px;
    value_->setText(isBelow ? QString() : value);
    below_->setText(isBelow ? value : QString());
    below_->setVisible(isBelow);
    value_->updateGeometry();
    others_->setText(others);
    others_->setVisible(!others.isEmpty());
    setChecked(isChosen);
    setAccessibleName(QStringLiteral("%1 %2 %3").arg(shownNumber, name, value));
    setMinimumHeight(layout()->sizeHint().height());
  }
  int number = 0;
  Where where = Where::image;

 private:
  QLabel* number_ = nullptr;
  QLabel* name_ = nullptr;
  FigureLabel* value_ = nullptr;
  FigureLabel* below_ = nullptr;
  QLabel* others_ = nullptr;
};

MeasurePage::MeasurePage(Session& session, Calipers& calipers, Worksheets& worksheets, QWidget* parent)
    : QWidget(parent), calipers_(calipers) {
  setObjectName(QStringLiteral("measurePage"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(8);
  addTools(session, rows);
  auto* worksheet = new WorksheetList(worksheets, calipers);
  connect(worksheet, &WorksheetList::worksheetAsked, this, &MeasurePage::worksheetAsked);
  rows->addWidget(worksheet);
  addEdits(rows);  // above the list, which may become long
  empty_ = new QLabel;
  setLook(empty_, Look::quiet);
  empty_->setWordWrap(true);
  rows->addWidget(empty_);
  own_ = new QLabel;
  own_->setObjectName(QStringLiteral("measuredPicture"));
  setLook(own_, Look::quiet);
  own_->hide();
  rows->addWidget(own_);
  list_ = new QVBoxLayout;
  list_->setSpacing(4);
  rows->addLayout(list_);
  explanation_ = new QLabel;
  explanation_->setObjectName(QStringLiteral("measuredHow"));
  setLook(explanation_, Look::quiet);
  setLook(explanation_, Look::small);
  explanation_->setWordWrap(true);
  rows->addWidget(explanation_);
  auto* results = new ResultsList(calipers_);
  connect(results, &ResultsList::combineAsked, this, &MeasurePage::combineAsked);
  connect(results, &ResultsList::saveAsked, this, &MeasurePage::saveAsked);
  rows->addWidget(results);
  others_ = new QWidget;
  auto* others = new QVBoxLayout(others_);
  others->setContentsMargins(0, 0, 0, 0);
  others->setSpacing(4);
  others_->hide();
  rows->addWidget(others_);
  rows->addStretch(1);
  connect(&calipers_, &Calipers::changed, this, &MeasurePage::showAll);
  refreshIcons();
  showAll();
}

MeasurePage::~MeasurePage() = default;

void MeasurePage::addTools(Session& session, QVBoxLayout* rows) {
  tools_ = new CaliperToolRow(calipers_, measurement::drawnKinds(), [](CaliperKind kind) { return CaliperWords::nameOf(kind); });
  rows->addWidget(tools_);
  strip_ = new StripTools(session, calipers_);
  rows->addWidget(strip_);
  follows_ = new QCheckBox(tr("Outlines follow edges"));
  follows_->setObjectName(QStringLiteral("followEdges"));
  follows_->setAccessibleName(follows_->text());
  follows_->setToolTip(
      tipWithKeys(tr("A few clicks around it are enough: the outline is brought to the edge (%1)"), "calipers.followEdges"));
  connect(follows_, &QCheckBox::toggled, &calipers_, &Calipers::setFollowsEdges);
  rows->addWidget(follows_);
  snaps_ = new QCheckBox(tr("Points snap"));
  snaps_->setObjectName(QStringLiteral("snapPoints"));
  snaps_->setAccessibleName(snaps_->text());
  snaps_->setToolTip(
      tipWithKeys(tr("To crosses, edges, and level or plumb with the point before; a mark and a word show it before the click (%1). "
                     "Hold Ctrl to do the opposite once"),
                  "calipers.snap"));
  connect(snaps_, &QCheckBox::toggled, &calipers_, &Calipers::setSnaps);
  rows->addWidget(snaps_);
}

void MeasurePage::addEdits(QVBoxLayout* rows) {
  edits_ = new QWidget;
  auto* line = new FlowLayout(4);
  edits_->setLayout(line);
  const auto add = [&](const char* name, const QString& tip, const QString& text, std::function<void()> edit) {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    setLook(button, Look::compact);
    button->setAccessibleName(tip);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, std::move(edit));
    if (!text.isEmpty()) button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    line->addWidget(button);
    return button;
  };
  undo_ = add("undoCaliper", tipWithKeys(tr("Undo (%1)"), "undo"), {},
              [this] { calipers_.change([](CaliperDrawing& drawing) { drawing.undo(); }); });
  redo_ = add("redoCaliper", tipWithKeys(tr("Redo (%1)"), "redo"), {},
              [this] { calipers_.change([](CaliperDrawing& drawing) { drawing.redo(); }); });
  remove_ = add("removeCaliper", tipWithKeys(tr("Delete the chosen measurement, or else the last one (%1)"), "cross.takeBack"),
                tr("Delete"), [this] { calipers_.change([](CaliperDrawing& drawing) { drawing.takeBack(); }); });
  clear_ = add("clearCalipers", tipWithKeys(tr("Delete all measurements (%1)"), "calipers.clear"), tr("Delete all"),
               [this] { calipers_.clear(); });
  rows->addWidget(edits_);
}

void MeasurePage::refreshIcons() {
  tools_->refreshIcons();
  strip_->refreshIcons();
  undo_->setIcon(icon(QStringLiteral("undo")));
  redo_->setIcon(icon(QStringLiteral("redo")));
}

/// What is held stands on the accent.
void MeasurePage::setImages(const QString& own, const std::vector<OfImage>& others) {
  own_->setText(own.isEmpty() ? QString() : tr("Image %1").arg(own));
  own_->setVisible(!own.isEmpty());
  for (QWidget* each : others_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
    each->hide();
    each->deleteLater();  // its click may be what is handled now
  }
  bool isAny = false;
  for (const OfImage& image : others) {
    if (image.lines.empty()) continue;
    isAny = true;
    auto* name = new QLabel(tr("Image %1").arg(image.name));
    name->setObjectName(QStringLiteral("measuredPicture"));
    setLook(name, Look::quiet);
    others_->layout()->addWidget(name);
    for (const Calipers::Line& each : image.lines) {
      auto* line = new MeasurementLine(others_);
      line->show(each, false);
      line->setObjectName(QStringLiteral("measuredElsewhere"));
      line->setToolTip(tr("Measured on another image; a click takes that one in hand"));
      line->setAccessibleName(tr("Image %1: %2").arg(image.name, line->accessibleName()));
      connect(line, &QPushButton::clicked, this, [this, place = image.place] { Q_EMIT imageAsked(place); });
      others_->layout()->addWidget(line);
    }
  }
  others_->setVisible(isAny);
}

void MeasurePage::showAll() {
  const CaliperDrawing& drawing = calipers_.drawing();
  follows_->setChecked(calipers_.followsEdges());
  snaps_->setChecked(calipers_.snaps());
  const auto& lines = calipers_.lines();
  while (lines_.size() > lines.size()) {
    lines_.back()->hide();
    lines_.back()->deleteLater();  // its click may be what is handled now
    lines_.pop_back();
  }
  while (lines_.size() < lines.size()) {
    auto* line = new MeasurementLine(this);
    connect(line, &QPushButton::clicked, this, [this, line] { calipers_.choose(line->where, line->number); });
    list_->addWidget(line);
    lines_.push_back(line);
  }
  const Calipers::Line* chosen = nullptr;
  for (std::size_t n = 0; n < lines.size(); ++n) {
    const bool isChosen = lines[n].measurement.number == calipers_.drawingIn(lines[n].where).selected();
    if (isChosen) chosen = &lines[n];
    lines_[n]->show(lines[n], isChosen);
  }
  empty_->setVisible(lines.empty());
  empty_->setText(drawing.tool() ? CaliperWords::hintOf(*drawing.tool())
                                 : tr("Nothing is measured yet. Choose a tool: the image freezes, and the first click sets a point."));
  explanation_->setVisible(chosen != nullptr);
  if (chosen != nullptr) explanation_->setText(howItCameAbout(*chosen));
  holdHeight(*explanation_, kLineWidth_px);
  holdHeight(*empty_, kLineWidth_px);
  const bool isEmpty = drawing.isEmpty() && lines.empty();
  edits_->setVisible(!isEmpty || drawing.canUndo() || drawing.canRedo());
  undo_->setEnabled(drawing.canUndo());
  redo_->setEnabled(drawing.canRedo());
  remove_->setEnabled(!drawing.isEmpty());
  clear_->setEnabled(!isEmpty);
}

}  // namespace ew::ui
