#include "ew/core/output_set.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <optional>

#include "io/files.h"

namespace ew::output_set_test {
namespace {

namespace fs = std::filesystem;
using test::bytesOfFile;
using Names = std::vector<std::string>;

struct Folder : test::TempFolder {
  void write(const fs::path& file, const std::string& text) const { std::ofstream(file, std::ios::binary) << text; }
  [[nodiscard]] Names sorted() const {
    Names found = names();
    std::sort(found.begin(), found.end());
    return found;
  }
};

std::optional<ErrorCode> codeOf(const Result<void>& result) {
  return result ? std::nullopt : std::optional<ErrorCode>(result.error().code);
}

TEST(OutputSet, AppearTogetherWhenCommittedAndNotBefore) {
  const Folder folder;
  OutputSet outputs;
  ASSERT_TRUE(outputs.announce(folder / "a.mha", ".mha .mhd"));
  ASSERT_TRUE(outputs.announce(folder / "b.png", ".png .mha"));
  EXPECT_EQ(outputs.staged(folder / "a.mha").filename(), "a.mha") << "writers choose the format by the ending";
  folder.write(outputs.staged(folder / "a.mha"), "A");
  folder.write(outputs.staged(folder / "b.png"), "B");
  EXPECT_FALSE(fs::exists(folder / "a.mha"));
  EXPECT_TRUE(outputs.existing().empty());
  ASSERT_TRUE(outputs.commit());
  EXPECT_EQ(folder.sorted(), (Names{"a.mha", "b.png"}));
  EXPECT_EQ(bytesOfFile(folder / "a.mha"), "A");
}

TEST(OutputSet, WhatWasNotCommittedLeavesTheFolderAsItWas) {
  const Folder folder;
  folder.write(folder / "a.mha", "old");
  folder.write(folder / "b.raw", "somebody's only copy");
  folder.write(folder / "c.mhd", "old header");
  folder.write(folder / "c.raw", "old samples");
  {
    OutputSet outputs;
    for (const char* name : {"a.mha", "b.mhd", "c.mhd"}) ASSERT_TRUE(outputs.announce(folder / name));
    for (const char* name : {"a.mha", "b.mhd", "b.raw", "c.mhd", "c.raw"}) folder.write(outputs.staged(folder / name), "new");
    EXPECT_EQ(outputs.existing(), (std::vector{folder / "a.mha", folder / "b.raw", folder / "c.raw", folder / "c.mhd"}));
  }
  EXPECT_EQ(folder.sorted(), (Names{"a.mha", "b.raw", "c.mhd", "c.raw"}));
  EXPECT_EQ(bytesOfFile(folder / "a.mha"), "old");
  EXPECT_EQ(bytesOfFile(folder / "b.raw"), "somebody's only copy");
  EXPECT_EQ(bytesOfFile(folder / "c.mhd"), "old header");
  EXPECT_EQ(bytesOfFile(folder / "c.raw"), "old samples");
}

TEST(OutputSet, AHeaderBringsItsSamplesWithIt) {
  EXPECT_EQ(filesNamedBy("x/a.MHD"), (std::vector<fs::path>{"x/a.raw", "x/a.MHD"}));
  EXPECT_EQ(filesNamedBy("a.mha"), (std::vector<fs::path>{"a.mha"}));
  const Folder folder;
  OutputSet outputs;
  ASSERT_TRUE(outputs.announce(folder / "a.mhd"));
  EXPECT_EQ(outputs.staged(folder / "a.raw"), outputs.staged(folder / "a.mhd").replace_extension(".raw")) << "side by side aside";
  EXPECT_EQ(codeOf(outputs.announce(folder / "a.raw")), ErrorCode::badUsage) << "it is announced already";
  folder.write(outputs.staged(folder / "a.mhd"), "header");
  folder.write(outputs.staged(folder / "a.raw"), "samples");
  ASSERT_TRUE(outputs.commit());
  EXPECT_EQ(folder.sorted(), (Names{"a.mhd", "a.raw"}));
}

TEST(OutputSet, NoInputIsWrittenOverWhicheverIsNamedFirst) {
  const Folder folder;
  folder.write(folder / "in.raw", "input");
  folder.write(folder / "in.mhd", "input");
  fs::create_directory(folder / "sub");
  OutputSet outputs;
  ASSERT_TRUE(outputs.protect(folder / "in.raw"));
  EXPECT_EQ(codeOf(outputs.announce(folder / "in.raw")), ErrorCode::badUsage);
  EXPECT_EQ(codeOf(outputs.announce(folder / "in.mhd")), ErrorCode::badUsage) << "its samples are the input";
  EXPECT_EQ(codeOf(outputs.announce(folder / "sub" / ".." / "in.raw")), ErrorCode::badUsage) << "by no other name either";
  OutputSet reported;
  ASSERT_TRUE(reported.announce(folder / "in.raw"));
  EXPECT_EQ(codeOf(reported.protect(folder / "in.raw")), ErrorCode::badUsage) << "announced before the command names its inputs";
  EXPECT_EQ(codeOf(reported.protect(folder / "in.mhd")), ErrorCode::badUsage);
  EXPECT_EQ(codeOf(reported.protect(folder / "other.raw")), std::nullopt);
}

TEST(OutputSet, RefuseWhatCannotBeWrittenBeforeAnyWork) {
  const Folder folder;
  folder.write(folder / "file", "no folder");
  fs::create_directory(folder / "sub.mha");
  fs::create_directory(folder / "taken.raw");
  OutputSet outputs;
  const auto announce = [&](const fs::path& file, std::string_view endings = ".mha .mhd") {
    return codeOf(outputs.announce(file, endings));
  };
  EXPECT_EQ(announce(folder / "o.nrrd"), ErrorCode::badUsage) << "ending";
  EXPECT_EQ(announce(folder / "o"), ErrorCode::badUsage) << "no ending";
  EXPECT_EQ(announce(""), ErrorCode::badUsage);
  EXPECT_EQ(announce(folder / "sub.mha"), ErrorCode::notWritable) << "a folder";
  EXPECT_EQ(announce(folder / "taken.mhd"), ErrorCode::notWritable) << "its samples would be a folder";
  EXPECT_EQ(announce(folder / "file" / "o.mha"), ErrorCode::notWritable) << "below a file";
  EXPECT_EQ(announce(folder / "none" / "o.mha"), ErrorCode::notWritable) << "no such folder";
  EXPECT_EQ(announce("/proc/o.mha"), ErrorCode::notWritable) << "nothing can be made there, not even by root";
  EXPECT_EQ(announce("/dev/null", ""), ErrorCode::notWritable) << "a device would be replaced by a file";
  EXPECT_EQ(announce(folder / (std::string(300, 'n') + ".mha")), ErrorCode::notWritable) << "longer than any name";
  EXPECT_EQ(announce(folder / "o.MHA"), std::nullopt);
  EXPECT_EQ(announce(folder / "o.MHA"), ErrorCode::badUsage) << "twice";
  EXPECT_EQ(outputs.announceFolder(folder / "file" / "deep").has_value(), false);
  { const OutputSet gone(std::move(outputs)); }
  EXPECT_EQ(folder.sorted(), (Names{"file", "sub.mha", "taken.raw"}));
}

TEST(OutputSet, ANameAsLongAsTheFileSystemAllowsIsWritten) {
  const Folder folder;
  const std::string name = std::string(251, 'n') + ".mha";
  folder.write(folder / name, "old");
  OutputSet outputs;
  ASSERT_TRUE(outputs.announce(folder / name));
  ASSERT_TRUE(outputs.announce(folder / "b.txt"));
  folder.write(outputs.staged(folder / name), "new");
  folder.write(outputs.staged(folder / "b.txt"), "new");
  ASSERT_TRUE(outputs.commit());
  EXPECT_EQ(bytesOfFile(folder / name), "new");
  EXPECT_EQ(folder.names().size(), 2u);
}

TEST(OutputSet, AreAllTakenBackWhenOneCannotBePutInPlace) {
  const Folder folder;
  folder.write(folder / "a.mhd", "old header");
  folder.write(folder / "a.raw", "old samples");
  OutputSet outputs;
  for (const char* name : {"a.mhd", "new.txt", "b.png"}) ASSERT_TRUE(outputs.announce(folder / name));
  for (const char* name : {"a.mhd", "a.raw", "new.txt", "b.png"}) folder.write(outputs.staged(folder / name), "new");
  fs::create_directories(folder / "b.png" / "in the way");
  const auto committed = outputs.commit();
  EXPECT_EQ(codeOf(committed), ErrorCode::notWritable);
  { const OutputSet gone(std::move(outputs)); }
  EXPECT_EQ(folder.sorted(), (Names{"a.mhd", "a.raw", "b.png"}));
  EXPECT_EQ(bytesOfFile(folder / "a.mhd"), "old header");
  EXPECT_EQ(bytesOfFile(folder / "a.raw"), "old samples");
}

TEST(OutputSet, AFileThatAppearedInTheMeantimeStaysUnlessItIsOnesOwn) {
  const Folder folder;
  OutputSet asked, own(LateFile::replace);
  ASSERT_TRUE(asked.announce(folder / "asked.mha"));
  ASSERT_TRUE(own.announce(folder / "own.mha"));
  folder.write(asked.staged(folder / "asked.mha"), "new");
  folder.write(own.staged(folder / "own.mha"), "new");
  for (const char* name : {"asked.mha", "own.mha"}) folder.write(folder / name, "somebody else's");
  const auto committed = asked.commit();
  EXPECT_EQ(codeOf(committed), ErrorCode::notWritable);
  EXPECT_TRUE(own.commit());
  EXPECT_EQ(bytesOfFile(folder / "asked.mha"), "somebody else's");
  EXPECT_EQ(bytesOfFile(folder / "own.mha"), "new");
}

TEST(OutputSet, AreCalledByTheirGivenNamesWhateverAWriterCallsThem) {
  const Folder folder;
  OutputSet outputs;
  ASSERT_TRUE(outputs.announce(folder / "a.mhd"));
  EXPECT_EQ(outputs.inGivenNames("Writing " + outputs.staged(folder / "a.raw").string() + " failed."),
            "Writing " + (folder / "a.raw").string() + " failed.");
}

TEST(OutputSet, ASymbolicLinkStaysALinkAlsoOneThatLeadsToNothingYet) {
  const Folder folder;
  fs::create_directory(folder / "far");
  folder.write(folder / "far" / "real.mha", "old");
  fs::create_symlink("far/real.mha", folder / "link.mha");
  fs::create_symlink("far/none.mhd", folder / "empty.mhd");
  OutputSet outputs;
  ASSERT_TRUE(outputs.announce(folder / "link.mha"));
  ASSERT_TRUE(outputs.announce(folder / "empty.mhd"));
  folder.write(outputs.staged(folder / "link.mha"), "new");
  folder.write(outputs.staged(folder / "empty.mhd"), "header");
  folder.write(outputs.staged(folder / "empty.raw"), "samples");
  ASSERT_TRUE(outputs.commit());
  EXPECT_TRUE(fs::is_symlink(folder / "link.mha"));
  EXPECT_TRUE(fs::is_symlink(folder / "empty.mhd"));
  EXPECT_EQ(bytesOfFile(folder / "far" / "real.mha"), "new");
  EXPECT_EQ(bytesOfFile(folder / "far" / "none.mhd"), "header");
  EXPECT_EQ(bytesOfFile(folder / "far" / "none.raw"), "samples") << "beside the header that names them";
}

TEST(OutputSet, AFileThatIsReplacedKeepsItsPermissions) {
  const Folder folder;
  folder.write(folder / "a.txt", "old");
  fs::permissions(folder / "a.txt", fs::perms::owner_read | fs::perms::owner_write);
  OutputSet outputs;
  ASSERT_TRUE(outputs.announce(folder / "a.txt"));
  folder.write(outputs.staged(folder / "a.txt"), "new");
  ASSERT_TRUE(outputs.commit());
  EXPECT_EQ(fs::status(folder / "a.txt").permissions(), fs::perms::owner_read | fs::perms::owner_write);
}

TEST(OutputSet, FoldersMadeForThemAreGoneWhenNothingCameOfItAndStayWithWhatCame) {
  const Folder folder;
  {
    OutputSet outputs;
    ASSERT_TRUE(outputs.announceFolder(folder / "new" / "deep"));
    ASSERT_TRUE(outputs.announce(folder / "new" / "deep" / "a.txt"));
    folder.write(outputs.staged(folder / "new" / "deep" / "a.txt"), "half");
  }
  EXPECT_EQ(folder.names(), Names{});
  OutputSet outputs;
  ASSERT_TRUE(outputs.announceFolder(folder / "new" / "deep"));
  ASSERT_TRUE(outputs.announce(folder / "new" / "deep" / "a.txt"));
  folder.write(outputs.staged(folder / "new" / "deep" / "a.txt"), "whole");
  ASSERT_TRUE(outputs.commit());
  EXPECT_EQ(bytesOfFile(folder / "new" / "deep" / "a.txt"), "whole");
  EXPECT_FALSE(outputs.announceFolder(folder / "new" / "deep" / "a.txt"));
}

TEST(OutputSet, WhatComesToLieInAnAnnouncedFolderIsSomebodyElses) {
  const Folder folder;
  folder.write(folder / "old.txt", "old");
  OutputSet outputs;
  ASSERT_TRUE(outputs.announceFolder(folder.path()));
  folder.write(folder / "late.txt", "somebody's");
  const auto late = outputs.announce(folder / "late.txt");
  EXPECT_EQ(codeOf(late), ErrorCode::notWritable);
  EXPECT_NE(late.error().sentence().find("somebody else"), std::string::npos) << late.error();
  ASSERT_TRUE(outputs.announce(folder / "old.txt"));
  folder.write(outputs.staged(folder / "old.txt"), "new");
  ASSERT_TRUE(outputs.commit());
  EXPECT_EQ(bytesOfFile(folder / "old.txt"), "new");
  EXPECT_EQ(bytesOfFile(folder / "late.txt"), "somebody's");
  EXPECT_TRUE(outputs.announce(folder / "late.txt")) << "the next piece of work has seen it";
}

TEST(OutputSet, WhenWhatBelongsToThemFailsAllIsTakenBack) {
  const Folder folder;
  folder.write(folder / "a.txt", "old");
  const auto commit = [&](bool works) {
    OutputSet outputs;
    EXPECT_TRUE(outputs.announce(folder / "a.txt"));
    EXPECT_TRUE(outputs.announce(folder / (works ? "c.txt" : "b.txt")));
    folder.write(outputs.staged(folder / "a.txt"), "new");
    folder.write(outputs.staged(folder / (works ? "c.txt" : "b.txt")), "new");
    return outputs.commit([&]() -> Result<void> {
      EXPECT_EQ(bytesOfFile(folder / "a.txt"), "new") << "in place before";
      if (works) return {};
      return failure(ErrorCode::notWritable, verbatim("No."));
    });
  };
  EXPECT_EQ(codeOf(commit(false)), ErrorCode::notWritable);
  EXPECT_EQ(folder.names(), Names{"a.txt"});
  EXPECT_EQ(bytesOfFile(folder / "a.txt"), "old");
  EXPECT_TRUE(commit(true));
  EXPECT_EQ(folder.sorted(), (Names{"a.txt", "c.txt"}));
}

TEST(OutputSet, AWholeFolderTakesThePlaceOfNothingOrOfAnEmptyOne) {
  const Folder folder;
  fs::create_directory(folder / "empty");
  fs::create_directories(folder / "full" / "something");
  const auto make = [&](bool committed, bool inTheWay) {
    OutputSet outputs;
    for (const char* name : {"none", "empty"}) {
      ASSERT_TRUE(outputs.announceNewFolder(folder / name));
      fs::create_directory(outputs.staged(folder / name) / "deep");
      folder.write(outputs.staged(folder / name) / "deep" / "a.txt", "text");
    }
    EXPECT_EQ(codeOf(outputs.announceNewFolder(folder / "full")), ErrorCode::notWritable);
    if (inTheWay) fs::create_directory(folder / "empty" / "in the way");
    if (committed) {
      const auto put = outputs.commit();
      EXPECT_EQ(put.has_value(), !inTheWay);
      if (!put) {
        EXPECT_EQ(put.error().sentence(),
                  "Another program has just made the folder \"" + (folder / "empty").string() + "\"; choose another name.");
      }
    }
  };
  make(false, false);
  EXPECT_EQ(folder.sorted(), (Names{"empty", "full"}));
  make(true, true);
  EXPECT_EQ(folder.sorted(), (Names{"empty", "full"})) << "the first was taken back";
  fs::remove(folder / "empty" / "in the way");
  EXPECT_TRUE(fs::is_empty(folder / "empty"));
  make(true, false);
  for (const char* name : {"none", "empty"}) EXPECT_EQ(bytesOfFile(folder / name / "deep" / "a.txt"), "text");
}

TEST(OutputSet, WhatAKilledProgramLeftIsRemovedFromAFolderOfOnesOwnAndNothingElse) {
  const Folder folder;
  OutputSet running;
  ASSERT_TRUE(running.announce(folder / "b.txt"));
  folder.write(running.staged(folder / "b.txt"), "running");
  const pid_t killed = ::fork();
  if (killed == 0) {
    OutputSet outputs;
    if (outputs.announce(folder / "a.txt")) folder.write(outputs.staged(folder / "a.txt"), "half");
    ::_exit(0);  // as a kill: nothing is cleaned up
  }
  int status = 0;
  ASSERT_EQ(::waitpid(killed, &status, 0), killed);
  fs::create_directory(folder / ".ew-notes");
  folder.write(folder / ".ew-1-x", "a file");
  ASSERT_EQ(folder.names().size(), 4u);
  removeLeftovers(folder.path());
  EXPECT_EQ(folder.names().size(), 3u);
  EXPECT_TRUE(fs::exists(folder / ".ew-notes"));
  EXPECT_TRUE(fs::exists(folder / ".ew-1-x"));
  EXPECT_TRUE(running.commit());
}

TEST(OutputSet, WhatAKilledProgramLeftGoesWithTheNextOutputThereButNotTheOnlyCopyOfAFile) {
  const Folder folder;
  const auto kill = [&](const auto& work) {
    const pid_t killed = ::fork();
    if (killed == 0) {
      work();
      ::_exit(0);  // as a kill: nothing is cleaned up
    }
    int status = 0;
    ASSERT_EQ(::waitpid(killed, &status, 0), killed);
  };
  kill([&] {
    OutputSet outputs;
    if (outputs.announce(folder / "a.txt")) folder.write(outputs.staged(folder / "a.txt"), "half");
    ::_exit(0);
  });
  ASSERT_EQ(folder.names().size(), 1u);
  kill([&] {
    OutputSet outputs;
    if (!outputs.announce(folder / "b.txt")) return;
    folder.write(fs::path(outputs.staged(folder / "b.txt")).replace_extension(".txt.earlier"), "the only copy");
    ::_exit(0);
  });
  OutputSet next;
  ASSERT_TRUE(next.announce(folder / "c.txt"));
  folder.write(next.staged(folder / "c.txt"), "c");
  ASSERT_TRUE(next.commit());
  ASSERT_EQ(folder.names().size(), 2u) << "c.txt, and what holds what a file was before";
  EXPECT_TRUE(fs::exists(folder / "c.txt"));
}

TEST(OutputSet, WhatAnotherMachineHasAsideInASharedFolderIsLeftUntilItIsOld) {
  const Folder folder;
  const fs::path young = folder / ".ew-99999999-0-0badcafe", old = folder / ".ew-99999999-1-0badcafe";
  fs::create_directory(young);
  fs::create_directory(old);
  fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(72));
  removeLeftovers(folder.path());
  EXPECT_TRUE(fs::exists(young)) << "a process of that number is at work elsewhere";
  EXPECT_FALSE(fs::exists(old));
}

}  // namespace
}  // namespace ew::output_set_test
