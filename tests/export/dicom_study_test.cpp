#include "ew/export/dicom_study.h"

#include <set>

#include "export_world.h"

namespace ew::dicom_study_test {
namespace {
using namespace test;

TEST(DicomUid, IsTheDecimalNumberOfARandomUuid) {
  // f81d4fae-7dec-41d0-a765-00a0c91e6bf6, the number as another language computes it.
  EXPECT_EQ(dicomUidOf(0xf81d4fae7dec41d0ULL, 0xa76500a0c91e6bf6ULL), "2.25.329800735698586855969233156254476430326");
  EXPECT_EQ(dicomUidOf(0, 0), dicomUidOf(0x4000, 0x8000000000000000ULL));
}

TEST(DicomUid, IsNewEachTimeAndOneThatArchivesTake) {
  std::set<std::string> uids;
  for (int n = 0; n < 1000; ++n) {
    const std::string uid = newDicomUid();
    EXPECT_TRUE(isDicomUid(uid)) << uid;
    EXPECT_TRUE(uids.insert(uid).second) << uid;
  }
}

TEST(DicomUid, OfAWrongFormIsToldApart) {
  for (const char* good : {"1", "1.2.840.10008.1.1", "2.25.0", "0.1"}) EXPECT_TRUE(isDicomUid(good)) << good;
  for (const char* bad : {"", ".", "1.", ".1", "1..2", "1.02", "1.2a", "1 2"}) EXPECT_FALSE(isDicomUid(bad)) << bad;
  EXPECT_TRUE(isDicomUid(std::string(64, '1')));
  EXPECT_FALSE(isDicomUid(std::string(65, '1')));
}

TEST(DicomStudy, OfACaseHasItsInventedPatientAndTheTitleForTrainees) {
  Case examined;
  examined.id = "gall-stone";
  examined.title = "Gall stone";
  examined.titleForTrainees = "Upper abdomen, pain after meals";
  examined.patient = {"Maren Achterberg", "female", 29};
  const auto first = beginStudy(examined, {}), second = beginStudy(examined, {});
  EXPECT_EQ(first.patient.name, "Maren Achterberg");
  EXPECT_TRUE(first.patient.id.starts_with("EWSIM-")) << first.patient.id;
  EXPECT_EQ(first.patient.id.find("stone"), std::string::npos) << "the id of a case often names its finding";
  EXPECT_EQ(second.patient.id, first.patient.id);
  Case open = examined;
  open.titleForTrainees.clear();
  EXPECT_EQ(beginStudy(open, {}).patient.id, "EWSIM-gall-stone") << "nothing to hide";
  open.id = "another";
  open.titleForTrainees = examined.titleForTrainees;
  EXPECT_NE(beginStudy(open, {}).patient.id, first.patient.id);
  EXPECT_EQ(first.title, "Upper abdomen, pain after meals");
  const std::set<std::string> uids{first.studyUid, first.imagesUid, first.reportsUid, second.studyUid, second.imagesUid, second.reportsUid};
  EXPECT_EQ(uids.size(), 6u);
}

}  // namespace
}  // namespace ew::dicom_study_test
