#include "ew/io/step_store.h"

#include <gtest/gtest.h>

#include <atomic>
#include <fstream>
#include <thread>

#include "ew/io/content_key.h"
#include "ew/io/safe_file.h"
#include "library/temporary_folder.h"

namespace ew::step_store_test {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using test::writeText;

const std::vector<std::string> kSteps = {"seam", "sweeps"};
const std::string kKey(32, '7'), kOther(32, 'b');

TEST(ContentKey, TellsPartsApartByTheirKindTheirLengthAndTheirOrder) {
  EXPECT_EQ(ContentKey().add("ab").add(1).text(), ContentKey().add(std::string("ab")).add(std::uint64_t{1}).text());
  EXPECT_EQ(ContentKey().add("ab").text().size(), 32u);
  EXPECT_NE(ContentKey().add("ab").add("c").text(), ContentKey().add("a").add("bc").text());
  EXPECT_NE(ContentKey().add(1).text(), ContentKey().add(1.0).text());
  EXPECT_NE(ContentKey().add(0.0).text(), ContentKey().add(-0.0).text()) << "every bit";
  EXPECT_NE(ContentKey().add(1).add(2).text(), ContentKey().add(2).add(1).text());
  std::string longText(1000, 'x');
  const std::string before = ContentKey().add(longText).text();
  longText.back() = 'y';
  EXPECT_NE(ContentKey().add(longText).text(), before);
}

TEST(ContentKey, OfAFileIsThatOfItsBytes) {
  const TemporaryFolder folder;
  const std::string text(3u << 20, 'q');
  writeText(folder / "file", text);
  const auto content = contentOf(folder / "file", noProgress());
  ASSERT_TRUE(content && *content);
  EXPECT_EQ(**content, contentOf(std::as_bytes(std::span(text))));
  const auto missing = contentOf(folder / "nobody", noProgress());
  ASSERT_TRUE(missing);
  EXPECT_FALSE(*missing);
}

TEST(StepStore, ReadsFilesLargerThanATextMayBeAndNoneOfAnotherSize) {
  const TemporaryFolder folder;
  const auto store = StepStore::open(folder.path(), kSteps);
  ASSERT_TRUE(store);
  ASSERT_TRUE(store->prepare("seam"));
  const std::size_t count = (33u << 20) + 5;  // two bytes each: more than 64 MiB
  std::string bytes(2 * count, '\0');
  bytes[2 * count - 2] = 7;
  ASSERT_TRUE(writeFileSafely(store->fileOf("seam", kKey, "levels-0.bin"), bytes));
  EXPECT_FALSE(readTextFile(store->fileOf("seam", kKey, "levels-0.bin")));
  std::vector<std::int16_t> offsets;
  EXPECT_FALSE(store->readValues("seam", kKey, "levels-0.bin", count, offsets)) << "it belongs to no result yet";
  ASSERT_TRUE(store->keep("seam", kKey, {}, {"levels-0.bin"}));
  ASSERT_TRUE(store->readValues("seam", kKey, "levels-0.bin", count, offsets));
  EXPECT_EQ(offsets.size(), count);
  EXPECT_EQ(offsets.back(), 7);
  EXPECT_FALSE(store->readValues("seam", kKey, "levels-0.bin", count + 1, offsets));
  EXPECT_FALSE(store->readValues("seam", kKey, "levels-0.bin", count - 1, offsets));
  EXPECT_FALSE(store->readValues("seam", kKey, "levels-1.bin", 0, offsets));
  EXPECT_EQ(offsets.size(), count) << "left as it was";
}

/// A result with one file.
void keepOne(const StepStore& store, const std::string& key, const std::string& content) {
  ASSERT_TRUE(store.prepare("sweeps"));
  ASSERT_TRUE(writeFileSafely(store.fileOf("sweeps", key, "volume.bin"), content));
  ASSERT_TRUE(store.keep("sweeps", key, {{"about", 3}}, {"volume.bin"}));
}

TEST(StepStore, NoticesAChangedFileByItsContentAndAnEntryThatSaysSomethingElse) {
  const TemporaryFolder folder;
  keepOne(*StepStore::open(folder.path(), kSteps), kKey, "echoes");
  const auto found = [&] {
    const StepStore looking = StepStore::peek(folder.path(), kSteps);
    const auto data = looking.find("sweeps", kKey);
    return data && (*data)["about"] == 3 && looking.isSound("sweeps", kKey, "volume.bin");
  };
  EXPECT_TRUE(found());
  writeText(folder / ("steps/sweeps/" + kKey + "-volume.bin"), "Echoes");
  EXPECT_FALSE(found());
  writeText(folder / ("steps/sweeps/" + kKey + "-volume.bin"), "echoes");
  EXPECT_TRUE(found());
  std::string entry = test::textOf(folder / ("steps/sweeps/" + kKey + ".json"));
  entry.replace(entry.find("\"about\": 3"), 10, "\"about\": 4");
  writeText(folder / ("steps/sweeps/" + kKey + ".json"), entry);
  EXPECT_FALSE(StepStore::peek(folder.path(), kSteps).find("sweeps", kKey));
}

TEST(StepStore, IsForOneProgramOrSharedByMany) {
  const TemporaryFolder folder;
  {
    const auto alone = StepStore::open(folder.path(), kSteps);
    ASSERT_TRUE(alone);
    EXPECT_EQ(StepStore::open(folder.path(), kSteps).error().code, ErrorCode::notWritable);
    EXPECT_EQ(StepStore::share(folder.path(), kSteps).error().code, ErrorCode::notWritable);
  }
  const auto one = StepStore::share(folder.path(), kSteps), two = StepStore::share(folder.path(), kSteps);
  ASSERT_TRUE(one && two);
  EXPECT_EQ(StepStore::open(folder.path(), kSteps).error().code, ErrorCode::notWritable);
  std::atomic<int> inside = 0;
  bool together = false;
  const auto work = [&](const StepStore& store) {
    for (int n = 0; n < 5; ++n) {
      const auto lock = store.lock("sweeps", kKey, verbatim("waiting"), noProgress());
      EXPECT_TRUE(lock);
      if (++inside != 1) together = true;
      std::this_thread::yield();
      --inside;
    }
  };
  {
    std::jthread other([&] { work(*two); });
    work(*one);
  }
  EXPECT_FALSE(together);
}

TEST(StepStore, TakesAwayWhatNobodyUsedAndWhatAKilledProgramLeftAndNothingElse) {
  const TemporaryFolder folder;
  const auto store = StepStore::share(folder.path(), kSteps);
  ASSERT_TRUE(store);
  keepOne(*store, kKey, "new");
  keepOne(*store, kOther, "old");
  const fs::path home = folder / "steps/sweeps";
  const std::string orphan(32, 'c'), busy(32, 'd');
  for (const std::string& name :
       {orphan + "-volume.bin", busy + "-volume.bin", std::string("mine.txt"), std::string(31, 'e') + "-volume.bin"})
    writeText(home / name, "?");
  const auto aDayAgo = fs::file_time_type::clock::now() - std::chrono::hours(24);
  for (const std::string& key : {kKey, kOther}) fs::last_write_time(home / (key + ".json"), aDayAgo);
  ASSERT_TRUE(store->find("sweeps", kKey)) << "which is a use";
  const auto lock = store->lock("sweeps", busy, verbatim("waiting"), noProgress());
  ASSERT_TRUE(lock);
  store->removeUnused(std::chrono::hours(1));
  EXPECT_TRUE(store->find("sweeps", kKey));
  EXPECT_FALSE(fs::exists(home / (kOther + ".json")));
  EXPECT_FALSE(fs::exists(home / (kOther + "-volume.bin")));
  EXPECT_FALSE(fs::exists(home / (orphan + "-volume.bin")));
  EXPECT_TRUE(fs::exists(home / (busy + "-volume.bin"))) << "somebody is making it";
  EXPECT_TRUE(fs::exists(home / "mine.txt"));
  EXPECT_TRUE(fs::exists(home / (std::string(31, 'e') + "-volume.bin")));
}

}  // namespace
}  // namespace ew::step_store_test
