#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "counted_stop.h"
#include "ew/stitching/equalise_views.h"
#include "stitching/views.h"

/// Views that are hard to join, and what must come of them: see resources/docs/science/hard-cases.md.
namespace ew::stitching::stitching_test {
namespace {

constexpr SeamMethod kMethods[] = {SeamMethod::feather, SeamMethod::nearest, SeamMethod::graphCut};

Result<JoinResult> joined(const std::vector<View>& views, const JoinOptions& options, Progress& progress = noProgress()) {
  const Grid grid = gridFor(views, options.grid);
  auto seams = findSeams(views, grid, options.seam, progress);
  if (!seams) return passOn(seams.error());
  return join(views, *seams, grid, options, progress);
}
JoinOptions by(SeamMethod method, std::vector<SeamStroke> strokes = {}) {
  JoinOptions options;
  options.seam.method = method;
  options.seam.strokes = std::move(strokes);
  return options;
}

TEST(HardStitching, OneViewOnlyPassesThroughUnchanged) {
  const Volume only = speckled(gridOf({40, 30, 20}), 1);
  for (const SeamMethod method : kMethods) {
    const auto result = joined({viewOf(only, "only")}, by(method));
    ASSERT_TRUE(result);
    EXPECT_EQ(result->volume.echo, only.echo);
    EXPECT_EQ(result->report.seam.voxels, 0u);
    EXPECT_EQ(result->report.seam.derivativeRatio, 1.0);
  }
}

TEST(HardStitching, ViewsThatDoNotTouchAreBothKeptAndItIsSaid) {
  const Volume a = constant(gridOf({20, 20, 20}), 70);
  const Volume b = constant(gridOf({20, 20, 20}), 90);
  for (const SeamMethod method : kMethods) {
    const auto result = joined({viewOf(a, "a"), viewOf(b, "b", moved(60, 0, 0))}, by(method));
    ASSERT_TRUE(result);
    EXPECT_EQ(result->report.contributions[0].voxels, 8000u);
    EXPECT_EQ(result->report.contributions[1].voxels, 8000u);
    ASSERT_EQ(result->report.notes.size(), 1u);
    EXPECT_NE(result->report.notes.front().english().find("do not overlap"), std::string::npos);
    for (std::size_t v = 0; v < result->volume.echo.size(); ++v)
      ASSERT_EQ(result->volume.echo[v], result->source[v] == 0 ? 0 : result->source[v] == 1 ? 70 : 90);
  }
  const std::vector<View> views = {viewOf(a, "a"), viewOf(b, "b", moved(60, 0, 0))};
  const auto equalised = equaliseViews(views, {}, noProgress());
  ASSERT_TRUE(equalised);
  EXPECT_EQ(equalised->groups, 2);
  EXPECT_EQ(equalised->notes.size(), 2u);
  for (const GreyCorrection& correction : equalised->corrections) EXPECT_TRUE(correction.grey.empty());
}

TEST(HardStitching, IdenticalViewsGiveTheViewItself) {
  const Volume one = speckled(gridOf({40, 36, 30}), 3);
  const Volume same = one;
  for (const SeamMethod method : kMethods) {
    const auto result = joined({viewOf(one, "a"), viewOf(same, "b"), viewOf(same, "c")}, by(method));
    ASSERT_TRUE(result);
    EXPECT_EQ(result->volume.echo, one.echo);
    EXPECT_EQ(result->report.disagreementRms, 0.0);
  }
}

TEST(HardStitching, AViewInsideAnotherIsJoinedWithoutAHole) {
  const Volume outer = speckled(gridOf({60, 60, 60}), 4);
  const Volume inner = speckled(gridOf({20, 20, 20}), 5);
  for (const SeamMethod method : kMethods) {
    const auto result = joined({viewOf(outer, "outer"), viewOf(inner, "inner", moved(20.3, 20.1, 19.8))}, by(method));
    ASSERT_TRUE(result);
    EXPECT_EQ(std::count(result->source.begin(), result->source.end(), 0), 0);
  }
  // A stroke brings the inner one to light.
  const auto painted =
      joined({viewOf(outer, "outer"), viewOf(inner, "inner", moved(20, 20, 20))}, by(SeamMethod::graphCut, {{1, {29.5, 29.5, 29.5}, 6.0}}));
  ASSERT_TRUE(painted);
  EXPECT_EQ(painted->source[painted->volume.grid.indexOf(29, 29, 29)], 2);
}

TEST(HardStitching, ViewsOneVoxelThickAreJoined) {
  for (const glm::ivec3 dims : {glm::ivec3(40, 40, 1), glm::ivec3(1, 40, 40), glm::ivec3(40, 1, 1), glm::ivec3(1, 1, 1)}) {
    const Volume a = speckled(gridOf(dims), 6);
    const Volume b = speckled(gridOf(dims), 7);
    for (const SeamMethod method : kMethods) {
      const auto result = joined({viewOf(a, "a"), viewOf(b, "b", moved(dims.x > 1 ? 20 : 0, 0, 0))}, by(method));
      ASSERT_TRUE(result);
      EXPECT_EQ(std::count(result->source.begin(), result->source.end(), 0), 0);
      if (dims.x > 1) {
        EXPECT_EQ(result->volume.echo.front(), a.echo.front());
      }
    }
  }
}

TEST(HardStitching, ConstantAndSaturatedViewsStayWhatTheyAre) {
  for (const int level : {0, 1, 128, 255}) {
    const Volume a = constant(gridOf({40, 30, 30}), level);
    const Volume b = constant(gridOf({40, 30, 30}), level);
    for (const SeamMethod method : kMethods) {
      const auto result = joined({viewOf(a, "a"), viewOf(b, "b", moved(17.3, 2.2, 1.1))}, by(method));
      ASSERT_TRUE(result);
      for (std::size_t v = 0; v < result->volume.echo.size(); ++v) ASSERT_EQ(result->volume.echo[v], result->source[v] == 0 ? 0 : level);
      EXPECT_TRUE(std::isfinite(result->report.seam.derivativeRatio));
      EXPECT_EQ(result->report.seam.meanStep_db, 0.0);
    }
    // Cut-off levels say nothing about gain; equal ones say that there is nothing to correct.
    const std::vector<View> views = {viewOf(a, "a"), viewOf(b, "b", moved(17.3, 2.2, 1.1))};
    const auto equalised = equaliseViews(views, {}, noProgress());
    ASSERT_TRUE(equalised);
    for (const GreyCorrection& correction : equalised->corrections)
      for (const double grey : correction.grey) EXPECT_NEAR(grey, 0.0, 1e-9);
    EXPECT_EQ(equalised->groups, level == 0 || level == 255 ? 2 : 1);
  }
}

TEST(HardStitching, ViewsNobodyTrustsAreStillShown) {
  const Volume a = constant(gridOf({40, 30, 30}), 50);
  const Volume b = constant(gridOf({40, 30, 30}), 60);
  const std::vector<std::uint8_t> none(a.echo.size(), 0);
  std::vector<View> views = {viewOf(a, "a"), viewOf(b, "b", moved(20, 0, 0))};
  views[0].confidence = none;
  views[1].confidence = none;
  for (const SeamMethod method : kMethods) {
    const auto result = joined(views, by(method));
    ASSERT_TRUE(result);
    EXPECT_EQ(std::count(result->source.begin(), result->source.end(), 0), 0);
    const auto echo = std::minmax_element(result->volume.echo.begin(), result->volume.echo.end());
    EXPECT_EQ(*echo.first, 50);
    EXPECT_EQ(*echo.second, 60);
  }
}

TEST(HardStitching, AViewWithoutConfidenceGivesWayEverywhereAnotherCovers) {
  const Volume a = constant(gridOf({40, 30, 30}), 50);
  const Volume b = constant(gridOf({40, 30, 30}), 200);
  const std::vector<std::uint8_t> none(a.echo.size(), 0);
  std::vector<View> views = {viewOf(a, "a"), viewOf(b, "b", moved(20, 0, 0))};
  views[0].confidence = none;
  const auto result = joined(views, by(SeamMethod::graphCut));
  ASSERT_TRUE(result);
  for (int i = 24; i < 60; ++i) EXPECT_EQ(result->volume.echo[result->volume.grid.indexOf(i, 15, 15)], 200) << i;
}

TEST(HardStitching, StrokesOutsideAllViewsChangeNothing) {
  const Volume a = speckled(gridOf({40, 30, 30}), 8);
  const Volume b = speckled(gridOf({40, 30, 30}), 9);
  const std::vector<View> views = {viewOf(a, "a"), viewOf(b, "b", moved(20, 0, 0))};
  const auto plain = joined(views, by(SeamMethod::graphCut));
  const auto painted = joined(views, by(SeamMethod::graphCut, {{0, {500, 0, 0}, 20.0}, {1, {-1e9, 0, 0}, 5.0}, {1, {2, 2, 2}, 1.5}}));
  ASSERT_TRUE(plain && painted);
  EXPECT_EQ(plain->volume, painted->volume);
  for (const SeamStroke& wrong : {SeamStroke{2, {0, 0, 0}, 5.0}, SeamStroke{0, {std::nan(""), 0, 0}, 5.0}, SeamStroke{0, {0, 0, 0}, 0.0}}) {
    const auto refused = joined(views, by(SeamMethod::graphCut, {wrong}));
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().code, ErrorCode::badField);
  }
}

TEST(HardStitching, MoreViewsThanASourceCanNameAreRefusedWithTheLimit) {
  const Volume tiny = constant(gridOf({2, 2, 2}), 9);
  std::vector<View> views;
  for (int n = 0; n < 255; ++n) views.push_back(viewOf(tiny, "v", moved(n, 0, 0)));
  for (const SeamMethod method : kMethods) EXPECT_TRUE(joined(views, by(method)));
  views.push_back(viewOf(tiny, "one too many", moved(255, 0, 0)));
  const auto refused = findSeams(views, tiny.grid, {}, noProgress());
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("255"), std::string::npos);
  EXPECT_FALSE(equaliseViews(views, {}, noProgress()));
  EXPECT_EQ(findSeams({}, tiny.grid, {}, noProgress()).error().code, ErrorCode::emptyVolume);
}

