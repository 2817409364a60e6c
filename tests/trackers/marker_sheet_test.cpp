#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/aruco.hpp>
#include <opencv2/aruco/charuco.hpp>
#include <opencv2/imgproc.hpp>
#include <sstream>

#include "ew/trackers/marker_sheet.h"
#include "places.h"

namespace ew::marker_sheet_test {
namespace {

namespace fs = std::filesystem;

const fs::path kBodies = fs::path(EW_SOURCE_DIR) / "resources" / "marker_bodies";
constexpr double kDotsPerInch = 300.0;
constexpr double kMmPerDot = 25.4 / kDotsPerInch;

std::vector<PaperBody> shippedBodies() {
  const auto read = readPaperBodies({kBodies});
  if (!read) throw std::runtime_error(read.error().sentence());
  return *read;
}

PaperBody paper(const std::string& id) {
  for (const PaperBody& body : shippedBodies())
    if (body.id == id) return body;
  throw std::runtime_error(id);
}

class MarkerSheet : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(::testing::TempDir()) /
              ("ew_marker_sheet_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }
  static bool hasPoppler() { return std::system("command -v pdftoppm >/dev/null 2>&1 && command -v pdftotext >/dev/null 2>&1") == 0; }
  /// The pages of a PDF as grey images of 300 dots an inch.
  std::vector<cv::Mat> rendered(const fs::path& pdf) {
    const std::string command = "pdftoppm -gray -r 300 '" + pdf.string() + "' '" + (folder_ / "page").string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0);
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder_))
      if (entry.path().extension() == ".pgm") files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<cv::Mat> pages;
    for (const fs::path& file : files) {
      std::ifstream in(file, std::ios::binary);
      std::string kind;
      int width = 0, height = 0, most = 0;
      in >> kind >> width >> height >> most;
      in.get();
      cv::Mat page(height, width, CV_8UC1);
      in.read(reinterpret_cast<char*>(page.data), static_cast<std::streamsize>(page.total()));
      EXPECT_TRUE(in) << file;
      pages.push_back(page);
    }
    return pages;
  }
  fs::path folder_;
};

/// Where the markers of a page are seen: id to four corners in mm. Edges of pixels, not their centres, are what lengths are counted from.
std::map<int, std::array<glm::dvec2, 4>> seen(const cv::Mat& page, const std::string& dictionary) {
  const auto known =
      cv::aruco::getPredefinedDictionary(dictionary == "apriltag_36h11" ? cv::aruco::DICT_APRILTAG_36h11 : cv::aruco::DICT_5X5_100);
  const auto parameters = cv::aruco::DetectorParameters::create();
  parameters->cornerRefinementMethod = cv::aruco::CORNER_REFINE_SUBPIX;
  parameters->cornerRefinementWinSize = 9;
  parameters->minMarkerPerimeterRate = 0.02;
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(page, known, corners, ids, parameters);
  std::map<int, std::array<glm::dvec2, 4>> found;
  for (std::size_t n = 0; n < ids.size(); ++n)
    for (std::size_t c = 0; c < 4; ++c)
      found[ids[n]][c] = kMmPerDot * (glm::dvec2(static_cast<double>(corners[n][c].x), static_cast<double>(corners[n][c].y)) + 0.5);
  return found;
}

TEST_F(MarkerSheet, EveryBodyFitsBothPapersWithItsMarginsScalesAndSteps) {
  for (const PaperSize size : {PaperSize::a4, PaperSize::letter})
    for (const char* language : {"en", "de"})
      for (const PaperBody& body : shippedBodies()) {
        const auto page = layOut(body, size, language);
        ASSERT_TRUE(page) << body.id << page.error();
        const auto inside = [&](const glm::dvec2& p) {
          return p.x > 7.99 && p.y > 7.99 && p.x < page->size_mm.x - 7.99 && p.y < page->size_mm.y - 7.99;
        };
        for (const SheetLine& line : page->lines) EXPECT_TRUE(inside(line.from) && inside(line.to)) << body.id;
        for (const SheetMarker& marker : page->markers)
          for (const glm::dvec2& corner : marker.corners) EXPECT_TRUE(inside(corner)) << body.id;
        for (const SheetText& text : page->texts) EXPECT_TRUE(inside(text.at) && inside(text.at + text.box_mm)) << body.id;
        for (const SheetLine& scale : page->scales) {
          EXPECT_NEAR(glm::distance(scale.from, scale.to), 100.0, 1e-9);
          EXPECT_TRUE(inside(scale.from) && inside(scale.to));
        }
        EXPECT_NEAR(glm::dot(page->scales[0].to - page->scales[0].from, page->scales[1].to - page->scales[1].from), 0.0, 1e-9);
        std::size_t steps = 0;
        for (const SheetText& text : page->texts) steps = std::max(steps, text.paragraphs.size());
        EXPECT_EQ(steps, 4u);
      }
}

