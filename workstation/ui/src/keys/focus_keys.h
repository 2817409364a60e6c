#pragma once

#include <QObject>
#include <functional>

class QKeyEvent;
class QWidget;

namespace ew::ui {

/// Who gets a key:
///   a text field, a list or a choice with the focus: always that
///   a control that was reached with Tab: it has the keys that work it, Space and Return a button, arrows and Page Down a slider
///   a button that has its ring because the program put the focus there: Space and Return press it; the arrows drive the probe
///   after a click on anything else beside the scan: the arrows drive the probe, Space freezes; a clicked button keeps no ring, and
///   one that vanishes with its click hands it to none
class FocusKeys final : public QObject {
 public:
  using QObject::QObject;
  /// Whether a widget stands beside the views: in a panel, on the console, in the bars.
  std::function<bool(const QWidget&)> isBesideScan = [](const QWidget&) { return false; };
  /// What the key does in the scan. @return false: nothing
  std::function<bool(QKeyEvent&)> doInScan = [](QKeyEvent&) { return false; };
  /// Gives the focus to the scan.
  std::function<void()> backToScan = [] {};

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  enum class Way { byTab, byMouse, byProgram };
  [[nodiscard]] bool overrides(const QObject& watched, const QKeyEvent& key) const;
  [[nodiscard]] bool press(QWidget& watched, QKeyEvent& key);
  [[nodiscard]] bool wasHandedOn(const QWidget& widget, Qt::FocusReason reason) const;
  void backToScanFrom(QWidget& widget);

  bool isLastInputMouse_ = false;
  Way way_ = Way::byProgram;  ///< how the widget with the focus came to have it
};

}  // namespace ew::ui
