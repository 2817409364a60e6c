#include "ew/ui_test_door/mark_place.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace ew::ui::mark_place_test {
namespace {

constexpr int kUpperLeft = 0, kUpperRight = 1, kLowerLeft = 2, kLowerRight = 3;
constexpr int kMost_px = 96, kLeast_px = 48;

const QRect kRoom(10, 50, 400, 300);  // x 10..409, y 50..349

QRect place(const std::vector<QRect>& taken, int corner) { return placeOfMark(kRoom, taken, corner, kMost_px, kLeast_px); }

bool isFree(const QRect& square, const std::vector<QRect>& taken) {
  return std::none_of(taken.begin(), taken.end(), [&](const QRect& each) { return square.intersects(each); });
}

/// A convex fan: narrow at the top, as wide as the image below.
Spans convexFan(int rows, int columns) {
  Spans spans(static_cast<std::size_t>(rows));
  for (int row = 0; row < rows; ++row) {
    const int half = columns / 8 + (columns / 2 - columns / 8) * row / (rows - 1);
    spans[static_cast<std::size_t>(row)] = {{columns / 2 - half, columns / 2 + half}};
  }
  return spans;
}

TEST(PlaceOfMark, IsTheChosenCornerWhileNothingLiesThere) {
  EXPECT_EQ(place({}, kUpperLeft), QRect(10, 50, 96, 96));
  EXPECT_EQ(place({}, kUpperRight), QRect(314, 50, 96, 96));
  EXPECT_EQ(place({}, kLowerLeft), QRect(10, 254, 96, 96));
  EXPECT_EQ(place({}, kLowerRight), QRect(314, 254, 96, 96));
}

TEST(PlaceOfMark, GoesToTheCornerAboveWhenTheFanReachesIntoItsOwn) {
  const std::vector<QRect> taken{QRect(10, 250, 400, 100)};  // the lower corners
  EXPECT_EQ(place(taken, kLowerLeft), QRect(10, 50, 96, 96));
  EXPECT_EQ(place(taken, kLowerRight), QRect(314, 50, 96, 96));
}

TEST(PlaceOfMark, GoesToTheOtherSideWhenItsOwnIsCovered) {
  const std::vector<QRect> taken{QRect(10, 50, 300, 300)};
  EXPECT_EQ(place(taken, kLowerLeft), QRect(314, 254, 96, 96));
  EXPECT_EQ(place(taken, kUpperLeft), QRect(314, 50, 96, 96));
}

TEST(PlaceOfMark, BecomesSmallerWhereNoCornerHasRoomForAllOfIt) {
  const std::vector<QRect> taken{QRect(90, 50, 240, 300)};  // 80 px are left at either side
  EXPECT_EQ(place(taken, kLowerRight), QRect(330, 270, 80, 80));
  EXPECT_EQ(place(taken, kUpperLeft), QRect(10, 50, 80, 80));
}

TEST(PlaceOfMark, CoversAsLittleAsItCanWhereNothingIsFree) {
  const std::vector<QRect> taken{QRect(10, 50, 370, 300)};  // 30 px are left at the right
  EXPECT_EQ(place(taken, kLowerLeft), QRect(362, 302, 48, 48));
}

TEST(PlaceOfMark, StaysBesideAStripBelowTheImage) {
  const std::vector<QRect> taken{QRect(110, 50, 200, 150), QRect(10, 210, 400, 140)};
  for (const int corner : {kUpperLeft, kUpperRight, kLowerLeft, kLowerRight}) {
    const QRect square = place(taken, corner);
    EXPECT_TRUE(isFree(square, taken)) << corner;
    EXPECT_EQ(square.width(), 96) << corner;
  }
}

TEST(PlaceOfMark, LiesBesideAConvexFanWhateverCornerWasChosen) {
  const std::vector<QRect> taken = rectsOfFan(convexFan(300, 400), kRoom.topLeft(), 1.0);
  for (const int corner : {kUpperLeft, kUpperRight, kLowerLeft, kLowerRight}) {
    const QRect square = place(taken, corner);
    EXPECT_TRUE(isFree(square, taken)) << corner;
    EXPECT_TRUE(kRoom.contains(square)) << corner;
  }
}

TEST(RectsOfFan, CoverEveryPixelOfTheFan) {
  const Spans fan = convexFan(101, 80);
  const std::vector<QRect> rects = rectsOfFan(fan, {7, 11}, 1.0);
  for (int row = 0; row < 101; ++row) {
    for (const RowSpan& run : fan[static_cast<std::size_t>(row)]) {
      for (const int column : {run.begin, run.end - 1}) {
        const QPoint pixel(7 + column, 11 + row);
        EXPECT_TRUE(std::any_of(rects.begin(), rects.end(), [&](const QRect& each) { return each.contains(pixel); }))
            << row << ", " << column;
      }
    }
  }
}

TEST(RectsOfFan, AreThoseOfTheWidgetOnAScreenOfFinePixels) {
  const Spans fan(8, {{20, 41}});
  EXPECT_EQ(rectsOfFan(fan, {100, 200}, 2.0), (std::vector<QRect>{QRect(110, 200, 11, 4)}));
}

TEST(RectsOfFan, LeaveOutRowsWithoutFan) {
  Spans fan(16);
  fan[12] = {{3, 5}};
  EXPECT_EQ(rectsOfFan(fan, {0, 0}, 1.0), (std::vector<QRect>{QRect(3, 8, 2, 8)}));
  EXPECT_TRUE(rectsOfFan({}, {0, 0}, 1.0).empty());
}

}  // namespace
}  // namespace ew::ui::mark_place_test
