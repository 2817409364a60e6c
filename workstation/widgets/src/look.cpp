#include "ew/widgets/look.h"

#include <QStyle>
#include <QVariant>
#include <QWidget>

namespace ew {
namespace {

/// As the style sheet writes it: [property="value"].
struct Hook {
  const char* property;
  const char* value;
};

Hook hookOf(Look look) {
  switch (look) {
    case Look::heading:
      return {"heading", "true"};
    case Look::quiet:
      return {"quiet", "true"};
    case Look::small:
      return {"small", "true"};
    case Look::primary:
      return {"primary", "true"};
    case Look::compact:
      return {"compact", "true"};
    case Look::flat:
      return {"flat", "true"};
    case Look::fold:
      return {"fold", "true"};
    case Look::listed:
      return {"listed", "true"};
    case Look::segment:
      return {"segment", "true"};
    case Look::firstOf:
      return {"segment", "first"};
    case Look::lastOf:
      return {"segment", "last"};
    case Look::onScan:
      return {"onScan", "true"};
    case Look::panels:
      return {"panels", "true"};
    case Look::lowPanels:
      return {"panels", "low"};
    case Look::edge:
      return {"edge", "true"};
    case Look::workspace:
      return {"workspace", "true"};
  }
  return {};
}

}  // namespace

bool hasLook(const QWidget* widget, Look look) {
  const Hook hook = hookOf(look);
  return widget->property(hook.property).toString() == QLatin1String(hook.value);
}

void setLook(QWidget* widget, Look look, bool is) {
  if (hasLook(widget, look) == is) return;
  const Hook hook = hookOf(look);
  widget->setProperty(hook.property, is ? QVariant(QLatin1String(hook.value)) : QVariant());
  if (!widget->testAttribute(Qt::WA_WState_Polished)) return;  // the sheet is read when it is first shown
  widget->style()->unpolish(widget);
  widget->style()->polish(widget);
}

}  // namespace ew
