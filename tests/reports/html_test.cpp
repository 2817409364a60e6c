#include "ew/reports/html.h"

#include <fstream>
#include <regex>

#include "ew/reports/image_file.h"
#include "reports/reports_world.h"

namespace ew {
namespace {

using test::countOf;
using test::holds;

ReportDocument everyBlock(const std::filesystem::path& image) {
  const std::string bad = "<script>alert(\"1\")</script> & 'x'";
  ReportDocument document;
  document.title = verbatim(bad);
  document.subtitle = verbatim(bad);
  document.links = {{verbatim(bad), "a b<'>.html"}};
  document.blocks = {
      ReportHeading{2, verbatim(bad)},
      ReportParagraph{verbatim(bad), ReportTone::caution},
      ReportList{{{verbatim(bad), ReportTone::good}, {verbatim(bad), ReportTone::bad}}},
      ReportFacts{{{verbatim(bad), verbatim(bad)}}},
      ReportTable{verbatim(bad), {{verbatim(bad)}, {verbatim(bad), true}}, {{{verbatim(bad), ReportTone::plain, bad}, {verbatim(bad)}}}},
      ReportPlot{verbatim(bad), BarsPlot{{{verbatim(bad), 0.5, 0.7, false, verbatim(bad)}}}},
      ReportPlot{verbatim(bad), HistogramPlot{{1, 0, 2}, 0.0, 1.0, true, verbatim(bad), 0.7}},
      ReportPlot{verbatim(bad), StripPlot{{{verbatim(bad), {1.0, 2.0}, 1.5, 3.0}}, false, verbatim(bad)}, true},
      ReportPlot{verbatim(bad), TimeLinePlot{{{verbatim(bad), {{0.0, 5.0, true}}}}, 10.0}},
      ReportPlot{verbatim(bad), PathPlot{{{verbatim(bad), true, {{{0.0, 0.0}, {10.0, 5.0}}}}}}},
      ReportImage{image, verbatim(bad)},
      ReportImage{image.parent_path() / "none.png", verbatim("gone")}};
  return document;
}

std::filesystem::path madeImage(const test::TemporaryFolder& folder) {
  const std::filesystem::path file = folder / "picture.png";
  std::ofstream(file, std::ios::binary) << "\x89PNG\r\n\x1a\n and more";
  return file;
}

TEST(Page, TakesNoTextForMarkup) {
  const test::TemporaryFolder folder;
  const std::string page = htmlOf(everyBlock(madeImage(folder)), {});
  EXPECT_FALSE(holds(page, "<script"));
  EXPECT_FALSE(holds(page, "alert(\""));
  EXPECT_GE(countOf(page, "&lt;script&gt;alert(&quot;1&quot;)&lt;/script&gt; &amp; &#39;x&#39;"), 15u);
  EXPECT_TRUE(holds(page, "href='./a%20b%3C%27%3E.html'"));
}

TEST(Page, LoadsNothingAndRunsNothing) {
  const test::TemporaryFolder folder;
  const std::string page = htmlOf(everyBlock(madeImage(folder)), {});
  EXPECT_TRUE(holds(page, "default-src 'none'; img-src data:; style-src 'unsafe-inline'"));
  std::string rest = page;
  for (std::size_t at = rest.find("xmlns='http://www.w3.org/2000/svg'"); at != std::string::npos;
       at = rest.find("xmlns='http://www.w3.org/2000/svg'"))
    rest.erase(at, 34);
  for (const char* loads : {"http://", "https://", "url(", "@import", "<link", "<script", "<iframe", "onload", "src='/", "href='http"})
    EXPECT_FALSE(holds(rest, loads)) << loads;
  EXPECT_TRUE(holds(page, "src='data:image/png;base64,"));
}

TEST(Page, IsWellFormedAndSaysItsStructure) {
  const test::TemporaryFolder folder;
  const std::string page = htmlOf(everyBlock(madeImage(folder)), {.language = "de_AT"});
  EXPECT_TRUE(holds(page, "<html lang='de'>"));
  EXPECT_EQ(countOf(page, "<h1>"), 1u);
  EXPECT_TRUE(holds(page, "<th scope='col' class='number'>"));
  EXPECT_TRUE(holds(page, "<th scope='row'>"));
  EXPECT_EQ(countOf(page, "<svg "), 5u);
  EXPECT_EQ(countOf(page, "role='img' aria-label='"), 5u);
  EXPECT_TRUE(holds(page, "<img alt='&lt;script"));
  for (const char* tag : {"p", "ul", "li", "dl", "dt", "dd", "table", "tr", "td", "th", "figure", "svg", "text", "div", "main", "body"})
    EXPECT_EQ(countOf(page, "<" + std::string(tag) + ">") + countOf(page, "<" + std::string(tag) + " "),
              countOf(page, "</" + std::string(tag) + ">"))
        << tag;
}

TEST(Page, SaysInPlaceOfAnImageThatItIsNotThere) {
  const test::TemporaryFolder folder;
  EXPECT_TRUE(holds(htmlOf(everyBlock(madeImage(folder)), {}), "The image &#39;none.png&#39; is not in the attempt&#39;s folder."));
}

TEST(Page, SaysThatItIsASimulation) { EXPECT_TRUE(holds(htmlOf({}, {}), "Simulation, training only: not for diagnosis.")); }

/// As a window's words, with every text that a translator has to know in brackets.
std::string bracketed(const Message& message) {
  if (message.text() != nullptr) return "[" + std::string(message.text()) + "]";
  if (message.arguments().empty()) return message.verbatim();
  std::string all = bracketed(message.arguments().front());
  for (std::size_t n = 1; n < message.arguments().size(); ++n) all += message.verbatim() + bracketed(message.arguments()[n]);
  return all;
}

TEST(Page, AsksForEveryWordInTheReadersLanguage) {
  ReportOptions options;
  options.words = bracketed;
  ReportAttempt one = test::madeAttempt(1, 0.9, 0.2);
  one.ratings.ratings = {test::ratedBy("R", 3, 4)};
  one.earlier = {*one.score};
  for (const std::string& page : {htmlOf(attemptReport(one, test::madeLesson(), test::someCodes(), options), options),
                                  htmlOf(classReport({one}, test::madeLesson(), test::someCodes(), {}, options), options)}) {
    // What stands outside of brackets once tags are gone: the attempt's own words, codes and numbers.
    std::string rest = page.substr(page.find("<body>"));
    rest = std::regex_replace(rest, std::regex("<[^>]*>"), " ");
    rest = std::regex_replace(rest, std::regex("\\[[^\\]]*\\]"), " ");
    for (const std::string word :
         {" Score ", " passed", "Step by step", "Metric ", "Trainee", " not for diagnosis", "Definition", "Rater "})
      EXPECT_FALSE(holds(rest, word)) << word << "\n" << rest;
  }
}

TEST(Images, AreTakenForWhatTheyAreAndLinksAreNotFollowed) {
  const test::TemporaryFolder folder;
  std::ofstream(folder / "text.png") << "no image";
  std::ofstream(folder / "a.jpg", std::ios::binary) << "\xff\xd8\xff more";
  std::filesystem::create_symlink(folder / "a.jpg", folder / "link.jpg");
  EXPECT_EQ(readReportImage(folder / "text.png").error().code, ErrorCode::unsupported);
  EXPECT_EQ(readReportImage(folder / "a.jpg")->mediaType, "image/jpeg");
  EXPECT_EQ(readReportImage(folder / "link.jpg").error().code, ErrorCode::notFound);
  EXPECT_EQ(readReportImage(folder / "none.jpg").error().sentence().find(folder.path().string()), std::string::npos);
}

TEST(Base64, IsThatOfItsStandard) {
  for (const auto& [bytes, text] : {std::pair("", ""),
                                    {"f", "Zg=="},
                                    {"fo", "Zm8="},
                                    {"foo", "Zm9v"},
                                    {"foob", "Zm9vYg=="},
                                    {"fooba", "Zm9vYmE="},
                                    {"foobar", "Zm9vYmFy"}})
    EXPECT_EQ(base64Of(bytes), text);
  EXPECT_EQ(base64Of(std::string("\0\xff\xfe", 3)), "AP/+");
}

}  // namespace
}  // namespace ew
