#include "ew/library/checksums.h"

#include <gtest/gtest.h>

#include "ew/io/volume_file.h"
#include "ew/library/content_name.h"
#include "library/bundle_world.h"

namespace ew::test::checksums_test {
namespace {

namespace fs = std::filesystem;

TEST(Sha256, GivesTheDigestsOfThePublishedExamples) {
  // FIPS 180-4, examples of NIST.
  EXPECT_EQ(sumOf(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sumOf("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sumOf("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  const TemporaryFolder folder;
  writeText(folder / "million", std::string(1'000'000, 'a'));
  EXPECT_EQ(*sha256Of(folder / "million"), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
  EXPECT_EQ(sha256Of(folder / "nothing").error().code, ErrorCode::notFound);
}

TEST(Sums, AreReadAsTheyWereWritten) {
  const TemporaryFolder folder;
  makeVolumeCase(folder / "mine", "knee");
  const auto sums = sumsOfCase(folder / "mine");
  ASSERT_TRUE(sums);
  ASSERT_TRUE(writeSums(*sums, folder / "mine"));
  EXPECT_EQ(*readSums(folder / "mine"), *sums);
  EXPECT_EQ(*sumsOfCase(folder / "mine"), *sums) << "the list is not in the list";
}

TEST(Sums, ThatSomebodyWroteAreCheckedAsAList) {
  const TemporaryFolder folder;
  const auto refuses = [&](const nlohmann::json& document, ErrorCode code) {
    writeText(folder / "sums.json", document.dump());
    const auto read = readSums(folder.path());
    ASSERT_FALSE(read) << document;
    EXPECT_EQ(read.error().code, code) << read.error();
  };
  refuses({{"format", 2}, {"files", nlohmann::json::array()}}, ErrorCode::newerFormat);
  refuses({{"format", 1}}, ErrorCode::badField);
  refuses({{"format", 1}, {"files", nlohmann::json::array({listed("../x", "")})}}, ErrorCode::badField);
  refuses({{"format", 1}, {"files", nlohmann::json::array({listed("x", ""), listed("X", "")})}}, ErrorCode::badField);
  writeText(folder / "sums.json", "{");
  EXPECT_EQ(readSums(folder.path()).error().code, ErrorCode::badHeader);
}

TEST(AddVolume, NamesAFileByItsContentAndWritesItOnce) {
  const TemporaryFolder folder;
  const Volume volume = noisyVolume({9, 8, 7}, 5);
  ASSERT_TRUE(writeVolume(volume, folder / "Liver.MHA"));
  const auto name = addVolumeFile(folder / "Liver.MHA", folder / "case");
  ASSERT_TRUE(name) << name.error();
  EXPECT_EQ(*name, contentName(*sha256Of(folder / "Liver.MHA")));
  EXPECT_TRUE(isContentNamed(*name));
  EXPECT_EQ(textOf(folder / "case" / *name), textOf(folder / "Liver.MHA"));
  const auto before = treeOf(folder / "case");
  EXPECT_EQ(*addVolumeFile(folder / "Liver.MHA", folder / "case"), *name);
  EXPECT_EQ(*addVolume(volume, folder / "case"), *name) << "the same from memory";
  EXPECT_EQ(treeOf(folder / "case"), before);
  const auto other = addVolume(noisyVolume({9, 8, 7}, 6), folder / "case");
  ASSERT_TRUE(other);
  EXPECT_NE(*other, *name);
}

TEST(AddVolume, NeverWritesOverAFileThatHoldsSomethingElse) {
  const TemporaryFolder folder;
  const auto name = addVolume(noisyVolume({9, 8, 7}, 5), folder / "case");
  ASSERT_TRUE(name);
  writeText(folder / "case" / *name, "damaged");
  const auto refused = addVolume(noisyVolume({9, 8, 7}, 5), folder / "case");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::notWritable);
  EXPECT_EQ(textOf(folder / "case" / *name), "damaged");
}

TEST(AddVolume, JoinsAHeaderAndItsSamplesSampleForSample) {
  const TemporaryFolder folder;
  const Volume volume = noisyVolume({9, 8, 7}, 5);
  ASSERT_TRUE(writeVolume(volume, folder / "v.mhd"));
  const auto name = addVolumeFile(folder / "v.mhd", folder / "case");
  ASSERT_TRUE(name) << name.error();
  EXPECT_TRUE(name->ends_with(".mha"));
  const auto read = readVolume(folder / "case" / *name);
  ASSERT_TRUE(read) << read.error();
  EXPECT_EQ(read->volume.echo, volume.echo);
  EXPECT_EQ(read->volume.grid.dims, volume.grid.dims);
  EXPECT_EQ(*addVolumeFile(folder / "v.mhd", folder / "case"), *name);
  EXPECT_EQ(treeOf(folder / "case").size(), 3u) << "the folder, volumes, one file";
}

TEST(AddVolume, LeavesNothingOfWhatCannotBeTakenIn) {
  const TemporaryFolder folder;
  writeText(folder / "notes.txt", "no volume");
  EXPECT_FALSE(addVolumeFile(folder / "notes.txt", folder / "case"));
  EXPECT_FALSE(addVolumeFile(folder / "nothing.mha", folder / "case"));
  EXPECT_FALSE(addVolume(Volume(), folder / "case"));
  EXPECT_FALSE(fs::exists(folder / "case"));
}

TEST(ContentName, IsKnownByItsShape) {
  const std::string sum = sumOf("abc");
  EXPECT_EQ(contentName(sum), "volumes/ba7816bf8f01cfea.mha");
  EXPECT_TRUE(namesItsContent("volumes/ba7816bf8f01cfea.nii.gz", sum));
  EXPECT_FALSE(namesItsContent("volumes/ba7816bf8f01cfeb.mha", sum));
  for (const char* other : {"volumes/v.mha", "volumes/ba7816bf8f01cfea.raw", "ba7816bf8f01cfea.mha", "volumes/BA7816BF8F01CFEA.mha", ""})
    EXPECT_FALSE(isContentNamed(other)) << other;
}

}  // namespace
}  // namespace ew::test::checksums_test
