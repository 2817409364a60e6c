#include "ew/reports/report_pdf.h"

#include <regex>

#include "ew/reports/attempt_report.h"
#include "ew/reports/class_report.h"
#include "export/export_world.h"
#include "reports/example_class.h"

namespace ew::test::report_pdf_test {
namespace {

class ReportOnPaper : public ::testing::Test {
 protected:
  /// The text of one page, or of all (0).
  std::string textOf(const ReportDocument& document, int page = 0, PaperSize paper = PaperSize::a4, const ReportOptions& options = {}) {
    EXPECT_TRUE(succeeded(writeReportPdf(document, options, paper, file())));
    return pageOf(page);
  }
  [[nodiscard]] std::string pageOf(int page) const {
    const std::string number = std::to_string(page);
    return said("pdftotext -layout " + (page > 0 ? "-f " + number + " -l " + number + " " : std::string()) + file().string() + " -").text;
  }
  [[nodiscard]] std::string info() const { return said("pdfinfo " + file().string()).text; }
  [[nodiscard]] int pages() const {
    std::smatch found;
    const std::string text = info();
    return std::regex_search(text, found, std::regex("Pages: +([0-9]+)")) ? std::stoi(found[1]) : 0;
  }
  [[nodiscard]] std::filesystem::path file() const { return folder_ / "report.pdf"; }
  [[nodiscard]] const TemporaryFolder& folder() const { return folder_; }
  void writeDisplayImage(const std::string& name) const {
    const std::vector<std::uint8_t> grey(900 * 600, 90);
    ASSERT_TRUE(succeeded(writeImage(ImageView<const std::uint8_t>{grey.data(), 900, 600, 900}, 0.3, folder_ / name)));
  }

