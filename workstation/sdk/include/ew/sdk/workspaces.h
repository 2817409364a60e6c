#pragma once

#include <string>

namespace ew::sdk {

/// A way of working that a plugin brings, beside Explore and Author at the top of the window. Its panels name it (StagePanel::workspace).
struct Workspace {
  std::string id;            ///< letters, digits, '-' and '_'; "explore" and "author" are the program's own
  std::string title;         ///< a word or two, on the button
  std::string tip = {};      ///< what one does here, a short sentence
  std::string icon = {};     ///< an SVG of 24 x 24 whose strokes are "currentColor", drawn in the theme's colours; empty: none
  bool keepsBody = true;     ///< the 3D view stays beside the panels
  bool keepsScan = true;     ///< the scan stays
  bool keepsConsole = true;  ///< the console stays, where the window is wide enough; only with the scan
  bool operator==(const Workspace&) const = default;
};

class Workspaces {
 public:
  virtual ~Workspaces();
  /// Adds a button to the window's switch and a key, the next free one of Ctrl+3 … Ctrl+9. An id that is taken is refused with a warning in
  /// the log. Without a window nothing happens.
  virtual void add(const Workspace& workspace) = 0;
  /// Brings a workspace to the front. One that is not there changes nothing.
  virtual void show(const std::string& id) = 0;
  /// The id of the one in front; "" without a window.
  [[nodiscard]] virtual std::string shown() const = 0;
};

}  // namespace ew::sdk
