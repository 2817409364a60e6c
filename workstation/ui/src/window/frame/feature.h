#pragma once

#include <QObject>

namespace ew::ui {

class UnsavedWork;
struct WindowParts;

/// One subject of the window: its entries of menus, who it listens to, what it shows of the present state, and what of it could be lost.
/// The window makes all features, then their menus (menus.h says where each entry stands), then connects them; what one feature needs of
/// another it calls by name through the parts. A feature lives as long as the window, and its dialogs no longer than the feature.
class Feature : public QObject {
 public:
  explicit Feature(WindowParts& parts) : parts_(parts) {}

  /// Listens to the parts of the window. All features are there, and all entries of menus.
  virtual void connectParts() {}
  /// Shows the present state: what is open and scanned, who is in front, whether the library is locked. Called through
  /// WindowParts::refresh() whenever one of those changed; calls nothing that calls it again.
  virtual void refresh() {}
  /// Adds what a person can lose here to the one list that every way to lose something asks.
  virtual void holdUnsavedWork(UnsavedWork&) {}
  /// The theme or the size of words changed.
  virtual void restyle() {}

 protected:
  WindowParts& parts_;
};

}  // namespace ew::ui