 private:
  TemporaryFolder folder_;
};

std::size_t countIn(const std::string& text, const std::regex& pattern) {
  return static_cast<std::size_t>(std::distance(std::sregex_iterator(text.begin(), text.end(), pattern), std::sregex_iterator()));
}

ReportTable manyRows(int count, const std::string& more = {}) {
  ReportTable table{verbatim("caption of the table"), {{verbatim("Head one")}, {verbatim("Head two"), true}}, {}};
  for (int n = 0; n < count; ++n)
    table.rows.push_back(
        {{verbatim("begin" + std::to_string(n) + " " + more + " end" + std::to_string(n))}, {verbatim(std::to_string(n))}});
  return table;
}

ReportDocument someOfEach(const std::filesystem::path& image) {
  ReportDocument document{verbatim("The title"), verbatim("and below"), {}, {}};
  document.blocks = {ReportHeading{2, verbatim("A heading")},
                     ReportParagraph{verbatim("A paragraph.")},
                     ReportList{{{verbatim("well done"), ReportTone::good}}},
                     ReportFacts{{{verbatim("Name"), verbatim("Value")}}},
                     manyRows(2),
                     ReportPlot{verbatim("A plot"), BarsPlot{{{verbatim("bar"), 0.5, 0.7, false, verbatim("50 %")}}}},
                     ReportImage{image, verbatim("gone")}};
  return document;
}

TEST_F(ReportOnPaper, HasEveryWordOfItsBlocksAndOfItsPlots) {
  EW_NEEDS_PROGRAM("pdftotext");
  const std::string text = textOf(someOfEach(folder() / "none.png"));
  for (const std::string part : {"The title", "and below", "A heading", "A paragraph.", "✓", "well done", "Name", "Value",
                                 "caption of the table", "Head two", "end1", "A plot", "bar", "50 %", "100 %",
                                 "The image 'none.png' is not in the attempt's folder.", "not for diagnosis", "Page 1 of 1"})
    EXPECT_TRUE(holds(text, part)) << part << "\n" << text;
}

TEST_F(ReportOnPaper, IsOnePageEvenOfNothing) {
  const auto pdf = pdfOf({}, {});
  ASSERT_TRUE(succeeded(pdf));
  EXPECT_TRUE(pdf->starts_with("%PDF-"));
  EXPECT_EQ(countIn(*pdf, std::regex("/Type /Page[^s]")), 1u);
}

TEST_F(ReportOnPaper, IsTheSameToTheByteAndDatedByWhatItTellsOf) {
  ReportDocument document = someOfEach(folder() / "none.png");
  const auto first = pdfOf(document, {}), again = pdfOf(document, {});
  ASSERT_TRUE(succeeded(first));
  EXPECT_EQ(*first, *again);
  EXPECT_FALSE(holds(*first, "CreationDate")) << "the clock of the computer is nobody's business";
  document.at = std::chrono::sys_days(std::chrono::year(2026) / 11 / 1) + std::chrono::hours(10) + std::chrono::minutes(5);
  EXPECT_TRUE(holds(*pdfOf(document, {}), "/CreationDate (20261101100500"));
}

TEST_F(ReportOnPaper, HasItsTitleAndItsHeadingsInTheFilesOwnWords) {
  EW_NEEDS_PROGRAM("pdfinfo");
  (void)textOf(someOfEach(folder() / "none.png"));
  EXPECT_TRUE(std::regex_search(info(), std::regex("Title: +The title"))) << info();
  EXPECT_FALSE(holds(info(), "Author")) << info();
  EXPECT_TRUE(holds(test::textOf(file()), "/Outlines"));
  const std::string fonts = said("pdffonts " + file().string()).text;
  EXPECT_EQ(countIn(fonts, std::regex(" yes (yes|no) +(yes|no) +[0-9]+ +0\n")), countIn(fonts, std::regex(" [0-9]+ +0\n")))
      << "not every font is in the file:\n"
      << fonts;
}

TEST_F(ReportOnPaper, SpeaksTheReadersLanguageWithAllItsLetters) {
  EW_NEEDS_PROGRAM("pdftotext");
  ReportOptions german;
  german.language = "de";
  german.words = [](const Message& message) {
    return message.text() != nullptr && std::string(message.text()) == "Page %1 of %2" ? "Seite 1 von 1" : message.english();
  };
  const std::string words = "Größe der Öffnung: Äußeres Maß, Übung 3 – „jäh“ … ÄÖÜäöüß";
  const std::string text = textOf({verbatim("Prüfung"), {}, {}, {ReportParagraph{verbatim(words)}}}, 0, PaperSize::a4, german);
  EXPECT_TRUE(holds(text, words)) << text;
  EXPECT_TRUE(holds(text, "Prüfung"));
  EXPECT_TRUE(holds(text, "Seite 1 von 1"));
}

TEST_F(ReportOnPaper, LetsNoWordLeaveThePageHoweverLong) {
  EW_NEEDS_PROGRAM("pdftotext");
  const std::string word(400, 'W');
  ReportTable table{verbatim(word), {{verbatim(word)}, {verbatim(word), true}, {verbatim("short")}}, {}};
  table.rows.push_back({{verbatim(word)}, {verbatim(word)}, {verbatim("here")}});
  ReportDocument document{verbatim(word), verbatim(word), {}, {}};
  document.blocks = {ReportHeading{3, verbatim(word)},
                     ReportParagraph{verbatim(word)},
                     ReportList{{{verbatim(word)}}},
                     ReportFacts{{{verbatim(word), verbatim(word)}}},
                     table,
                     ReportPlot{verbatim(word), BarsPlot{{{verbatim(word), 0.5, 0.7, false, verbatim("50 %")}}}}};
  EXPECT_FALSE(holds(textOf(document), "-\n")) << "nothing is put into a word that is broken";
  const std::string boxes = said("pdftotext -bbox " + file().string() + " -").text;
  const std::regex box("<word xMin=\"([-0-9.]+)\" yMin=\"([-0-9.]+)\" xMax=\"([-0-9.]+)\" yMax=\"([-0-9.]+)\"");
  std::size_t count = 0;
  for (std::sregex_iterator at(boxes.begin(), boxes.end(), box); at != std::sregex_iterator(); ++at, ++count) {
    EXPECT_GE(std::stod((*at)[1]), 45.0) << at->str();
    EXPECT_LE(std::stod((*at)[3]), 595.3 - 44.5) << at->str();
    EXPECT_LE(std::stod((*at)[4]), 842.0 - 28.0) << at->str();
  }
  EXPECT_GT(count, 40u);
}

TEST_F(ReportOnPaper, SetsNumbersUnderEachOtherAtTheRight) {
  EW_NEEDS_PROGRAM("pdftotext");
  ReportTable table{verbatim("caption"), {{verbatim("Words")}, {verbatim("Numbers"), true}}, {}};
  for (const std::string number : {"7001", "72", "7000000"}) table.rows.push_back({{verbatim("word")}, {verbatim(number)}});
  (void)textOf({verbatim("Numbers"), {}, {}, {table}});
  const std::string boxes = said("pdftotext -bbox " + file().string() + " -").text;
  const std::regex number("xMin=\"([0-9.]+)\"[^\n]* xMax=\"([0-9.]+)\"[^\n]*>7[0-9]+<");
  std::vector<double> left, right;
  for (std::sregex_iterator at(boxes.begin(), boxes.end(), number); at != std::sregex_iterator(); ++at) {
    left.push_back(std::stod((*at)[1]));
    right.push_back(std::stod((*at)[2]));
  }
  ASSERT_EQ(right.size(), 3u) << boxes;
  EXPECT_NEAR(right[0], right[1], 0.1);
  EXPECT_NEAR(right[0], right[2], 0.1);
  EXPECT_GT(left[1], left[0] + 5.0);
}

TEST_F(ReportOnPaper, HasTheSizeThatWasAskedFor) {
  EW_NEEDS_PROGRAM("pdfinfo");
  (void)textOf({}, 0, PaperSize::a4);
  EXPECT_TRUE(holds(info(), "(A4)")) << info();
  (void)textOf({}, 0, PaperSize::letter);
  EXPECT_TRUE(holds(info(), "612 x 792 pts (letter)")) << info();
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
    EXPECT_TRUE(holds(text, "Head one")) << page;
    EXPECT_TRUE(holds(text, "Page " + std::to_string(page) + " of " + std::to_string(pages()))) << text;
    EXPECT_TRUE(holds(text, "not for diagnosis"));
    for (int n = 0; n < 120; ++n) {
      const bool begins = std::regex_search(text, std::regex("begin" + std::to_string(n) + "\\b"));
      EXPECT_EQ(begins, std::regex_search(text, std::regex("end" + std::to_string(n) + "\\b"))) << "row " << n << " on page " << page;
      rows += begins ? 1 : 0;
    }
  }
  EXPECT_EQ(rows, 120);
}

TEST_F(ReportOnPaper, NeverLeavesATablesHeadWithoutARow) {
  EW_NEEDS_PROGRAM("pdftotext");
  std::string more;
  for (int n = 0; n < 60; ++n) more += "words in a row ";
  for (int before = 30; before < 52; ++before) {
    ReportDocument document{verbatim("Heads"), {}, {}, {}};
    for (int n = 0; n < before; ++n) document.blocks.emplace_back(ReportList{{{verbatim("line"), ReportTone::plain}}});
    document.blocks.emplace_back(manyRows(1, more));
    (void)textOf(document);
    for (int page = 1; page <= pages(); ++page) EXPECT_EQ(holds(pageOf(page), "Head one"), holds(pageOf(page), "begin0")) << before;
  }
}

TEST_F(ReportOnPaper, GoesOnWithARowThatNoPageHolds) {
  EW_NEEDS_PROGRAM("pdftotext");
  std::string more;
  for (int n = 0; n < 3000; ++n) more += "word" + std::to_string(n) + " ";
  ReportDocument document{verbatim("A row"), {}, {}, {manyRows(1, more), ReportFacts{{{verbatim("Remark"), verbatim(more)}}}}};
  const std::string text = textOf(document);
  EXPECT_GT(pages(), 2);
  for (const int n : {0, 1500, 2999}) EXPECT_EQ(countIn(text, std::regex("word" + std::to_string(n) + "\\b")), 2u) << n;
}

TEST_F(ReportOnPaper, NeverCutsAnImageOrTakesItFromItsCaption) {
  EW_NEEDS_PROGRAM("pdfimages");
  writeDisplayImage("a.png");
  ReportDocument document{verbatim("Pictures"), {}, {}, {}};
  for (int n = 0; n < 7; ++n) document.blocks.emplace_back(ReportImage{folder() / "a.png", verbatim("caption" + std::to_string(n))});
  (void)textOf(document);
  const std::string list = said("pdfimages -list " + file().string()).text;
  for (int page = 1; page <= pages(); ++page) {
    const std::string text = pageOf(page);
    std::size_t captions = 0;
    for (int n = 0; n < 7; ++n) captions += holds(text, "caption" + std::to_string(n)) ? 1 : 0;
    EXPECT_EQ(countIn(list, std::regex("\n +" + std::to_string(page) + " ")), captions) << list;
  }
  EXPECT_EQ(pages(), 4) << "two of 87 mm and their captions fit on a page";
}

/// A grey JPEG of 8 x 8 pixels: tables of quantization and of codes with one word each, a frame and a scan of one block.
std::string smallJpeg() {
  const auto bytes = [](std::initializer_list<int> all) { return std::string(all.begin(), all.end()); };
  const std::string oneCode = bytes({1}) + std::string(16, '\0');
  return bytes({0xff, 0xd8, 0xff, 0xdb, 0, 67, 0}) + std::string(64, '\1') + bytes({0xff, 0xc0, 0, 11, 8, 0, 8, 0, 8, 1, 1, 0x11, 0}) +
         bytes({0xff, 0xc4, 0, 20, 0}) + oneCode + bytes({0xff, 0xc4, 0, 20, 0x10}) + oneCode +
         bytes({0xff, 0xda, 0, 8, 1, 1, 0, 0, 63, 0, 0x3f, 0xff, 0xd9});
}

TEST_F(ReportOnPaper, TakesAJpegInAsItIsButNotTheWordsInItsFile) {
  EW_NEEDS_PROGRAM("pdfimages");
  const std::string words = "GPS of somebody's home";
  std::string told = smallJpeg();
  told.insert(2, std::string("\xff\xe1\0", 3) + static_cast<char>(words.size() + 2) + words);
  writeText(folder() / "a.jpg", told);
  (void)textOf({verbatim("A JPEG"), {}, {}, {ReportImage{folder() / "a.jpg", verbatim("caption")}}});
  EXPECT_TRUE(std::regex_search(said("pdfimages -list " + file().string()).text, std::regex("image +8 +8 .* jpeg ")));
  EXPECT_TRUE(holds(test::textOf(file()), smallJpeg()));
  EXPECT_FALSE(holds(test::textOf(file()), words));
}

TEST_F(ReportOnPaper, SaysWhichImageCannotBeShown) {
  EW_NEEDS_PROGRAM("pdftotext");
  writeDisplayImage("a.png");
  const std::string whole = test::textOf(folder() / "a.png");
  std::string huge = whole;
  huge[16] = huge[20] = '\x7f';
  writeText(folder() / "cut.png", whole.substr(0, whole.size() / 2));
  writeText(folder() / "huge.png", huge);
  writeText(folder() / "cut.jpg", smallJpeg().substr(0, smallJpeg().size() - 2));
  writeText(folder() / "none.jpg", "\xff\xd8\xff");
  ReportDocument document{verbatim("Pictures"), {}, {}, {}};
  for (const std::string name : {"cut.png", "huge.png", "cut.jpg", "none.jpg"})
    document.blocks.emplace_back(ReportImage{folder() / name, verbatim("caption")});
  const std::string text = textOf(document);
  for (const std::string name : {"cut.png", "huge.png", "cut.jpg", "none.jpg"})
    EXPECT_TRUE(holds(text, "The image '" + name + "' is damaged.")) << text;
  EXPECT_FALSE(holds(text, "caption"));
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
    for (int page = 1; page <= pages(); ++page) EXPECT_EQ(holds(pageOf(page), "THEHEADING"), holds(pageOf(page), "thefollowing")) << before;
  }
}

