#pragma once

#include <QObject>
#include <string>

class QWidget;

namespace ew::ui {

class KeyMap;

/// A tip that names keys: tipWithKeys(tr("Depth of the image (%1)"), "depth.less | depth.more"). Where the commands have no key, the
/// brackets go. The tip is a pattern until a KeyTips of the window fills it in.
[[nodiscard]] QString tipWithKeys(const QString& tip, const std::string& commands);

/// Fills in the keys of every tip that is set, and again when keys change.
class KeyTips final : public QObject {
  Q_OBJECT

 public:
  explicit KeyTips(const KeyMap& keys);

  /// A pattern with its keys; any other text as it is.
  [[nodiscard]] QString filledIn(const QString& pattern) const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void show(QWidget& widget, const QString& pattern);
  void showAll();

  const KeyMap& keys_;
  bool isShowing_ = false;
};

}  // namespace ew::ui
