#include "ew/ui_test_door/window_layout.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ew::ui::window_layout_test {
namespace {

constexpr int kBars_px = 84;  // top bar and status line, at 100 %

LayoutRequest scanning(int width_px, int height_px, int percent) {
  LayoutRequest asked;
  asked.width_px = width_px;
  asked.height_px = height_px - kBars_px * percent / 100;
  asked.textScale = percent / 100.0;
  asked.hasPanels = true;
  return asked;
}

LayoutRequest making(int width_px, int height_px, int percent) {
  LayoutRequest asked = scanning(width_px, height_px, percent);
  asked.isForScanning = false;
  asked.panel_px = 400;
  return asked;
}

bool isShown(const WindowLayout& layout, Column column) {
  switch (column) {
    case Column::panels:
      return layout.showsPanels;
    case Column::body:
      return layout.showsBody;
    case Column::console:
      return layout.showsConsole;
  }
  return false;
}

bool hasTab(const WindowLayout& layout, Column column) {
  return std::find(layout.tabs.begin(), layout.tabs.end(), column) != layout.tabs.end();
}

/// What is left for scan and, where it is a share of the rest, body.
int rest_px(const LayoutRequest& asked, const WindowLayout& layout) {
  return asked.width_px - (layout.showsPanels ? layout.panel_px : 0) - (layout.showsConsole ? layout.console_px : 0) -
         (layout.showsBody ? layout.body_px : 0);
}

template <class Check>
void forEveryWindow(const Check& check) {
  for (const auto& [width_px, height_px] :
       {std::pair{1024, 640}, {1280, 720}, {1366, 768}, {1440, 900}, {1600, 900}, {1920, 1080}, {3840, 2160}})
    for (const int percent : {100, 125, 150, 175, 200})
      for (const bool isForScanning : {true, false})
        for (const bool hasPanels : {true, false})
          for (const auto front :
               {std::optional<Column>(), std::optional(Column::panels), std::optional(Column::body), std::optional(Column::console)}) {
            LayoutRequest asked = isForScanning ? scanning(width_px, height_px, percent) : making(width_px, height_px, percent);
            asked.hasPanels = hasPanels;
            asked.front = front;
            SCOPED_TRACE(testing::Message() << width_px << " x " << height_px << " at " << percent << " %, scanning " << isForScanning
                                            << ", panels " << hasPanels << ", front " << (front ? static_cast<int>(*front) : -1));
            check(asked, layoutOf(asked));
          }
}

TEST(WindowLayout, ShowsEveryColumnOrATabThatLeadsToIt) {
  forEveryWindow([](const LayoutRequest& asked, const WindowLayout& layout) {
    for (const Column each : {Column::panels, Column::body, Column::console}) {
      const bool isWanted = each != Column::panels || asked.hasPanels;
      EXPECT_EQ(isShown(layout, each) || hasTab(layout, each), isWanted) << static_cast<int>(each);
    }
    EXPECT_NE(layout.tabs.size(), 1u) << "a single tab leads nowhere";
    if (asked.front && hasTab(layout, *asked.front)) {
      EXPECT_TRUE(isShown(layout, *asked.front));
    }
    EXPECT_EQ(std::count_if(layout.tabs.begin(), layout.tabs.end(), [&](Column each) { return isShown(layout, each); }),
              layout.tabs.empty() ? 0 : 1);
  });
}

TEST(WindowLayout, LeavesTheScanItsLeastWidth) {
  forEveryWindow([](const LayoutRequest& asked, const WindowLayout& layout) {
    const int left_px = rest_px(asked, layout);
    const bool isShared = layout.showsBody && layout.body_px == 0;
    EXPECT_GE(isShared ? left_px * 2 / 3 : left_px, isShared ? 390 : kLeastScan_px);
  });
}

TEST(WindowLayout, LetsTheConsoleGoLastWhereOneScans) {
  forEveryWindow([](const LayoutRequest& asked, const WindowLayout& layout) {
    if (!asked.isForScanning) return;
    // As soon as anything else takes turns with the console, everything does; and unasked it is the console that is seen.
    if (hasTab(layout, Column::console)) {
      EXPECT_EQ(layout.tabs.size(), asked.hasPanels ? 3u : 2u);
    }
    if (!asked.front) {
      EXPECT_TRUE(layout.showsConsole);
    }
  });
}

TEST(WindowLayout, IsTheOneThatIsMeantAtTheSizesOfLaptops) {
  const auto seen = [](const LayoutRequest& asked) {
    const WindowLayout layout = layoutOf(asked);
    return std::tuple(layout.showsPanels, layout.showsBody, layout.showsConsole, layout.tabs.size());
  };
  using All = std::tuple<bool, bool, bool, std::size_t>;
  EXPECT_EQ(seen(scanning(1440, 900, 100)), All(true, true, true, 0u));
  EXPECT_EQ(seen(scanning(1366, 768, 100)), All(true, false, true, 2u));
  EXPECT_EQ(seen(scanning(1280, 720, 150)), All(true, false, true, 2u));
  EXPECT_EQ(seen(scanning(1024, 640, 100)), All(true, false, true, 2u));
  EXPECT_EQ(seen(scanning(1024, 640, 200)), All(false, false, true, 3u));
  EXPECT_EQ(seen(scanning(1440, 900, 200)), All(false, false, true, 3u));
  EXPECT_EQ(seen(scanning(1920, 1080, 150)), All(true, true, true, 0u));
  EXPECT_EQ(seen(making(1440, 900, 100)), All(true, true, true, 0u));
  EXPECT_EQ(seen(making(1280, 720, 100)), All(true, true, false, 2u)) << "where something is made the body is worked with";
}

TEST(WindowLayout, KeepsTheScanWhereItIsWhenColumnsTakeTurns) {
  forEveryWindow([](const LayoutRequest& asked, const WindowLayout& layout) {
    LayoutRequest other = asked;
    for (const Column each : layout.tabs) {
      other.front = each;
      EXPECT_EQ(rest_px(other, layoutOf(other)), rest_px(asked, layout));
      EXPECT_EQ(layoutOf(other).tabs, layout.tabs);
    }
  });
}

TEST(WindowLayout, ShowsNothingButTheScanOrTheStageWhereThatIsAsked) {
  LayoutRequest asked = scanning(1920, 1080, 100);
  asked.isScanOnly = true;
  WindowLayout layout = layoutOf(asked);
  EXPECT_FALSE(layout.showsPanels || layout.showsBody || layout.showsConsole);
  asked = making(1024, 640, 100);
  asked.isStaged = true;
  layout = layoutOf(asked);
  EXPECT_TRUE(layout.showsPanels && !layout.showsBody && !layout.showsConsole);
}

TEST(WindowLayout, IsNoLargerThanTheScreenWhenItIsFirstSeen) {
  EXPECT_EQ(firstSizeOn(1920, 1040), (FirstSize{1600, 900, false}));
  EXPECT_EQ(firstSizeOn(1366, 728), (FirstSize{1366, 728, true}));
  EXPECT_EQ(firstSizeOn(1600, 900), (FirstSize{1600, 900, true})) << "its frame has no room";
  EXPECT_EQ(firstSizeOn(1920, 800), (FirstSize{1600, 800, true}));
}

TEST(WindowLayout, ShortensTheConsoleInALowWindow) {
  EXPECT_FALSE(layoutOf(scanning(1280, 720, 100)).isConsoleShort);
  EXPECT_TRUE(layoutOf(scanning(1024, 640, 100)).isConsoleShort);
  EXPECT_TRUE(layoutOf(scanning(1440, 900, 200)).isConsoleShort);
}

TEST(TopBarLayout, LetsTheProgramsNameAndTheDisclaimerGiveWayToWhatIsOpen) {
  // German with three workspaces at 1024: the title has 160 px and 24 at either side.
  EXPECT_EQ(topBarOf({1024, 660, 170, 90, 1.0}), (TopBarLayout{false, false}));
  EXPECT_EQ(topBarOf({1037, 660, 170, 90, 1.0}), (TopBarLayout{false, false})) << "the name goes first";
  EXPECT_EQ(topBarOf({1038, 660, 170, 90, 1.0}), (TopBarLayout{true, false}));
  EXPECT_EQ(topBarOf({1203, 660, 170, 90, 1.0}), (TopBarLayout{true, false}));
  EXPECT_EQ(topBarOf({1204, 660, 170, 90, 1.0}), (TopBarLayout{true, true}));
  EXPECT_EQ(topBarOf({1300, 660, 170, 90, 2.0}), (TopBarLayout{true, false})) << "larger words";
}

}  // namespace
}  // namespace ew::ui::window_layout_test
