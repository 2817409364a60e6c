#include "panel/report_pdf.h"

#include <gtest/gtest.h>

#include <QGuiApplication>
#include <QImage>
#include <regex>

#include "ew/reports/attempt_report.h"
#include "ew/reports/class_report.h"
#include "export/export_world.h"
#include "reports/example_class.h"

namespace ew::review {
namespace {

using test::said;

/// Fonts need an application, though no screen.
class ReportOnPaper : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    ::setenv("QT_QPA_PLATFORM", "offscreen", 1);
    static int count = 1;
    static char name[] = "test", *names[] = {name, nullptr};
    static QGuiApplication application(count, names);
  }
  /// The text of one page, or of all (0).
  std::string textOf(const ReportDocument& document, int page = 0, Paper paper = Paper::a4) {
    EXPECT_TRUE(test::succeeded(writeReportPdf(document, {}, paper, file())));
    return pageOf(page);
  }
  [[nodiscard]] std::string pageOf(int page) const {
    const std::string number = std::to_string(page);
    return said("pdftotext -layout " + (page > 0 ? "-f " + number + " -l " + number + " " : std::string()) + file().string() + " -").text;
  }
  [[nodiscard]] int pages() const {
    std::smatch found;
    const std::string info = said("pdfinfo " + file().string()).text;
    return std::regex_search(info, found, std::regex("Pages: +([0-9]+)")) ? std::stoi(found[1]) : 0;
  }
  [[nodiscard]] std::filesystem::path file() const { return folder_ / "report.pdf"; }
  [[nodiscard]] const test::TemporaryFolder& folder() const { return folder_; }

 private:
  test::TemporaryFolder folder_;
};

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

ReportTable manyRows(int count, const std::string& more = {}) {
  ReportTable table{verbatim("caption of the table"), {{verbatim("Head one")}, {verbatim("Head two"), true}}, {}};
  for (int n = 0; n < count; ++n)
    table.rows.push_back(
        {{verbatim("begin" + std::to_string(n) + " " + more + " end" + std::to_string(n))}, {verbatim(std::to_string(n))}});
  return table;
}

TEST_F(ReportOnPaper, HasEveryWordOfItsBlocks) {
  EW_NEEDS_PROGRAM("pdftotext");
  ReportDocument document{verbatim("The title"), verbatim("and below"), {}, {}};
  document.blocks = {ReportHeading{2, verbatim("A heading")},
                     ReportParagraph{verbatim("A paragraph.")},
                     ReportList{{{verbatim("well done"), ReportTone::good}}},
                     ReportFacts{{{verbatim("Name"), verbatim("Value")}}},
                     manyRows(2),
                     ReportPlot{verbatim("A plot"), BarsPlot{{{verbatim("bar"), 0.5, 0.7, false, verbatim("50 %")}}}},
                     ReportPicture{folder() / "none.png", verbatim("gone")}};
  const std::string text = textOf(document);
  for (const std::string part :
       {"The title", "and below", "A heading", "A paragraph.", "\u2713", "well done", "Name", "Value", "caption of the table", "Head two",
        "end1", "A plot", "The picture 'none.png' is not in the attempt's folder.", "not for diagnosis", "Page 1 of 1"})
    EXPECT_TRUE(has(text, part)) << part << "\n" << text;
}

TEST_F(ReportOnPaper, HasTheSizeThatWasAskedFor) {
  EW_NEEDS_PROGRAM("pdfinfo");
  (void)textOf({}, 0, Paper::a4);
  EXPECT_TRUE(has(said("pdfinfo " + file().string()).text, "595 x 842 pts (A4)"));
  (void)textOf({}, 0, Paper::letter);
  EXPECT_TRUE(has(said("pdfinfo " + file().string()).text, "612 x 792 pts (letter)"));
}

TEST_F(ReportOnPaper, NeverCutsARowAndRepeatsTheTablesHead) {
  EW_NEEDS_PROGRAM("pdftotext");
  std::string more;
  for (int n = 0; n < 40; ++n) more += "words in a row ";
  ReportDocument document{verbatim("Rows"), {}, {}, {manyRows(120, more)}};
  (void)textOf(document);
  ASSERT_GT(pages(), 5);
  int rows = 0;
  for (int page = 1; page <= pages(); ++page) {
    const std::string text = pageOf(page);
    EXPECT_TRUE(has(text, "Head one")) << page;
    EXPECT_TRUE(has(text, "Page " + std::to_string(page) + " of " + std::to_string(pages()))) << text;
    EXPECT_TRUE(has(text, "not for diagnosis"));
    for (int n = 0; n < 120; ++n) {
      const bool begins = std::regex_search(text, std::regex("begin" + std::to_string(n) + "\\b"));
      EXPECT_EQ(begins, std::regex_search(text, std::regex("end" + std::to_string(n) + "\\b"))) << "row " << n << " on page " << page;
      rows += begins ? 1 : 0;
    }
  }
  EXPECT_EQ(rows, 120);
}