TEST(HardStitching, NumbersThatAreNoneAreRefusedByName) {
  const Volume one = constant(gridOf({8, 8, 8}), 9);
  const auto refusal = [&](const View& view) {
    const std::vector<View> views = {view};
    const auto seams = findSeams(views, one.grid, {}, noProgress());
    EXPECT_FALSE(seams);
    return seams ? Error{} : seams.error();
  };
  View view = viewOf(one, "left lobe");
  view.correction.grey = {1.0, std::nan("")};
  EXPECT_NE(refusal(view).sentence().find("left lobe"), std::string::npos);
  view = viewOf(one, "left lobe");
  registration::ControlGrid warp{gridOf({2, 2, 2}), std::vector<glm::vec3>(8, glm::vec3(0.0F))};
  warp.displacement_mm[3].y = std::numeric_limits<float>::infinity();
  view.warp = &warp;
  EXPECT_EQ(refusal(view).code, ErrorCode::badField);
  warp.displacement_mm.resize(5);
  EXPECT_EQ(refusal(view).code, ErrorCode::badField);
  view = viewOf(one, "left lobe", glm::scale(glm::dmat4(1.0), glm::dvec3(2.0)));
  EXPECT_EQ(refusal(view).code, ErrorCode::notRigid);
  for (const auto& [cell_mm, blend_mm] :
       {std::pair{0.0, 2.5}, std::pair{std::nan(""), 2.5}, std::pair{1.5, -1.0}, std::pair{1.5, std::nan("")}}) {
    JoinOptions options;
    options.seam.cell_mm = cell_mm;
    options.seam.blend_mm = blend_mm;
    EXPECT_EQ(joined({viewOf(one, "a")}, options).error().code, ErrorCode::badField);
  }
}

