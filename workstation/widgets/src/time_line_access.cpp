#include "time_line_access.h"

#include <QAccessibleWidget>

#include "ew/widgets/figures.h"
#include "ew/widgets/time_line.h"

namespace ew {
namespace {

class TimeLineAccess final : public QAccessibleWidget, public QAccessibleValueInterface {
 public:
  explicit TimeLineAccess(TimeLine& line) : QAccessibleWidget(&line, QAccessible::Slider), line_(line) {}

  void* interface_cast(QAccessible::InterfaceType type) override {
    return type == QAccessible::ValueInterface ? static_cast<QAccessibleValueInterface*>(this) : QAccessibleWidget::interface_cast(type);
  }
  [[nodiscard]] QString text(QAccessible::Text of) const override {
    return of == QAccessible::Value ? TimeLine::tr("%1 of %2 s")
                                          .arg(figure(line_.position_s() - line_.first_s(), 1), figure(line_.last_s() - line_.first_s(), 1))
                                    : QAccessibleWidget::text(of);
  }
  [[nodiscard]] QVariant currentValue() const override { return line_.position_s(); }
  void setCurrentValue(const QVariant& value) override { line_.moveTo(value.toDouble()); }
  [[nodiscard]] QVariant maximumValue() const override { return line_.last_s(); }
  [[nodiscard]] QVariant minimumValue() const override { return line_.first_s(); }
  [[nodiscard]] QVariant minimumStepSize() const override { return 1.0; }

 private:
  TimeLine& line_;
};

QAccessibleInterface* accessOf(const QString&, QObject* object) {
  auto* line = qobject_cast<TimeLine*>(object);
  return line != nullptr ? new TimeLineAccess(*line) : nullptr;
}

}  // namespace

void describeTimeLines() {
  static const bool once = [] {
    QAccessible::installFactory(accessOf);
    return true;
  }();
  static_cast<void>(once);
}

}  // namespace ew