TEST_F(ReportOnPaper, OfAnAttemptAndItsClassAreWhole) {
  EW_NEEDS_PROGRAM("pdftotext");
  const AssessedWorld world;
  std::vector<ReportAttempt> attempts;
  for (const auto& one : exampleClass(world)) attempts.push_back(*readReportedAttempt(one));
  const ReportLesson lesson = readReportedLesson("ball", "about-balls", world.library(), {});
  const std::string attempt = textOf(attemptReport(attempts[4], lesson, someCodes()));
  for (const std::string part : {"Step by step", "2. Step plane", "Stored image: Step plane", "Way of the probe", "the expert",
                                 "Earlier scores", "What the metrics are"})
    EXPECT_TRUE(holds(attempt, part)) << part;
  EXPECT_TRUE(holds(test::textOf(file()), "/CreationDate")) << "when it was scored";
  if (!lookedAt().empty())
    std::filesystem::copy_file(file(), lookedAt() / "attempt.pdf", std::filesystem::copy_options::overwrite_existing);
  const std::string text = textOf(classReport(attempts, lesson, someCodes()), 0, PaperSize::letter);
  for (const std::string part : {"Attempts", "How far raters agree", "Metrics, step by step"}) EXPECT_TRUE(holds(text, part)) << part;
  if (!lookedAt().empty()) std::filesystem::copy_file(file(), lookedAt() / "class.pdf", std::filesystem::copy_options::overwrite_existing);
}

TEST_F(ReportOnPaper, ThatCannotBeWrittenSaysSoAndLeavesNothing) {
  const auto written = writeReportPdf({}, {}, PaperSize::a4, folder() / "no" / "such" / "folder.pdf");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.error().code, ErrorCode::notWritable);
  std::filesystem::create_directory(folder() / "taken.pdf");
  EXPECT_FALSE(writeReportPdf({}, {}, PaperSize::a4, folder() / "taken.pdf"));
  EXPECT_EQ(namesIn(folder().path()), (std::set<std::string>{"taken.pdf"}));
}

}  // namespace
}  // namespace ew::test::report_pdf_test
