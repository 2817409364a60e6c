#include "ew/reports/worksheet_report.h"

#include <regex>

#include "ew/io/image_file.h"
#include "ew/io/safe_file.h"
#include "ew/measurement/worksheet_line.h"
#include "ew/reports/html.h"
#include "ew/reports/report_pdf.h"
#include "export/export_world.h"
#include "measurement/packages.h"
#include "reports/reports_world.h"

namespace ew::test::worksheet_report_test {
namespace {

using measurement::Unit;
using measurement::Worksheet;

Worksheet biometry() {
  const auto mm = [](const char* label, double value, double uncertainty) {
    return measurement::WorksheetEntry{label, {}, {value, uncertainty, Unit::mm}, {}, false};
  };
  auto sheet = fillWorksheet(measurement::test::shipped("obstetric"),
                             {{mm("BPD", 82, 0.8), mm("HC", 300, 2.0), mm("AC", 280, 3.0), mm("FL", 61.8, 0.6), mm("FL", 62.2, 0.6)},
                              measurement::Several::mean,
                              32.0 + 1.0 / 7.0});
  EXPECT_TRUE(succeeded(sheet));
  return sheet ? std::move(*sheet) : Worksheet{};
}

class WorksheetOnPaper : public ::testing::Test {
 protected:
  /// @param images how many images stand behind the sheet
  [[nodiscard]] WorksheetAbout about(int images = 0) const {
    WorksheetAbout made{
        .patient = "Pain, \"here\"",
        .moment = verbatim("02.01.26 03:04"),
        .at = std::chrono::sys_days(std::chrono::year(2026) / 1 / 2) + std::chrono::hours(3) + std::chrono::minutes(4),
        .examiner = "Anna",
    };
    const std::vector<std::uint8_t> grey(900 * 600, 90);
    EXPECT_TRUE(succeeded(writeImage(ImageView<const std::uint8_t>{grey.data(), 900, 600, 900}, 0.3, folder_ / "a.png")));
    for (int n = 0; n < images; ++n)
      made.images.push_back(
          {.caption = verbatim("caption" + std::to_string(n)), .bytes = test::textOf(folder_ / "a.png"), .isSmall = true});
    return made;
  }
  /// @param how words for pdftotext
  [[nodiscard]] std::string written(const ReportDocument& document, const std::string& how = "-layout") const {
    const std::filesystem::path file = folder_ / "sheet.pdf";
    EXPECT_TRUE(succeeded(writeReportPdf(document, {}, PaperSize::a4, file)));
    return said("pdftotext " + how + " " + file.string() + " -").text;
  }
  const TemporaryFolder folder_;
};

TEST_F(WorksheetOnPaper, SaysWhatTheSheetSaysWhoseItIsAndThatItIsASimulation) {
  EW_NEEDS_PROGRAM("pdftotext");
  const Worksheet sheet = biometry();
  const std::string text = written(worksheetReport(sheet, about(2)));
  for (const std::string part : {"Obstetric biometry", "Pain, \"here\", 02.01.26 03:04", "Simulation, training only: not for diagnosis.",
                                 "Examined by: Anna", "Gestational age by dates: 32w1d", "Biparietal diameter", "8.200 ± 0.080 cm",
                                 "mean of 6.180; 6.220", "so the dates stay.", "Images", "1. caption0", "2. caption1", "Page 1 of"})
    EXPECT_TRUE(holds(text, part)) << part << "\n" << text;
  std::size_t lines = 0;
  const auto expectWords = [&](const Message& message) {
    static const std::regex word("[A-Za-z0-9.]+");  // a line may end behind a hyphen
    const std::string all = message.english();
    for (std::sregex_iterator at(all.begin(), all.end(), word), end; at != end; ++at)
      EXPECT_TRUE(holds(text, at->str())) << at->str() << " of " << all;
    ++lines;
  };
  for (const auto& section : sheet.sections)
    for (const auto& row : section.rows) {
      const measurement::WorksheetLine line = lineOf(row);
      expectWords(line.title);
      EXPECT_TRUE(holds(text, line.value.english())) << line.value << " is not on one line\n" << text;
      for (const auto* more : {&line.origin, &line.against})
        for (const Message& message : *more) expectWords(message);
    }
  EXPECT_GT(lines, 40u);
}

TEST_F(WorksheetOnPaper, IsA4AndDatedByTheMomentItWasMade) {
  EW_NEEDS_PROGRAM("pdfinfo");
  const ReportDocument document = worksheetReport(biometry(), about());
  (void)written(document);
  const std::string info = said("pdfinfo " + (folder_ / "sheet.pdf").string()).text;
  EXPECT_TRUE(holds(info, "(A4)")) << info;
  EXPECT_TRUE(std::regex_search(info, std::regex("Title: +Obstetric biometry"))) << info;
  const auto pdf = pdfOf(document, {}), again = pdfOf(document, {});
  ASSERT_TRUE(succeeded(pdf));
  EXPECT_TRUE(holds(*pdf, "/CreationDate (20260102030400"));
  EXPECT_EQ(*pdf, *again);
}

TEST_F(WorksheetOnPaper, HasItsTitlesInTheLanguageThatWasAskedFor) {
  EW_NEEDS_PROGRAM("pdftotext");
  const std::string text = written(worksheetReport(biometry(), {}, "de"));
  EXPECT_TRUE(holds(text, "Fetale Biometrie")) << text;
  EXPECT_FALSE(holds(text, "Biparietal diameter")) << text;
  EXPECT_FALSE(holds(text, "Examined by")) << "nobody was named\n" << text;
}

TEST_F(WorksheetOnPaper, HasTwoImagesInARow) {
  EW_NEEDS_PROGRAM("pdftotext");
  const std::string boxes = written(worksheetReport(biometry(), about(5)), "-bbox");
  struct Place {
    double x = 0.0, y = 0.0;
  };
  std::vector<Place> places;
  for (int n = 0; n < 5; ++n) {
    std::smatch found;
    const std::regex word("xMin=\"([0-9.]+)\" yMin=\"([0-9.]+)\"[^>]*>caption" + std::to_string(n) + "<");
    ASSERT_TRUE(std::regex_search(boxes, found, word)) << n << "\n" << boxes;
    places.push_back({std::stod(found[1]), std::stod(found[2])});
  }
  for (const int left : {0, 2}) {
    const Place& one = places[static_cast<std::size_t>(left)];
    const Place& other = places[static_cast<std::size_t>(left) + 1];
    EXPECT_NEAR(one.y, other.y, 0.01);
    EXPECT_GT(other.x, one.x + 200.0);
  }
  EXPECT_NEAR(places[4].x, places[0].x, 0.01) << "the last one alone begins a row";
}

TEST_F(WorksheetOnPaper, IsAPageToo) {
  const std::string page = htmlOf(worksheetReport(biometry(), about(1)), {});
  EXPECT_TRUE(holds(page, "<br><span class='soft'>mean of 6.180; 6.220</span>")) << page;
  EXPECT_TRUE(holds(page, "<figure class='small'><img alt='1. caption0' src='data:image/png;base64,"));
  EXPECT_FALSE(holds(page, "<caption></caption>"));
}

}  // namespace
}  // namespace ew::test::worksheet_report_test