TEST(HardStitching, ABendThatCarriesAViewAwayLeavesNothingOfIt) {
  const Volume one = constant(gridOf({20, 20, 20}), 9);
  registration::ControlGrid warp{gridOf({2, 2, 2}, {0, 0, 0}, 19.0), std::vector<glm::vec3>(8, glm::vec3(1e6F, 0.0F, 0.0F))};
  View view = viewOf(one, "gone");
  view.warp = &warp;
  for (const SeamMethod method : kMethods) {
    const auto result = joined({view}, by(method));
    ASSERT_TRUE(result);
    EXPECT_EQ(result->report.contributions.front().voxels, 0u);
    EXPECT_FALSE(result->report.notes.empty());
  }
}

TEST(HardStitching, StopsAtItsNextQuestionWhereverItIs) {
  const Volume a = speckled(gridOf({120, 110, 100}), 10);
  const Volume b = speckled(gridOf({120, 110, 100}), 11);
  const std::vector<View> views = {viewOf(a, "a"),
                                   viewOf(b, "b", moved(60, 5, 3) * glm::rotate(glm::dmat4(1.0), 0.2, glm::dvec3(0, 0, 1)))};
  for (const SeamMethod method : {SeamMethod::feather, SeamMethod::graphCut})
    for (const int looks : {1, 5, 20, 80, 300, 700, 1500, 4000}) {
      auto cancel = test::CountedStop::atQuestion(looks);
      const auto result = joined(views, by(method), cancel);
      if (result) break;  // done before it was asked to stop
      EXPECT_EQ(result.error().code, ErrorCode::cancelled);
      EXPECT_LE(cancel.questionsAfter(), test::kMostQuestionsAfter) << looks;
      EXPECT_LE(cancel.reportsAfter(), test::kMostReportsAfter) << looks;
    }
  for (const int looks : {1, 10, 60}) {
    auto cancel = test::CountedStop::atQuestion(looks);
    const auto result = equaliseViews(views, {}, cancel);
    if (result) break;
    EXPECT_EQ(result.error().code, ErrorCode::cancelled);
  }
}

}  // namespace
}  // namespace ew::stitching::stitching_test