TEST_F(MarkerSheet, ANetFoldedFromTheSheetIsTheBodyTheCameraLooksFor) {
  for (const PaperBody& body : shippedBodies()) {
    if (body.kind == PaperKind::calibration) continue;
    const auto page = layOut(body, PaperSize::a4);
    ASSERT_TRUE(page) << page.error();
    const MarkerBody folded = foldedBody(body);
    const auto flat = panelPoses(body, 0.0), bent = panelPoses(body, 1.0);
    // Each marker of the sheet goes back to its panel and is carried along as that is folded; what is left is one shift for all.
    std::optional<glm::dvec3> shift;
    std::size_t marker = 0;
    for (std::size_t n = 0; n < body.panels.size(); ++n)
      for (std::size_t m = 0; m < body.panels[n].markers.size(); ++m, ++marker) {
        ASSERT_EQ(page->markers[marker].id, folded.markers[marker].id);
        for (std::size_t c = 0; c < 4; ++c) {
          const glm::dvec2 p = page->markers[marker].corners[c];
          const glm::dvec4 net(p.x - page->netAt.x, page->netAt.y - p.y, 0.0, 1.0);
          const glm::dvec3 carried3(bent[n] * glm::inverse(flat[n]) * net);
          if (!shift) shift = folded.markers[marker].corners_mm[c] - carried3;
          EXPECT_NEAR(glm::distance(carried3 + *shift, folded.markers[marker].corners_mm[c]), 0.0, 1e-9) << body.id;
        }
      }
    EXPECT_EQ(marker, folded.markers.size());
  }
}

TEST_F(MarkerSheet, PrintedMarkersAreSeenWithinATenthOfAMillimetreOfWhereTheSheetHasThem) {
  if (!hasPoppler()) GTEST_SKIP() << "pdftoppm (poppler-utils) is not installed";
  const auto bodies = shippedBodies();
  const auto written = writeMarkerSheet(bodies, PaperSize::a4, folder_ / "sheet.pdf");
  ASSERT_TRUE(written) << written.error();
  const auto pages = rendered(folder_ / "sheet.pdf");
  ASSERT_EQ(pages.size(), bodies.size());
  double worst_mm = 0.0;
  for (std::size_t n = 0; n < bodies.size(); ++n) {
    const auto page = layOut(bodies[n], PaperSize::a4);
    ASSERT_TRUE(page);
    EXPECT_NEAR(pages[n].cols * kMmPerDot, page->size_mm.x, 0.1);
    const auto found = seen(pages[n], bodies[n].dictionary);
    EXPECT_EQ(found.size(), page->markers.size()) << bodies[n].id;
    for (const SheetMarker& marker : page->markers) {
      const auto here = found.find(marker.id);
      ASSERT_NE(here, found.end()) << bodies[n].id << " " << marker.id;
      for (std::size_t c = 0; c < 4; ++c) worst_mm = std::max(worst_mm, glm::distance(here->second[c], marker.corners[c]));
    }
  }
  EXPECT_LT(worst_mm, 0.1);
  RecordProperty("worst_um", static_cast<int>(1000.0 * worst_mm));
}

