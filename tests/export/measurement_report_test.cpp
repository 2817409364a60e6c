#include "ew/export/measurement_report.h"

#include "ew/export/dicom_image.h"
#include "ew/measurement/package.h"
#include "export_world.h"
#include "places.h"

namespace ew::measurement_report_test {
namespace {
using namespace test;
using namespace measurement;
namespace fs = std::filesystem;

Worksheet filled(const std::string& package, const WorksheetInput& input) {
  const auto read = readPackage(fs::path(EW_SOURCE_DIR) / "resources" / "measurements" / (package + ".json"));
  EXPECT_TRUE(succeeded(read));
  auto sheet = fillWorksheet(*read, input);
  EXPECT_TRUE(succeeded(sheet));
  return *sheet;
}

Worksheet obstetricSheet() {
  WorksheetInput input;
  input.entries = {{"BPD", "", {82.0, 0.9, Unit::mm}, "", false}, {"BPD", "", {82.6, 0.9, Unit::mm}, "", false},
                   {"HC", "", {300.0, 2.0, Unit::mm}, "", false}, {"AC", "", {280.0, 3.0, Unit::mm}, "", false},
                   {"FL", "", {62.0, 0.5, Unit::mm}, "", false},  {"OFD", "", {104.0, 1.0, Unit::mm}, "", false},
                   {"CRL", "", {60.0, 0.5, Unit::mm}, "", false}};
  input.gestation_weeks = 32.0 + 1.0 / 7.0;
  return filled("obstetric", input);
}

Worksheet vesselSheet() {
  WorksheetInput input;
  input.entries = {{"D_MIN", "left", {1.5, 0.2, Unit::mm}, "", false},
                   {"D_DISTAL", "left", {5.0, 0.2, Unit::mm}, "", false},
                   {"D_MIN", "right", {4.5, 0.2, Unit::mm}, "", false}};
  return filled("vessel", input);
}

MeasurementReportOptions someReport() {
  MeasurementReportOptions options;
  options.instanceUid = dicomUidOf(3, 1);
  options.made = someStudy().begun;
  options.images = {{kUsImageClass, dicomUidOf(2, 1)}, {kUsMultiframeClass, dicomUidOf(2, 2)}};
  return options;
}

/// Lines of a text that hold all of these parts.
std::size_t linesWith(const std::string& text, const std::vector<std::string>& parts) {
  std::istringstream lines(text);
  std::size_t found = 0;
  for (std::string line; std::getline(lines, line);)
    found += std::all_of(parts.begin(), parts.end(), [&](const std::string& part) { return line.find(part) != std::string::npos; }) ? 1 : 0;
  return found;
}

/// Warnings and errors of DCMTK, but for the one about its own check of UTF-8.
std::string complaintsIn(const std::string& text) {
  std::string complaints;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if ((line.starts_with("W:") || line.starts_with("E:")) && line.find("VR checker does not support") == std::string::npos)
      complaints += line + "\n";
  return complaints;
}

/// What the tree looks like to DCMTK's reader of reports, codes included; a line an item, indented.
Said tree(const fs::path& file) { return said("dsrdump +Pc +U8 +Pl " + file.string()); }

std::string errorsOf(const fs::path& file) {
  std::string errors;
  std::istringstream lines(said("dciodvfy " + file.string()).text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("Error")) errors += line + "\n";
  return errors;
}

TEST(MeasurementReport, OfObstetricsIsATreeOfTid5000) {
  EW_NEEDS_PROGRAM("dsrdump");
  const TemporaryFolder folder;
  const auto written = writeMeasurementReport(obstetricSheet(), someReport(), someStudy(), folder / "a.dcm");
  ASSERT_TRUE(succeeded(written));
  EXPECT_EQ(*written, (DicomReference{kComprehensiveSrClass, dicomUidOf(3, 1)}));
  const Said report = tree(folder / "a.dcm");
  EXPECT_EQ(report.status, 0) << report.text;
  EXPECT_EQ(complaintsIn(report.text), "");
  const std::string& text = report.text;
  for (const char* heading : {"(125000,DCM,\"OB-GYN Ultrasound Procedure Report\")", "(121111,DCM,\"Summary\")",
                              "(125008,DCM,\"Fetus Summary\")", "(125001,DCM,\"Fetal Biometry Ratios\")", "(125002,DCM,\"Fetal Biometry\")",
                              "(125009,DCM,\"Early Gestation\")", "(111028,DCM,\"Image Library\")"})
    EXPECT_NE(text.find(heading), std::string::npos) << heading << "\n" << text;
  // Both measurements, and their mean with its derivation.
  EXPECT_EQ(linesWith(text, {"NUM", "(11820-8,LN,\"Biparietal Diameter\")", "\"8.2\" (cm,UCUM,\"centimeter\")", "contains"}), 1u) << text;
  EXPECT_EQ(linesWith(text, {"NUM", "(11820-8,LN,\"Biparietal Diameter\")", "\"8.23\" (cm,UCUM", "contains"}), 1u) << text;
  EXPECT_EQ(linesWith(text, {"has properties", "(121404,DCM,\"Selection Status\")", "(121412,DCM,\"Mean value chosen\")"}), 1u);
  EXPECT_EQ(linesWith(text, {"contains NUM", "(11963-6,LN,\"Femur Length\")", "\"6.2\" (cm,UCUM"}), 1u) << text;
  EXPECT_EQ(linesWith(text, {"inferred from CODE", "(121420,DCM,\"Equation\")", "(11732-5,LN,"}), 1u) << text;
  EXPECT_EQ(linesWith(text, {"contains NUM", "(11885-1,LN,\"Gestational Age by LMP\")", "\"32.142857"}), 1u) << text;
  EXPECT_GE(linesWith(text, {"contains NUM", "(18185-9,LN,\"Gestational Age\")", "wk"}), 4u) << text;
  EXPECT_GE(linesWith(text, {"has properties NUM", "(121415,DCM,\"Percentile Ranking of measurement\")"}), 1u) << text;
  EXPECT_GE(linesWith(text, {"has properties NUM", "(386136009,SCT,\"Standard Deviation\")"}), 7u) << text;
  EXPECT_EQ(linesWith(text, {"contains IMAGE"}), 2u) << text;
  EXPECT_GE(linesWith(text, {"not for diagnosis"}), 1u) << text;
}

TEST(MeasurementReport, HasEachValueOfTheWorksheetOnce) {
  EW_NEEDS_PROGRAM("dsrdump");
  const TemporaryFolder folder;
  const Worksheet sheet = obstetricSheet();
  ASSERT_TRUE(succeeded(writeMeasurementReport(sheet, someReport(), someStudy(), folder / "a.dcm")));
  const std::string text = tree(folder / "a.dcm").text;
  std::size_t values = 1;  // gestational age by dates
  for (const SectionValues& section : sheet.sections)
    for (const WorksheetRow& row : section.rows) values += (row.value ? 1 : 0) + (row.measured.size() > 1 ? row.measured.size() : 0);
  EXPECT_EQ(linesWith(text, {"contains NUM"}), values) << text;
}

TEST(MeasurementReport, OfOtherPackagesIsATreeOfTid1500WithAGroupForEachSide) {
  EW_NEEDS_PROGRAM("dsrdump");
  const TemporaryFolder folder;
  ASSERT_TRUE(succeeded(writeMeasurementReport(vesselSheet(), someReport(), someStudy(), folder / "a.dcm")));
  const Said report = tree(folder / "a.dcm");
  EXPECT_EQ(report.status, 0) << report.text;
  EXPECT_EQ(complaintsIn(report.text), "");
  const std::string& text = report.text;
  EXPECT_EQ(linesWith(text, {"CONTAINER", "(126000,DCM,\"Imaging Measurement Report\")"}), 1u) << text;
  EXPECT_EQ(linesWith(text, {"(126010,DCM,\"Imaging Measurements\")"}), 1u) << text;
  EXPECT_EQ(linesWith(text, {"(112040,DCM,\"Tracking Unique Identifier\")"}), linesWith(text, {"(125007,DCM,\"Measurement Group\")"}));
  EXPECT_GE(linesWith(text, {"(125007,DCM,\"Measurement Group\")"}), 2u) << text;
  EXPECT_EQ(linesWith(text, {"contains NUM", "(vessel.D_MIN,99ECHOWEAVE,", "\"1.5\" (mm,UCUM"}), 1u) << text;
  EXPECT_EQ(linesWith(text, {"contains NUM", "(vessel.NASCET,99ECHOWEAVE,", "\"70\" (%,UCUM"}), 1u) << text;
  EXPECT_GE(linesWith(text, {"has concept mod CODE", "(272741003,SCT,\"Laterality\")", "(7771000,SCT,\"Left\")"}), 3u) << text;
  EXPECT_GE(linesWith(text, {"has concept mod CODE", "(272741003,SCT,\"Laterality\")", "(24028007,SCT,\"Right\")"}), 1u) << text;
}

TEST(MeasurementReport, HasAnswersAsCodesAndTheirSummaryAsText) {
  EW_NEEDS_PROGRAM("dsrdump");
  const TemporaryFolder folder;
  WorksheetInput input;
  input.entries = {{"RUQ", "", {}, "seen", false}, {"LUNG", "left", {}, "absent", false}};
  const Worksheet sheet = filled("trauma", input);
  ASSERT_TRUE(succeeded(writeMeasurementReport(sheet, someReport(), someStudy(), folder / "a.dcm")));
  const std::string text = tree(folder / "a.dcm").text;
  EXPECT_EQ(linesWith(text, {"contains CODE", "(trauma.RUQ,99ECHOWEAVE,", "(trauma.seen,99ECHOWEAVE,"}), 1u) << text;
  EXPECT_EQ(linesWith(text, {"contains CODE", "(trauma.LUNG,99ECHOWEAVE,", "(trauma.absent,99ECHOWEAVE,"}), 1u) << text;
  ASSERT_FALSE(sheet.summaries.empty());
  EXPECT_EQ(linesWith(text, {"contains TEXT", sheet.summaries.front().says.english}), 1u) << text;
}

TEST(MeasurementReport, IsWithoutFaultToDicom3tools) {
  EW_NEEDS_PROGRAM("dciodvfy");
  const TemporaryFolder folder;
  for (const Worksheet& sheet : {obstetricSheet(), vesselSheet()}) {
    ASSERT_TRUE(succeeded(writeMeasurementReport(sheet, someReport(), someStudy(), folder / "a.dcm")));
    EXPECT_EQ(errorsOf(folder / "a.dcm"), "") << sheet.package;
  }
}

TEST(MeasurementReport, BelongsToTheStudyOfItsImagesAndNamesThem) {
  EW_NEEDS_PROGRAM("dcmdump");
  const TemporaryFolder folder;
  ASSERT_TRUE(succeeded(writeMeasurementReport(obstetricSheet(), someReport(), someStudy(), folder / "a.dcm")));
  const std::string dump = said("dcmdump +U8 " + (folder / "a.dcm").string()).text;
  for (const std::string& part :
       {"(0020,000d) UI [" + someStudy().studyUid + "]", "(0020,000e) UI [" + someStudy().reportsUid + "]",
        "(0008,0018) UI [" + dicomUidOf(3, 1) + "]", std::string("(0010,0010) PN [Ödland^Änne von der]"),
        std::string("(0040,a491) CS [COMPLETE]"), std::string("(0040,a493) CS [UNVERIFIED]"), std::string("(0040,a375) SQ")})
    EXPECT_NE(dump.find(part), std::string::npos) << part << "\n" << dump;
  EXPECT_EQ(linesWith(dump, {"(0008,1155) UI [" + dicomUidOf(2, 2) + "]"}), 2u);  // as evidence and in the library of images
}

TEST(MeasurementReport, ThatNobodyCouldUseIsRefusedAndLeavesNothing) {
  const TemporaryFolder folder;
  MeasurementReportOptions nameless = someReport();
  nameless.instanceUid = "x";
  EXPECT_FALSE(writeMeasurementReport(obstetricSheet(), nameless, someStudy(), folder / "a.dcm"));
  const auto empty = writeMeasurementReport(Worksheet{}, someReport(), someStudy(), folder / "a.dcm");
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.error().sentence(), "The worksheet is empty; measure something first.");
  EXPECT_EQ(namesIn(folder.path()), std::set<std::string>{});
}

}  // namespace
}  // namespace ew::measurement_report_test
