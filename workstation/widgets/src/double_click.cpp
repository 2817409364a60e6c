#include "ew/widgets/double_click.h"

#include <QEvent>
#include <utility>

namespace ew {
namespace {

class DoubleClickFilter final : public QObject {
 public:
  DoubleClickFilter(QWidget* widget, std::function<void()> act) : QObject(widget), act_(std::move(act)) {
    widget->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    if (event->type() != QEvent::MouseButtonDblClick || !static_cast<QWidget*>(watched)->isEnabled()) return false;
    act_();
    return true;
  }

 private:
  std::function<void()> act_;
};

}  // namespace

void onDoubleClick(QWidget* widget, std::function<void()> act) { new DoubleClickFilter(widget, std::move(act)); }

}  // namespace ew
