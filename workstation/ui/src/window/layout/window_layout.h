#pragma once

#include <optional>
#include <vector>

namespace ew::ui {

/// The columns beside the scan.
enum class Column { panels, body, console };

/// What has to find room, and how much there is.
struct LayoutRequest {
  int width_px = 0;        ///< of the window
  int height_px = 0;       ///< between its top bar and its status line
  double textScale = 1.0;  ///< 1 at 100 %
  bool hasPanels = false;  ///< lessons, or what an author works with
  bool hasBody = true;     ///< 3D view and case
  bool hasScan = true;
  bool hasConsole = true;
  int panel_px = 304;         ///< what the panels want at 100 %
  bool isForScanning = true;  ///< the console is wanted more than the body; where something is made or judged it is the other way round
  bool isStaged = false;      ///< the panel has brought views of its own
  bool isScanOnly = false;
  std::optional<Column> front = {};  ///< the one the user asked for, where columns have to share their room
};

/// What is shown where.
struct WindowLayout {
  bool showsPanels = false, showsBody = false, showsConsole = false;
  std::vector<Column> tabs;       ///< columns that share one place, one of them is seen; fewer than two: none do
  Column front = Column::panels;  ///< of the tabs, the one that is seen
  bool isConsoleAtLeft = false;   ///< where the other columns are, because it takes turns with them
  bool isConsoleShort = false;    ///< what is needed least scrolls with its first page
  int panel_px = 0;               ///< width of the panels
  int body_px = 0;                ///< of the body; 0: a share of what is left, the user's choice
  int console_px = 0;
  bool operator==(const WindowLayout&) const = default;
};

/// Who scans has the console at any size: lessons and body take turns first, and only where not even two columns leave the scan its least
/// width all three do. What takes turns has a tab, so nothing is ever without a handle.
[[nodiscard]] WindowLayout layoutOf(const LayoutRequest& request);

/// Of a window that nobody has sized yet.
struct FirstSize {
  int width_px = 1600, height_px = 900;
  bool isMaximised = false;
  bool operator==(const FirstSize&) const = default;
};
/// The usual one, or all of a screen that has no room for it and its frame: the console stands at the window's edge, and must not lie
/// beyond the screen's. @param width_px, height_px of the screen, without its bars
[[nodiscard]] FirstSize firstSizeOn(int width_px, int height_px);

/// What of the top bar gives way in a narrow window.
struct TopBarRequest {
  int width_px = 0;
  int needed_px = 0;       ///< of workspaces and menus, which stay
  int disclaimer_px = 0;   ///< of what every saved image says as well
  int brand_px = 0;        ///< of the program's name, which the window has as well
  double textScale = 1.0;  ///< 1 at 100 %
};
struct TopBarLayout {
  bool showsDisclaimer = false, showsBrand = false;
  bool operator==(const TopBarLayout&) const = default;
};
/// What is open keeps the room of a title that can be read, whichever it is: nothing moves when another case is opened.
[[nodiscard]] TopBarLayout topBarOf(const TopBarRequest& request);

inline constexpr int kTitleGap_px = 24;        ///< beside the title of what is open
inline constexpr int kReadableTitle_px = 160;  ///< of it, at 100 %
inline constexpr int kConsoleWidth_px = 248;   ///< at 100 %
inline constexpr int kLeastScan_px = 420;      ///< an image narrower than this teaches nothing, whatever the size of the words

}  // namespace ew::ui
