#include "ew/library/withdrawn.h"

#include <gtest/gtest.h>

#include "ew/library/case.h"
#include "ew/library/folder_lease.h"
#include "ew/library/published.h"
#include "library/bundle_world.h"

namespace ew::test::withdrawn_test {
namespace {

namespace fs = std::filesystem;

TEST(WithdrawCase, MovesAnOwnCaseAndKeepsEveryByte) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "library/cases/knee", "knee");
  const auto before = treeOf(folder / "library/cases/knee");
  const auto moved = withdrawCase(folder / "library/cases/knee", folder / "library");
  ASSERT_TRUE(moved) << moved.error();
  EXPECT_FALSE(fs::exists(folder / "library/cases/knee"));
  EXPECT_EQ(moved->parent_path(), withdrawnFolder(folder / "library"));
  EXPECT_EQ(treeOf(*moved), before);
  fs::rename(*moved, folder / "library/cases/knee");
  EXPECT_TRUE(loadCase(folder / "library/cases/knee"));
}

TEST(WithdrawCase, TakesAllRevisionsOfAPublishedOne) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "knee", "knee");
  const auto first = publishCase(folder / "knee", folder / "library");
  ASSERT_TRUE(first) << first.error();
  const auto moved = withdrawCase(first->folder, folder / "library");
  ASSERT_TRUE(moved) << moved.error();
  EXPECT_TRUE(listPublished(folder / "library").empty());
  EXPECT_TRUE(fs::exists(*moved / "1/case.json"));
  const auto again = publishCase(folder / "knee", folder / "library");
  ASSERT_TRUE(again) << again.error();
  EXPECT_EQ(again->revision, 2) << "attempts at revision 1 must not find another content under its number";
  EXPECT_FALSE(again->wasThere);
  EXPECT_TRUE(withdrawCase(again->folder, folder / "library")) << "beside the one before";
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

}  // namespace
}  // namespace ew::test::withdrawn_test
