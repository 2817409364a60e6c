#pragma once

#include <QTimer>
#include <memory>

#include "window/frame/feature.h"

class QKeyEvent;
class QMenu;

namespace ew {
struct Volume;
}

namespace ew::ui {

/// The body with the probe on it: what it shows of the scan, where the skin has data, and the keys that move the probe from wherever the
/// focus is.
class BodyAndProbe final : public Feature {
  Q_OBJECT

 public:
  explicit BodyAndProbe(WindowParts& parts);
  ~BodyAndProbe() override;

  void addLooks(QMenu& view);  ///< from the front, from the head ...
  void connectParts() override;
  void restyle() override;

  /// The keys that move the probe and step through a frozen scan. @return false: it is none, or the scan is not in front
  bool doKey(QKeyEvent& event);

 private:
  void connectKeys();
  void showImage();
  void bringFan();
  void paintOver();
  void showCoverage();
  void showCoverageSoon();
  void sayWhyItRests();

  QTimer coverageSoon_;                     ///< runs out when what is scanned is not moved any more
  std::weak_ptr<const Volume> coverageOf_;  ///< whose tint the skin has
};

}  // namespace ew::ui
