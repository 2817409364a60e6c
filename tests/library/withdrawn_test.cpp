#include "ew/library/withdrawn.h"

#include <gtest/gtest.h>

#include "ew/library/bundle.h"
#include "ew/library/case.h"
#include "ew/library/checksums.h"
#include "ew/library/folder_lease.h"
#include "ew/library/instructor_log.h"
#include "ew/library/published.h"
#include "library/bundle_world.h"

namespace ew::test::withdrawn_test {
namespace {

namespace fs = std::filesystem;

/// Publishes revisions 1 and 2 of knee.
void publishTwo(const TemporaryFolder& folder) {
  makeVolumeCase(folder / "knee", "knee");
  for (const int revision : {1, 2}) {
    writeText(folder / "knee/scans/expert.txt", std::to_string(revision));
    const auto published = publishCase(folder / "knee", folder / "library");
    ASSERT_TRUE(published) << published.error();
    ASSERT_EQ(published->revision, revision);
  }
}

/// What an earlier program left: the revisions aside, and the last number as an empty folder.
void withdrawAsBefore(const TemporaryFolder& folder) {
  fs::create_directories(folder / "library/withdrawn");
  fs::rename(folder / "library/published/knee", folder / "library/withdrawn/then-knee");
  fs::create_directories(folder / "library/published/knee/2");
}

void expectSound(const fs::path& library, const std::vector<int>& revisions) {
  std::vector<int> found;
  for (const CaseRevision& each : takenPublished(library, "knee")) {
    found.push_back(each.revision);
    const auto check = verifyCase(each.folder);
    ASSERT_TRUE(check) << check.error();
    EXPECT_TRUE(check->problems.empty()) << each.revision;
  }
  EXPECT_EQ(found, revisions);
}

TEST(WithdrawCase, MovesAnOwnCaseAndKeepsEveryByte) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "library/cases/knee", "knee");
  const auto before = treeOf(folder / "library/cases/knee");
  const auto taken = withdrawCase(folder / "library/cases/knee", folder / "library");
  ASSERT_TRUE(taken) << taken.error();
  EXPECT_FALSE(fs::exists(folder / "library/cases/knee"));
  EXPECT_EQ(taken->folder.parent_path(), withdrawnFolder(folder / "library"));
  EXPECT_EQ(treeOf(taken->folder), before);
  fs::rename(taken->folder, taken->from);
  EXPECT_TRUE(loadCase(folder / "library/cases/knee"));
}

TEST(WithdrawCase, TakesAllRevisionsOfAPublishedOne) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "knee", "knee");
  const auto first = publishCase(folder / "knee", folder / "library");
  ASSERT_TRUE(first) << first.error();
  const auto taken = withdrawCase(first->folder, folder / "library");
  ASSERT_TRUE(taken) << taken.error();
  EXPECT_TRUE(listPublished(folder / "library").empty());
  EXPECT_FALSE(fs::exists(folder / "library/published/knee"));
  EXPECT_TRUE(fs::exists(taken->folder / "1/case.json"));
  const auto again = publishCase(folder / "knee", folder / "library");
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(again->revision, 2) << "attempts at revision 1 must not find another content under its number";
  EXPECT_FALSE(again->wasThere);
  EXPECT_TRUE(withdrawCase(folder / "library/published/knee", folder / "library")) << "beside the one before";
}

TEST(WithdrawCase, LeavesNoNumberForAnotherContentThoughItsFolderIsDeleted) {
  const TemporaryFolder folder;
  publishTwo(folder);
  ASSERT_TRUE(withdrawCase(folder / "library/published/knee", folder / "library"));
  fs::remove_all(withdrawnFolder(folder / "library"));
  expectSound(folder / "library", {});
  writeText(folder / "knee/scans/expert.txt", "elsewhere");
  ASSERT_EQ(publishCase(folder / "knee", folder / "author")->revision, 1);
  ASSERT_TRUE(exportBundle(folder / "author/published/knee/1", folder / "1.ewcase"));
  const auto imported = importBundle(folder / "1.ewcase", folder / "library");
  ASSERT_TRUE(imported) << imported.error();
  EXPECT_EQ(imported->revision, 3) << "1 was another content here";
  ASSERT_TRUE(withdrawCase(imported->folder, folder / "library"));
  fs::remove_all(withdrawnFolder(folder / "library"));
  EXPECT_EQ(publishCase(folder / "knee", folder / "library")->revision, 4);
  expectSound(folder / "library", {4});
}

TEST(WithdrawCase, IsUndoneByMovingTheRevisionsBack) {
  const TemporaryFolder folder;
  publishTwo(folder);
  for (int round = 1; round <= 2; ++round) {
    const auto taken = withdrawCase(folder / "library/published/knee/2", folder / "library");
    ASSERT_TRUE(taken) << taken.error();
    EXPECT_FALSE(latestPublished(folder / "library", "knee"));
    EXPECT_FALSE(fs::exists(taken->from)) << "else `mv` puts the case into it";
    fs::rename(taken->folder, taken->from);
    ASSERT_EQ(listPublished(folder / "library").size(), 1u);
    EXPECT_EQ(latestPublished(folder / "library", "knee")->revision, 2);
    expectSound(folder / "library", {1, 2});
  }
  EXPECT_TRUE(publishCase(folder / "knee", folder / "library")->wasThere);
  writeText(folder / "knee/scans/expert.txt", "3");
  EXPECT_EQ(publishCase(folder / "knee", folder / "library")->revision, 3);
}

