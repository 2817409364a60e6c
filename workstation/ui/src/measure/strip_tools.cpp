#include "measure/strip_tools.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>

#include "measure/caliper_tool_row.h"
#include "measure/calipers/calipers.h"
#include "measure/words/caliper_words.h"
#include "scan/session.h"

namespace ew::ui {

using measurement::CaliperKind;

StripTools::StripTools(Session& session, Calipers& calipers, QWidget* parent) : QWidget(parent), calipers_(calipers), session_(session) {
  setObjectName(QStringLiteral("stripTools"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(8);
  tools_ = new CaliperToolRow(calipers_, measurement::stripKinds(),
                              [](CaliperKind kind) { return tr("%1 in the strip", "a tool").arg(CaliperWords::nameOf(kind)); });
  rows->addWidget(tools_);
  beatsRow_ = new QWidget;
  auto* beats = new QHBoxLayout(beatsRow_);
  beats->setContentsMargins(0, 0, 0, 0);
  auto* label = new QLabel(tr("Heart beats"));
  beats_ = new QSpinBox;
  beats_->setObjectName(QStringLiteral("heartBeats"));
  beats_->setRange(1, measurement::kMostCycles);
  beats_->setAccessibleName(label->text());
  beats_->setToolTip(tr("Over how many heart beats the heart rate is measured; the more, the smaller its uncertainty"));
  label->setBuddy(beats_);
  beats->addWidget(label, 1);
  beats->addWidget(beats_);
  rows->addWidget(beatsRow_);
  connect(beats_, qOverload<int>(&QSpinBox::valueChanged), this, [this](int value) { calipers_.setBeats(value); });
  connect(&calipers_, &Calipers::changed, this, &StripTools::showAll);
  connect(&session_, &Session::imageChanged, this, [this] {
    if (isHidden() == calipers_.hasStrip()) showAll();
  });
  showAll();
}

void StripTools::refreshIcons() { tools_->refreshIcons(); }

void StripTools::showAll() {
  const auto tool = calipers_.drawing().tool();
  const auto& strip = calipers_.drawingIn(Where::strip);
  const auto* chosen = strip.shown().find(strip.selected());
  beatsRow_->setVisible(tool == CaliperKind::heartRate || (chosen != nullptr && chosen->caliper.kind == CaliperKind::heartRate));
  const QSignalBlocker quiet(beats_);
  beats_->setValue(calipers_.beats());
  setVisible(calipers_.hasStrip());
}

}  // namespace ew::ui
