#include "ew/paper/paper_pages.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <thread>

#include "library/temporary_folder.h"

namespace ew::test::paper_pages_test {
namespace {

PaperEdges edges() {
  return {"Title", "Foot", [](int page, int of) { return std::to_string(page) + "/" + std::to_string(of); }};
}

/// Lines of text on as many pages as they need.
std::string printed(int lines) {
  auto pages = PaperPages::begin(PaperSize::a4, edges());
  EXPECT_TRUE(pages);
  const PaperFont font;
  for (int n = 0; n < lines; ++n) {
    pages->makeRoom(lineHeight(font));
    if (n % 100 == 0) pages->heading(1 + n / 100, "heading");
    pages->line(pages->text("line " + std::to_string(n), font), 0, font, Rgb(0, 0, 0), {0.0, pages->y()}, pages->width());
    pages->moveOn(lineHeight(font));
  }
  return *pages->pdf({"Title", "2026-11-26T09:30:00Z"});
}

TEST(PaperPages, FillFromAboveAndBeginAnotherWhereThereIsNoRoom) {
  auto pages = *PaperPages::begin(PaperSize::a4, edges());
  EXPECT_TRUE(pages.isFresh());
  EXPECT_NEAR(pages.width(), PaperPages::mm(178.0), 1e-9);
  pages.makeRoom(10.0 * pages.roomOfAPage());
  EXPECT_EQ(pages.pages(), 1) << "what no page holds does not get a better one";
  pages.moveOn(0.75 * pages.roomOfAPage());
  pages.makeRoom(0.2 * pages.roomOfAPage());
  EXPECT_EQ(pages.pages(), 1);
  pages.makeRoom(0.3 * pages.roomOfAPage());
  EXPECT_EQ(pages.pages(), 2);
  EXPECT_TRUE(pages.isFresh());
}

TEST(PaperPages, BreakTextBetweenWordsAndLongWordsWithinThem) {
  const auto pages = *PaperPages::begin(PaperSize::a4, edges());
  const PaperFont font;
  const PaperText whole = pages.text("some words that are broken", font);
  EXPECT_EQ(whole.lines(), 1);
  const PaperText broken = pages.text("some words that are broken", font, 0.5 * whole.width());
  EXPECT_GT(broken.lines(), 1);
  EXPECT_LE(broken.width(), 0.5 * whole.width());
  const PaperText longWord = pages.text(std::string(500, 'm'), font, 100.0);
  EXPECT_GT(longWord.lines(), 20);
  EXPECT_LE(longWord.width(), 100.0);
  EXPECT_EQ(pages.text("", font, 100.0).lines(), 1);
  EXPECT_EQ(pages.text("one\ntwo", font, 100.0).lines(), 2);
  EXPECT_EQ(pages.text("\xff\xfe broken \x01 bytes", font).lines(), 1);
}

TEST(PaperPages, HaveFiguresOfOneWidthForColumns) {
  const auto pages = *PaperPages::begin(PaperSize::a4, edges());
  const PaperFont even{8.0, false, true};
  EXPECT_NEAR(pages.text("111111", even).width(), pages.text("888888", even).width(), 0.01);
  EXPECT_GT(pages.text("words", {9.5, true, false}).width(), pages.text("words", {9.5, false, false}).width());
}

TEST(PaperPages, AreTheSameToTheByteOnEveryThread) {
  const std::string here = printed(300);
  std::string there[4];
  {
    std::vector<std::jthread> threads;
    for (std::string& each : there) threads.emplace_back([&each] { each = printed(300); });
  }
  for (const std::string& each : there) EXPECT_EQ(each, here);
  EXPECT_NE(here.find("/CreationDate (20261126093000"), std::string::npos);
}

TEST(PaperPagesWithoutFonts, SaySoAndDoNotCrash) {
  const TemporaryFolder folder;
  const std::string config = (folder / "fonts.conf").string();
  writeText(config, "<?xml version=\"1.0\"?><fontconfig><cachedir>" + (folder / "cache").string() + "</cachedir></fontconfig>");
  // In a program of its own, for fonts are looked for once.
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  EXPECT_EXIT(
      {
        ::setenv("FONTCONFIG_FILE", config.c_str(), 1);
        const auto pages = PaperPages::begin(PaperSize::a4, edges());
        std::_Exit(!pages && pages.error().code == ErrorCode::unsupported ? 0 : 1);
      },
      ::testing::ExitedWithCode(0), "");
}

TEST(PdfFile, SaysWhyItCannotBeDrawn) {
  PdfFile pdf({210.0, 297.0});
  cairo_restore(pdf.pen());  // nothing was saved
  const auto bytes = pdf.finish();
  ASSERT_FALSE(bytes);
  EXPECT_EQ(bytes.error().code, ErrorCode::internal);
}

TEST(PdfFile, HasPagesOfTheirOwnSize) {
  PdfFile pdf(sizeOf(PaperSize::a4));
  pdf.endPage();
  pdf.setPageSize({100.0, 50.0});
  pdf.endPage();
  const std::string bytes = *pdf.finish();
  EXPECT_NE(bytes.find("283.464"), std::string::npos);
  EXPECT_EQ(bytes.find("CreationDate"), std::string::npos);
}

}  // namespace
}  // namespace ew::test::paper_pages_test
