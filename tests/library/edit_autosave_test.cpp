#include "ew/library/edit_autosave.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "ew/library/schema.h"
#include "library/temporary_folder.h"

namespace ew::edit_autosave_test {
namespace {

using test::TemporaryFolder;

Case edited(const std::string& title) {
  auto made = caseFromManifest({{"format", 1}, {"id", "one"}, {"title", title}, {"volume", {{"file", "a.mha"}}}}, {});
  EXPECT_TRUE(made);
  made->folder = "/somewhere/a case";
  return *made;
}

/// Keeps `titles` one after the other in a program of its own, which then ends as a crash ends it.
void keepAndCrash(const std::filesystem::path& root, const std::vector<std::string>& titles) {
  const pid_t child = ::fork();
  if (child == 0) {
    EditAutosave kept(root);
    bool all = true;
    for (const auto& title : titles) all = kept.keep(edited(title), {7, 8}).has_value() && all;
    ::_exit(all ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0);
}

TEST(EditAutosave, AreOfferedAfterTheProgramThatKeptThemHasCrashed) {
  const TemporaryFolder folder;
  keepAndCrash(folder / "kept", {"first", "second"});
  const EditAutosave here(folder / "kept");
  const auto left = here.left();
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].manifest["title"], "second");
  EXPECT_EQ(left[0].caseFolder, "/somewhere/a case");
  EXPECT_EQ(left[0].asRead, (Fingerprint{7, 8}));
  EditAutosave::remove(left[0]);
  EXPECT_TRUE(here.left().empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder / "kept"));
}

TEST(EditAutosave, OfTwoProgramsThatRunAreNotMixedAndNotOfferedToEachOther) {
  const TemporaryFolder folder;
  EditAutosave one(folder / "kept"), two(folder / "kept");
  ASSERT_TRUE(one.keep(edited("one"), {}));
  ASSERT_TRUE(two.keep(edited("two"), {}));
  EXPECT_TRUE(one.left().empty());
  EXPECT_TRUE(two.left().empty());
  two.forget();
  ASSERT_TRUE(one.keep(edited("one again"), {}));
  keepAndCrash(folder / "kept", {"of a third"});
  ASSERT_EQ(two.left().size(), 1u);
  EXPECT_EQ(two.left()[0].manifest["title"], "of a third");
}

TEST(EditAutosave, AProgramThatEndsInOrderLeavesNothing) {
  const TemporaryFolder folder;
  {
    EditAutosave kept(folder / "kept");
    ASSERT_TRUE(kept.keep(edited("saved in the end"), {}));
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder / "kept"));
}

TEST(EditAutosave, WhatCannotBeReadIsNeitherOfferedNorRemoved) {
  const TemporaryFolder folder;
  test::writeText(folder / "kept/damaged/case-edits.json", "{\"case_folder\": ");
  test::writeText(folder / "kept/deep/case-edits.json", std::string(100000, '['));
  test::writeText(folder / "kept/strange/case-edits.json", R"({"case_folder": 7, "manifest": [], "read_bytes": -1, "read_hash": "x"})");
  test::writeText(folder / "kept/note.txt", "somebody's");
  const EditAutosave kept(folder / "kept");
  EXPECT_TRUE(kept.left().empty());
  EXPECT_TRUE(std::filesystem::exists(folder / "kept/damaged/case-edits.json"));
}

TEST(EditAutosave, WithoutAFolderToWriteToSayWhatToDo) {
  const TemporaryFolder folder;
  test::writeText(folder / "file", "in the way");
  EditAutosave kept(folder / "file/kept");
  const auto refused = kept.keep(edited("lost in a crash"), {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::notWritable);
  EXPECT_TRUE(refused.error().sentence().ends_with("."));
}

}  // namespace
}  // namespace ew::edit_autosave_test
