#include "strip_tools.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QVBoxLayout>
#include <QVariant>

#include "caliper_words.h"
#include "calipers.h"
#include "icons.h"
#include "key_table.h"
#include "key_tips.h"
#include "session.h"
#include "theme.h"

namespace ew::ui {

using measurement::CaliperKind;

StripTools::StripTools(Session& session, Calipers& calipers, QWidget* parent) : QWidget(parent), calipers_(calipers), session_(session) {
  setObjectName(QStringLiteral("stripTools"));
  auto* rows = new QVBoxLayout(this);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(8);
  auto* line = new QHBoxLayout;
  line->setSpacing(1);
  const auto& kinds = measurement::stripKinds();
  for (std::size_t n = 0; n < kinds.size(); ++n) {
    auto* button = new QPushButton;
    button->setObjectName(CaliperWords::iconOf(kinds[n]));
    button->setCheckable(true);
    button->setProperty("segment", n == 0 ? "first" : n + 1 == kinds.size() ? "last" : "true");
    button->setFocusPolicy(Qt::TabFocus);
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // an icon: all of them fit beside a scroll bar as well
    button->setAccessibleName(CaliperWords::nameOf(kinds[n]));
    button->setToolTip(tipWithKeys(tr("%1 in the strip", "a tool").arg(CaliperWords::nameOf(kinds[n])) + QStringLiteral(" (%1)"),
                                   caliperCommand(kinds[n])));
    connect(button, &QPushButton::clicked, this, [this, kind = kinds[n]] {
      calipers_.take(kind);
      showAll();  // a tool that could not be taken is not checked
    });
    tools_.push_back(button);
    line->addWidget(button, 1);
  }
  rows->addLayout(line);
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
  connect(&session_, &Session::pictureChanged, this, [this] {
    if (isHidden() == calipers_.hasStrip()) showAll();
  });
  showAll();
}

void StripTools::showIcons() {
  held_ = calipers_.drawing().tool();
  const auto& kinds = measurement::stripKinds();
  for (std::size_t n = 0; n < tools_.size(); ++n)
    tools_[n]->setIcon(icon(CaliperWords::iconOf(kinds[n]), held_ == kinds[n] ? currentTheme().onAccent : currentTheme().text));
}

void StripTools::showAll() {
  const auto tool = calipers_.drawing().tool();
  const auto& kinds = measurement::stripKinds();
  for (std::size_t n = 0; n < tools_.size(); ++n) tools_[n]->setChecked(tool == kinds[n]);
  if (tool != held_) showIcons();
  const auto& strip = calipers_.drawingIn(Where::strip);
  const auto* chosen = strip.shown().find(strip.selected());
  beatsRow_->setVisible(tool == CaliperKind::heartRate || (chosen != nullptr && chosen->caliper.kind == CaliperKind::heartRate));
  const QSignalBlocker quiet(beats_);
  beats_->setValue(calipers_.beats());
  setVisible(calipers_.hasStrip());
}

}  // namespace ew::ui
