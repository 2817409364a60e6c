#include "window/layout/window_layout.h"

#include <algorithm>
#include <cmath>

namespace ew::ui {
namespace {

// Widths of body and scan together, and of the two alone, from which columns stand side by side.
constexpr int kBothForScanning_px = 880;
constexpr int kBothForMaking_px = 790;
constexpr int kBothAlone_px = 660;  // without panels
constexpr int kBothNarrow_px = 600;
constexpr int kBodyAlone_px = 240;
constexpr int kShortBelow_px = 600;  // height at 100 %, below which the console's own rows leave its pages no room

int scaledBy(double scale, int px) { return static_cast<int>(std::lround(scale * px)); }

class Arrangement {
 public:
  explicit Arrangement(const LayoutRequest& request) : request_(request) {
    made_.console_px = scaledBy(request.textScale, kConsoleWidth_px);
    // Large words may have two fifths of the window; the rest is the views'.
    made_.panel_px = std::max(request.panel_px, std::min(scaledBy(request.textScale, request.panel_px), request.width_px * 2 / 5));
    made_.isConsoleShort = request.height_px < scaledBy(request.textScale, kShortBelow_px);
  }

  WindowLayout made() {
    if (request_.isStaged) {
      made_.showsPanels = request_.hasPanels;
    } else if (request_.isScanOnly) {
      // nothing but the scan
    } else if (hasRoomForAll()) {
      made_.showsPanels = request_.hasPanels;
      made_.showsBody = request_.hasBody;
      made_.showsConsole = hasConsole();
    } else if (request_.hasPanels && request_.isForScanning && request_.hasBody && hasRoomForTwo()) {
      share({Column::panels, Column::body}, made_.panel_px);
      made_.showsConsole = hasConsole();
    } else if (request_.hasPanels && !request_.isForScanning && hasConsole() && hasRoomForTwo()) {
      share({Column::panels, Column::console}, std::max(made_.panel_px, made_.console_px));
      made_.showsBody = request_.hasBody;
    } else {
      shareAll();
    }
    return std::move(made_);
  }

 private:
  [[nodiscard]] bool hasConsole() const { return request_.hasConsole && request_.hasScan; }
  [[nodiscard]] int panels_px() const { return request_.hasPanels ? made_.panel_px : 0; }
  [[nodiscard]] int console_px() const { return hasConsole() ? made_.console_px : 0; }

  [[nodiscard]] bool hasRoomForAll() const {
    const int rest_px = request_.width_px - panels_px() - console_px();
    if (!request_.hasScan) return !request_.hasBody || rest_px >= kBodyAlone_px;
    if (!request_.hasBody) return rest_px >= kLeastScan_px;
    if (!request_.hasPanels || !hasConsole()) return rest_px >= (request_.hasPanels ? kBothNarrow_px : kBothAlone_px);
    return rest_px >= (request_.isForScanning ? kBothForScanning_px : kBothForMaking_px);
  }
  [[nodiscard]] bool hasRoomForTwo() const {
    if (request_.isForScanning) return request_.width_px - panels_px() - console_px() >= kLeastScan_px;
    return request_.width_px - std::max(panels_px(), console_px()) >= (request_.hasBody ? kBothNarrow_px : kLeastScan_px);
  }
  void share(std::vector<Column> tabs, int width_px) {
    made_.tabs = std::move(tabs);
    const auto asked = request_.front ? std::find(made_.tabs.begin(), made_.tabs.end(), *request_.front) : made_.tabs.end();
    made_.front = asked != made_.tabs.end() ? *asked : made_.tabs.front();
    for (const Column each : made_.tabs) {
      const bool isSeen = each == made_.front;
      switch (each) {
        case Column::panels:
          made_.showsPanels = isSeen;
          made_.panel_px = width_px;
          break;
        case Column::body:
          made_.showsBody = isSeen;
          made_.body_px = width_px;
          break;
        case Column::console:
          made_.showsConsole = isSeen;
          made_.console_px = width_px;
          made_.isConsoleAtLeft = true;
          break;
      }
    }
  }
  void shareAll() {
    std::vector<Column> all;
    if (hasConsole()) all.push_back(Column::console);
    if (request_.hasPanels) all.push_back(Column::panels);
    if (request_.hasBody) all.push_back(Column::body);
    // The console's width, which its words need; without one as much as leaves the scan its least.
    const int width_px = hasConsole()       ? made_.console_px
                         : request_.hasScan ? std::max(kBodyAlone_px, std::min(made_.panel_px, request_.width_px - kLeastScan_px))
                                            : made_.panel_px;
    if (!all.empty()) share(std::move(all), width_px);
    if (made_.tabs.size() < 2) made_.tabs.clear();
  }

  const LayoutRequest& request_;
  WindowLayout made_;
};

}  // namespace

WindowLayout layoutOf(const LayoutRequest& request) { return Arrangement(request).made(); }

FirstSize firstSizeOn(int width_px, int height_px) {
  constexpr int kFrame_px = 40;
  FirstSize size;
  size.isMaximised = width_px < size.width_px + kFrame_px || height_px < size.height_px + kFrame_px;
  size.width_px = std::min(size.width_px, width_px);
  size.height_px = std::min(size.height_px, height_px);
  return size;
}

TopBarLayout topBarOf(const TopBarRequest& request) {
  constexpr int kUsualTitle_px = 220, kBesideBrand_px = 16;
  const auto scaled = [&](int px) { return static_cast<int>(std::lround(px * request.textScale)); };
  TopBarLayout made;
  int needed_px = request.needed_px + 2 * kTitleGap_px;
  made.showsDisclaimer = needed_px + request.disclaimer_px + scaled(kReadableTitle_px) <= request.width_px;
  if (made.showsDisclaimer) needed_px += request.disclaimer_px;
  made.showsBrand = made.showsDisclaimer && needed_px + request.brand_px + kBesideBrand_px + scaled(kUsualTitle_px) <= request.width_px;
  return made;
}

}  // namespace ew::ui
