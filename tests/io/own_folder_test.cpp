#include "ew/io/own_folder.h"

#include <gtest/gtest.h>

#include "library/temporary_folder.h"

namespace ew::own_folder_test {
namespace {

namespace fs = std::filesystem;

/// As a program leaves a note that ends without being asked, so many seconds after the first.
fs::path leave(const fs::path& root, const nlohmann::json& note, int later_s) {
  OwnFolder own(root);
  EXPECT_EQ(own.make(), "");
  EXPECT_TRUE(own.writeNote("note.json", note));
  const fs::path folder = own.path();
  fs::last_write_time(folder / "note.json", fs::file_time_type::clock::now() + std::chrono::seconds(later_s));
  own.leave();
  return folder;
}

TEST(OwnFolder, TellsWhatWasLeftTheLatestFirst) {
  const test::TemporaryFolder root;
  const fs::path first = leave(root.path(), {{"n", 1}}, 0), third = leave(root.path(), {{"n", 3}}, 20),
                 second = leave(root.path(), {{"n", 2}}, 10);
  leave(root.path(), nlohmann::json::array(), 30);
  test::writeText(root / "damaged/note.json", "{");
  test::writeText(root / "other/else.json", "{}");
  test::writeText(root / "copied/note.json", R"({"n": 4})");
  fs::last_write_time(root / "copied/note.json", fs::file_time_type::clock::now() + std::chrono::seconds(40));
  OwnFolder own(root.path());
  ASSERT_EQ(own.make(), "");
  ASSERT_TRUE(own.writeNote("note.json", {{"n", 5}}));
  const auto left = own.leftWith("note.json");
  ASSERT_EQ(left.size(), 4u);
  const fs::path folders[] = {root / "copied", third, second, first};
  for (std::size_t n = 0; n < 4; ++n) {
    EXPECT_EQ(left[n].folder, folders[n]);
    EXPECT_EQ(left[n].note, (nlohmann::json{{"n", 4 - static_cast<int>(n)}}));
  }
}

TEST(OwnFolder, WhatIsDecidedAboutGoesAndNothingElse) {
  const test::TemporaryFolder root;
  const fs::path all = leave(root.path(), {{"n", 1}}, 0), some = leave(root.path(), {{"n", 2}}, 1);
  test::writeText(some / "more.txt", "somebody's");
  for (const fs::path& folder : {all, some}) OwnFolder::discard(folder, {"note.json"});
  EXPECT_FALSE(fs::exists(all));
  EXPECT_TRUE(fs::exists(some / "more.txt"));
  EXPECT_FALSE(fs::exists(some / "note.json"));
}

TEST(OwnFolder, IsNotOfferedWhileItsProgramLives) {
  const test::TemporaryFolder root;
  OwnFolder own(root.path());
  ASSERT_EQ(own.make(), "");
  EXPECT_TRUE(OwnFolder(root.path()).left().empty());
  EXPECT_FALSE(OwnFolder::lockOfAbandoned(own.path()));
  const fs::path folder = own.path();
  own.leave();
  EXPECT_EQ(OwnFolder(root.path()).left(), std::vector<fs::path>{folder});
  const auto lock = OwnFolder::lockOfAbandoned(folder);
  EXPECT_TRUE(lock);
  EXPECT_TRUE(OwnFolder(root.path()).left().empty()) << "somebody decides about it";
}

}  // namespace
}  // namespace ew::own_folder_test