TEST_F(MarkerSheet, TheChessBoardIsTheOneThatOpenCvLooksFor) {
  if (!hasPoppler()) GTEST_SKIP() << "pdftoppm (poppler-utils) is not installed";
  const PaperBody body = paper("calibration-board");
  ASSERT_TRUE(writeMarkerSheet({&body, 1}, PaperSize::letter, folder_ / "board.pdf"));
  const auto pages = rendered(folder_ / "board.pdf");
  ASSERT_EQ(pages.size(), 1u);
  const CalibrationBoard board = printedBoard(body);
  const auto dictionary = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_5X5_100);
  const auto theirs = cv::aruco::CharucoBoard::create(board.columns, board.rows, static_cast<float>(board.square_mm),
                                                      static_cast<float>(board.marker_mm), dictionary);
  std::vector<std::vector<cv::Point2f>> corners;
  std::vector<int> ids;
  cv::aruco::detectMarkers(pages[0], dictionary, corners, ids);
  EXPECT_EQ(ids.size(), theirs->ids.size());
  cv::Mat inner, innerIds;
  ASSERT_EQ(cv::aruco::interpolateCornersCharuco(corners, ids, pages[0], theirs, inner, innerIds), (board.columns - 1) * (board.rows - 1));
  // Between any two inner corners lies what the board says.
  double worst_mm = 0.0;
  for (int a = 0; a < inner.rows; ++a)
    for (int b = 0; b < a; ++b) {
      const auto p = inner.at<cv::Point2f>(a) - inner.at<cv::Point2f>(b);
      const auto q = theirs->chessboardCorners[static_cast<std::size_t>(innerIds.at<int>(a))] -
                     theirs->chessboardCorners[static_cast<std::size_t>(innerIds.at<int>(b))];
      worst_mm = std::max(worst_mm, std::abs(kMmPerDot * std::hypot(static_cast<double>(p.x), static_cast<double>(p.y)) -
                                             std::hypot(static_cast<double>(q.x), static_cast<double>(q.y))));
    }
  EXPECT_LT(worst_mm, 0.1);
}

TEST_F(MarkerSheet, NoWordIsCutAndTheMarginsStayWhite) {
  if (!hasPoppler()) GTEST_SKIP() << "pdftoppm (poppler-utils) is not installed";
  for (const PaperSize size : {PaperSize::a4, PaperSize::letter}) {
    const auto bodies = shippedBodies();
    ASSERT_TRUE(writeMarkerSheet(bodies, size, folder_ / "sheet.pdf"));
    const auto pages = rendered(folder_ / "sheet.pdf");
    for (const cv::Mat& page : pages) {
      const int margin = static_cast<int>(7.5 / kMmPerDot);
      cv::Mat inner = page.clone();
      inner(cv::Rect(margin, margin, page.cols - 2 * margin, page.rows - 2 * margin)).setTo(255);
      EXPECT_EQ(cv::countNonZero(inner < 250), 0);
    }
    ASSERT_EQ(std::system(("pdftotext '" + (folder_ / "sheet.pdf").string() + "' '" + (folder_ / "sheet.txt").string() + "'").c_str()), 0);
    std::ifstream in(folder_ / "sheet.txt");
    std::stringstream text;
    for (std::string word; in >> word;) text << word << " ";
    for (const PaperBody& body : bodies) {
      const auto page = layOut(body, size);
      ASSERT_TRUE(page);
      for (const SheetText& block : page->texts)
        for (const Message& paragraph : block.paragraphs) EXPECT_NE(text.str().find(paragraph.english()), std::string::npos) << paragraph;
    }
  }
}

TEST_F(MarkerSheet, ABodyLargerThanTheSheetIsRefusedByName) {
  PaperBody body = paper("box-60");
  for (PaperPanel& panel : body.panels) {
    panel.width_mm *= 1.2;
    panel.height_mm *= 1.2;
    panel.end_mm *= 1.2;
  }
  const auto page = layOut(body, PaperSize::a4);
  ASSERT_FALSE(page);
  EXPECT_EQ(page.error().code, ErrorCode::tooLarge);
  EXPECT_NE(page.error().sentence().find("box-60"), std::string::npos);
  EXPECT_FALSE(writeMarkerSheet({&body, 1}, PaperSize::a4, folder_ / "sheet.pdf"));
  EXPECT_FALSE(fs::exists(folder_ / "sheet.pdf"));
}

TEST_F(MarkerSheet, AMeasuredScaleIsAFactorUnlessThePrinterFittedThePage) {
  EXPECT_DOUBLE_EQ(*printedFactor(98.0), 0.98);
  EXPECT_DOUBLE_EQ(*printedFactor(100.0), 1.0);
  for (const double wrong : {89.0, 111.0, 0.0, -100.0, std::nan("")}) EXPECT_FALSE(printedFactor(wrong)) << wrong;
}

}  // namespace
}  // namespace ew::marker_sheet_test