TEST_F(ReportOnPaper, GoesOnWithARowThatNoPageHolds) {
  EW_NEEDS_PROGRAM("pdftotext");
  std::string more;
  for (int n = 0; n < 3000; ++n) more += "word" + std::to_string(n) + " ";
  ReportDocument document{verbatim("A row"), {}, {}, {manyRows(1, more), ReportFacts{{{verbatim("Remark"), verbatim(more)}}}}};
  const std::string text = textOf(document);
  EXPECT_GT(pages(), 2);
  for (const int n : {0, 1500, 2999}) {
    const std::regex word("word" + std::to_string(n) + "\\b");
    EXPECT_EQ(std::distance(std::sregex_iterator(text.begin(), text.end(), word), std::sregex_iterator()), 2) << n;
  }
}

TEST_F(ReportOnPaper, NeverCutsAPictureOrTakesItFromItsCaption) {
  EW_NEEDS_PROGRAM("pdfimages");
  QImage image(900, 600, QImage::Format_RGB32);
  image.fill(Qt::darkCyan);
  ASSERT_TRUE(image.save(QString::fromStdString((folder() / "a.png").string())));
  ReportDocument document{verbatim("Pictures"), {}, {}, {}};
  for (int n = 0; n < 7; ++n) document.blocks.emplace_back(ReportPicture{folder() / "a.png", verbatim("caption" + std::to_string(n))});
  (void)textOf(document);
  const std::string list = said("pdfimages -list " + file().string()).text;
  for (int page = 1; page <= pages(); ++page) {
    const std::string text = pageOf(page);
    int captions = 0;
    for (int n = 0; n < 7; ++n) captions += has(text, "caption" + std::to_string(n)) ? 1 : 0;
    const std::regex onPage("\n +" + std::to_string(page) + " ");
    EXPECT_EQ(std::distance(std::sregex_iterator(list.begin(), list.end(), onPage), std::sregex_iterator()), captions) << list;
  }
  EXPECT_EQ(pages(), 4) << "two of 87 mm and their captions fit on a page";
}

TEST_F(ReportOnPaper, KeepsAHeadingWithWhatFollows) {
  EW_NEEDS_PROGRAM("pdftotext");
  for (int before = 25; before < 45; ++before) {
    ReportDocument document{verbatim("Headings"), {}, {}, {}};
    for (int n = 0; n < before; ++n) document.blocks.emplace_back(ReportList{{{verbatim("line"), ReportTone::plain}}});
    document.blocks.emplace_back(ReportHeading{2, verbatim("THEHEADING")});
    document.blocks.emplace_back(ReportHeading{3, verbatim("heading below")});
    document.blocks.emplace_back(ReportParagraph{verbatim("thefollowing")});
    (void)textOf(document);
    for (int page = 1; page <= pages(); ++page) EXPECT_EQ(has(pageOf(page), "THEHEADING"), has(pageOf(page), "thefollowing")) << before;
  }
}

TEST_F(ReportOnPaper, OfAnAttemptAndItsClassAreWhole) {
  EW_NEEDS_PROGRAM("pdftotext");
  const test::AssessedWorld world;
  std::vector<ReportedAttempt> attempts;
  for (const auto& one : test::exampleClass(world)) attempts.push_back(*readReportedAttempt(one));
  const ReportedLesson lesson = readReportedLesson("ball", "about-balls", world.library(), {});
  const std::string attempt = textOf(attemptReport(attempts[4], lesson, test::someCodes()));
  for (const std::string part : {"Step by step", "2. Step plane", "Stored picture: Step plane", "Earlier scores", "What the metrics are"})
    EXPECT_TRUE(has(attempt, part)) << part;
  if (!test::lookedAt().empty())
    std::filesystem::copy_file(file(), test::lookedAt() / "attempt.pdf", std::filesystem::copy_options::overwrite_existing);
  const std::string text = textOf(classReport(attempts, lesson, test::someCodes()), 0, Paper::letter);
  for (const std::string part : {"Attempts", "How far raters agree", "Metrics, step by step"}) EXPECT_TRUE(has(text, part)) << part;
  if (!test::lookedAt().empty())
    std::filesystem::copy_file(file(), test::lookedAt() / "class.pdf", std::filesystem::copy_options::overwrite_existing);
}

TEST_F(ReportOnPaper, ThatCannotBeWrittenSaysSo) {
  const auto written = writeReportPdf({}, {}, Paper::a4, folder() / "no" / "such" / "folder.pdf");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::notWritable);
}

}  // namespace
}  // namespace ew::review
