#pragma once

#include <QPointer>

#include "window/frame/feature.h"

class QMenu;

namespace ew::ui {

class ShortcutsOverlay;
class Tour;
enum class TourPlace;

/// The tour, the page of keys, and what the program says of itself.
class Help final : public Feature {
  Q_OBJECT

 public:
  using Feature::Feature;
  ~Help() override;

  void addMenu(QMenu& help);
  /// Shows the tour when nobody has seen it yet; it asks nothing and can be left at any moment.
  void offerTour();
  /// @return false: no tour is shown
  bool leaveTour();

 private:
  void beginTour();
  [[nodiscard]] bool goTo(TourPlace place);
  void showKeys();  ///< or hides them
  void showAbout();

  QPointer<Tour> tour_;
  QPointer<ShortcutsOverlay> keys_;
};

}  // namespace ew::ui
