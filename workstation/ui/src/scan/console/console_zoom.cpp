// Below the zoom: a box, the whole image, and the wide image.
#include <QBoxLayout>
#include <QPushButton>

#include "ew/widgets/look.h"
#include "keys/key_tips.h"
#include "scan/console/console_panel.h"

namespace ew::ui {

void ConsolePanel::addZoomButtons(QVBoxLayout* rows) {
  auto* line = new QHBoxLayout;
  line->setContentsMargins(0, 4, 0, 6);
  line->setSpacing(4);
  const auto add = [&](const QString& text, const char* name, const QString& tip) {
    auto* button = new QPushButton(text);
    button->setObjectName(QLatin1String(name));
    button->setToolTip(tip);
    button->setAccessibleName(text);
    setLook(button, Look::compact);
    button->setFocusPolicy(Qt::TabFocus);
    line->addWidget(button, 1);
    return button;
  };
  QPushButton* box = add(tr("Box"), "boxZoomButton", tipWithKeys(tr("Drag a box that fills the image then (%1)"), "zoom.box"));
  QPushButton* whole = add(tr("Whole"), "wholeImage", tipWithKeys(tr("The whole image again (%1)"), "zoom.whole"));
  QPushButton* wide =
      add(tr("Wide"), "wideButton", tipWithKeys(tr("A wide image grows while the probe slides along its image (%1)"), "wide"));
  rows->addLayout(line);
  connect(box, &QPushButton::clicked, this, &ConsolePanel::boxZoomAsked);
  connect(wide, &QPushButton::clicked, this, &ConsolePanel::wideAsked);
  connect(whole, &QPushButton::clicked, this, [this] { session_.console().setDetail(1.0, {}); });
  shows_.emplace_back([this, whole] { whole->setEnabled(session_.console().knobs().zoom > 1.0); });
}

}  // namespace ew::ui