TEST(TakenPublished, TakesTheEmptyFolderOfAnEarlierProgramForANumberAndNotForARevision) {
  const TemporaryFolder folder;
  publishTwo(folder);
  withdrawAsBefore(folder);
  expectSound(folder / "library", {});
  EXPECT_EQ(caseToWithdraw("knee", folder / "library").error().code, ErrorCode::notFound);
  EXPECT_EQ(publishCase(folder / "knee", folder / "library")->revision, 3);
  expectSound(folder / "library", {3});
  ASSERT_TRUE(withdrawCase(folder / "library/published/knee/3", folder / "library"));
  fs::remove_all(withdrawnFolder(folder / "library"));
  EXPECT_EQ(publishCase(folder / "knee", folder / "library")->revision, 4);
}

TEST(WithdrawCase, IsWrittenDownUnderTheIdOfTheCaseOrNotDone) {
  const TemporaryFolder folder;
  publishTwo(folder);
  makeVolumeCase(folder / "library/cases/first try", "elbow");
  ASSERT_TRUE(withdrawCase(folder / "library/published/knee/2/", folder / "library"));
  const auto own = withdrawCase(folder / "library/cases/first try/", folder / "library", "Anna Quill");
  ASSERT_TRUE(own) << own.error();
  EXPECT_EQ(own->id, "elbow");
  const auto log = readInstructorLog(folder / "library");
  ASSERT_TRUE(log) << log.error();
  ASSERT_EQ(log->changes.size(), 2u);
  for (const InstructorChange& each : log->changes) EXPECT_EQ(each.what, "case withdrawn");
  EXPECT_EQ(log->changes[0].of, "knee");
  EXPECT_EQ(log->changes[1].of, "elbow");
  EXPECT_EQ(log->changes[1].who, accountName("Anna Quill"));
  EXPECT_EQ(log->changes[1].after, own->folder.string());

  makeVolumeCase(folder / "library/cases/wrist", "wrist");
  fs::remove_all(assessmentFolder(folder / "library"));
  writeText(assessmentFolder(folder / "library"), "no folder");
  EXPECT_EQ(withdrawCase(folder / "library/cases/wrist", folder / "library").error().code, ErrorCode::notWritable);
  EXPECT_TRUE(loadCase(folder / "library/cases/wrist"));
}

TEST(WithdrawCase, ThatCannotKeepTheNumbersLeavesTheRevisions) {
  const TemporaryFolder folder;
  publishTwo(folder);
  writeText(folder / "library/published/.numbers", "no folder");
  EXPECT_EQ(withdrawCase(folder / "library/published/knee", folder / "library").error().code, ErrorCode::notWritable);
  expectSound(folder / "library", {1, 2});
}

TEST(CaseToWithdraw, IsTheOneThatTheIdNamesAndNoneWhenThereAreTwo) {
  const TemporaryFolder folder;
  const fs::path library = folder / "library";
  makeVolumeCase(library / "cases/first try", "elbow");
  EXPECT_EQ(caseToWithdraw("elbow", library), library / "cases/first try");
  writeText(library / "cases/broken/case.json", "{");
  EXPECT_EQ(caseToWithdraw("broken", library), library / "cases/broken") << "nobody can open it, and it can be taken out";
  publishTwo(folder);
  fs::remove(library / "published/knee/1/sums.json");
  fs::remove(library / "published/knee/2/sums.json");
  EXPECT_EQ(caseToWithdraw("knee", library), library / "published/knee") << "no revision is complete";
  makeVolumeCase(library / "cases/mine", "knee");
  const auto both = caseToWithdraw("knee", library);
  ASSERT_FALSE(both);
  EXPECT_EQ(both.error().code, ErrorCode::badUsage);
  for (const fs::path& each : {library / "cases/mine", library / "published/knee"})
    EXPECT_NE(both.error().sentence().find("'" + each.string() + "'"), std::string::npos) << both.error();
  for (const char* none : {"", ".", "..", "../library", "wrist"})
    EXPECT_EQ(caseToWithdraw(none, library).error().code, ErrorCode::notFound);
  const auto shipped = caseToWithdraw("upper-abdomen-gall-stone", library);
  ASSERT_TRUE(shipped) << shipped.error();
  EXPECT_EQ(withdrawCase(*shipped, library).error().code, ErrorCode::badUsage);
}

TEST(WithdrawCase, RefusesWhatIsNotItsOwnOrIsBeingEdited) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "elsewhere/knee", "knee");
  EXPECT_EQ(withdrawCase(folder / "elsewhere/knee", folder / "library").error().code, ErrorCode::badUsage);
  EXPECT_EQ(withdrawCase(folder / "nowhere", folder / "library").error().code, ErrorCode::notFound);
  makeVolumeCase(folder / "library/cases/knee", "knee");
  {
    const auto lease = FolderLease::take(folder / "library/cases/knee");
    ASSERT_TRUE(lease);
    EXPECT_EQ(withdrawCase(folder / "library/cases/knee", folder / "library").error().code, ErrorCode::notWritable);
  }
  EXPECT_TRUE(fs::exists(folder / "library/cases/knee/case.json"));
  const auto shipped = shippedCasesFolder();
  ASSERT_TRUE(shipped);
  EXPECT_EQ(withdrawCase(*shipped / "upper-abdomen-gall-stone", folder / "library").error().code, ErrorCode::badUsage);
}

TEST(WithdrawCase, TakesNoFolderOfTheLibraryItselfForACase) {
  const TemporaryFolder folder;
  publishTwo(folder);
  ASSERT_TRUE(withdrawCase(folder / "library/published/knee", folder / "library"));
  for (const char* none : {"published", "published/.numbers", "published/.numbers/knee", "withdrawn"})
    EXPECT_EQ(withdrawCase(folder / "library" / none, folder / "library").error().code, ErrorCode::badUsage) << none;
}

}  // namespace
}  // namespace ew::test::withdrawn_test
