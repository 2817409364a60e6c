#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <random>

#include "ew/library/bundle.h"
#include "library/bundle_world.h"

namespace ew::test::bundle_attack_test {
namespace {

namespace fs = std::filesystem;

/// A library with a published case in it, and files around it that an escaping path would hit.
class BundleAttack : public testing::Test {
 protected:
  void SetUp() override {
    makeVolumeCase(folder_ / "mine", "wrist", {6, 5, 4});
    ASSERT_TRUE(publishCase(folder_ / "mine", folder_ / "world/library"));
    writeText(folder_ / "world/victim.txt", "as it was");
    before_ = treeOf(folder_ / "world");
  }

  /// Importing and verifying say the same sentence, which holds all of these words, and nothing anywhere has changed.
  void expectRefused(ErrorCode code, const std::vector<std::string>& words, const BundleLimits& limits = {}) {
    const auto verified = verifyBundle(file_, limits);
    ASSERT_FALSE(verified);
    EXPECT_EQ(verified.error().code, code) << verified.error();
    const auto imported = importBundle(file_, folder_ / "world/library", limits);
    ASSERT_FALSE(imported);
    EXPECT_EQ(imported.error().code, code) << imported.error();
    EXPECT_EQ(imported.error().sentence(), verified.error().sentence());
    for (const auto& word : words) EXPECT_NE(imported.error().sentence().find(word), std::string::npos) << imported.error() << "\n" << word;
    EXPECT_NE(imported.error().sentence().find("x.ewcase"), std::string::npos) << imported.error();
    EXPECT_EQ(treeOf(folder_ / "world"), before_);
  }

  /// A case with one more entry, listed in bundle.json or not.
  void writeWith(RawEntry extra, bool isListed) {
    auto files = tiny_.list();
    if (isListed) files.push_back(listed(extra.path, extra.content));
    auto entries = tiny_.bundle(headerAround(files));
    entries.push_back(std::move(extra));
    writeRawBundle(file_, entries);
  }

  TemporaryFolder folder_;
  fs::path file_ = folder_ / "x.ewcase";
  TinyCase tiny_;
  std::map<std::string, std::string> before_;
};

TEST_F(BundleAttack, TheHonestBundleOfTheseTestsIsTakenIn) {
  writeRawBundle(file_, tiny_.bundle(headerAround(tiny_.list())));
  const auto imported = importBundle(file_, folder_ / "world/library");
  ASSERT_TRUE(imported) << imported.error();
}

TEST_F(BundleAttack, PathsThatLeaveTheCaseFolderAreRefusedWhetherListedOrNot) {
  const std::string victim = (folder_ / "world/victim.txt").string();
  for (const auto& [path, reason] : std::vector<std::pair<std::string, std::string>>{{victim, "absolute"},
                                                                                     {"../../../../victim.txt", "leads out"},
                                                                                     {"media/../../x.txt", "leads out"},
                                                                                     {"media/..", "leads out"},
                                                                                     {"./x.txt", "hidden"},
                                                                                     {"media//x.txt", "empty"},
                                                                                     {"..\\victim.txt", "characters"},
                                                                                     {"a\nb.txt", "characters"},
                                                                                     {".ew-1-1/x.txt", "hidden"},
                                                                                     {"volumes/.hidden", "hidden"},
                                                                                     {"sums.json", "library itself"},
                                                                                     {"SUMS.json", "library itself"}})
    for (const bool isListed : {false, true}) {
      SCOPED_TRACE(path + (isListed ? ", listed" : ""));
      writeWith({.path = path, .content = "gotcha"}, isListed);
      expectRefused(ErrorCode::badField, {reason, "do not use"});
    }
}

TEST_F(BundleAttack, LinksDevicesPipesAndFoldersAreRefused) {
  const std::string victim = (folder_ / "world/victim.txt").string();
  const std::vector<RawEntry> all{{.path = "media", .type = AE_IFLNK, .symbolicLink = folder_ / "world"},
                                  {.path = "notes.txt", .type = AE_IFLNK, .symbolicLink = "../../../../victim.txt"},
                                  {.path = "notes.txt", .type = AE_IFREG, .hardLink = victim},
                                  {.path = "notes.txt", .type = AE_IFREG, .hardLink = "case.json"},
                                  {.path = "notes.txt", .type = AE_IFCHR},
                                  {.path = "notes.txt", .type = AE_IFBLK},
                                  {.path = "notes.txt", .type = AE_IFIFO},
                                  {.path = "media", .type = AE_IFDIR}};
  for (const RawEntry& each : all) {
    SCOPED_TRACE(each.path + " " + std::to_string(each.type) + each.hardLink);
    writeWith(each, false);
    expectRefused(ErrorCode::unsupported, {"\"" + each.path, "link, a device or a folder", "do not use"});
    writeWith(each, true);
    expectRefused(ErrorCode::unsupported, {"\"" + each.path, "link, a device or a folder", "do not use"});
  }
}

TEST_F(BundleAttack, ALinkThatAFileIsThenWrittenThroughIsRefused) {
  auto files = tiny_.list();
  files.push_back(listed("media/victim.txt", "gotcha"));
  auto entries = tiny_.bundle(headerAround(files));
  entries.push_back({.path = "media", .type = AE_IFLNK, .symbolicLink = folder_ / "world"});
  entries.push_back({.path = "media/victim.txt", .content = "gotcha"});
  writeRawBundle(file_, entries);
  expectRefused(ErrorCode::unsupported, {"\"media\"", "link"});
}

TEST_F(BundleAttack, NamesTwiceAreRefused) {
  auto entries = tiny_.bundle(headerAround(tiny_.list()));
  entries.push_back(entries[1]);
  writeRawBundle(file_, entries);
  expectRefused(ErrorCode::badField, {"\"case.json\" twice"});
  auto header = entries;
  header.pop_back();
  header.push_back(entries[0]);
  writeRawBundle(file_, header);
  expectRefused(ErrorCode::badField, {"\"bundle.json\" twice"});
  auto files = tiny_.list();
  files.push_back(files[1]);
  writeRawBundle(file_, tiny_.bundle(headerAround(files)));
  expectRefused(ErrorCode::badField, {"volumes/v.mha", "but for capitals"});
  writeWith({.path = "Volumes/V.MHA", .content = "other"}, true);
  expectRefused(ErrorCode::badField, {"Volumes/V.MHA", "but for capitals"});
  writeWith({.path = "volumes", .content = "a file where a folder is"}, true);
  expectRefused(ErrorCode::badField, {"volumes/v.mha", "name of its folder"});
}

TEST_F(BundleAttack, WhatIsNotListedAndWhatDoesNotComeIsRefused) {
  writeWith({.path = "more.txt", .content = "more"}, false);
  expectRefused(ErrorCode::badField, {"\"more.txt\"", "does not name"});
  auto files = tiny_.list();
  files.push_back(listed("more.txt", "more"));
  writeRawBundle(file_, tiny_.bundle(headerAround(files)));
  expectRefused(ErrorCode::truncated, {"\"more.txt\"", "not in it"});
  writeRawBundle(
      file_, {{"bundle.json", headerAround(nlohmann::json::array({listed("volumes/v.mha", tiny_.volume)})).dump()}, tiny_.entries()[1]});
  expectRefused(ErrorCode::badField, {"no case.json"});
}

TEST_F(BundleAttack, WrongSumsAndSizesAreRefused) {
  auto files = tiny_.list();
  files[1]["sha256"] = sumOf("something else");
  writeRawBundle(file_, tiny_.bundle(headerAround(files)));
  expectRefused(ErrorCode::badField, {"volumes/v.mha", "not what was put in"});
  for (const int more : {-1, 1}) {
    files = tiny_.list();
    files[1]["size"] = static_cast<long long>(tiny_.volume.size()) + more;
    writeRawBundle(file_, tiny_.bundle(headerAround(files)));
    expectRefused(ErrorCode::badField, {"volumes/v.mha", "not what was put in"});
  }
  for (const auto& sum : {std::string(64, 'g'), std::string(64, 'A'), std::string(63, 'a')}) {
    files[0]["sha256"] = sum;
    writeRawBundle(file_, tiny_.bundle(headerAround(files)));
    expectRefused(ErrorCode::badField, {"sha256"});
  }
}

TEST_F(BundleAttack, ABundleThatEndsTooEarlyIsRefusedWhereverItEnds) {
  makeVolumeCase(folder_ / "long", "knee", {40, 40, 40});
  ASSERT_TRUE(exportBundle(folder_ / "long", file_));
  const std::string whole = textOf(file_);
  std::mt19937 dice(5);
  std::vector<std::size_t> ends{0,
                                1,
                                3,
                                4,
                                5,
                                8,
                                20,
                                100,
                                whole.size() - 1,
                                whole.size() - 2,
                                whole.size() - 3,
                                whole.size() - 4,
                                whole.size() - 8,
                                whole.size() - 100};
  for (int n = 0; n < 60; ++n) ends.push_back(dice() % whole.size());
  for (const std::size_t end : ends) {
    SCOPED_TRACE(std::to_string(end) + " of " + std::to_string(whole.size()));
    writeText(file_, whole.substr(0, end));
    const auto imported = importBundle(file_, folder_ / "world/library");
    ASSERT_FALSE(imported);
    const auto code = imported.error().code;
    EXPECT_TRUE(code == ErrorCode::truncated || (end < 200 && code == ErrorCode::badHeader)) << imported.error();
    EXPECT_EQ(treeOf(folder_ / "world"), before_);
  }
  writeText(file_, whole);
  EXPECT_TRUE(importBundle(file_, folder_ / "world/library"));
}

TEST_F(BundleAttack, OneFlippedBitAnywhereIsNoticed) {
  makeVolumeCase(folder_ / "long", "knee", {24, 24, 24});
  ASSERT_TRUE(exportBundle(folder_ / "long", file_));
  const std::string whole = textOf(file_);
  const auto good = verifyBundle(file_);
  ASSERT_TRUE(good);
  std::mt19937 dice(6);
  int refused = 0;
  for (int n = 0; n < 200; ++n) {
    std::string flipped = whole;
    const std::size_t at = dice() % whole.size();
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << (dice() % 8)));
    writeText(file_, flipped);
    const auto checked = verifyBundle(file_);
    refused += checked ? 0 : 1;
    // A bit that carries no file and no list may be another one: the times of a tar's entries, what fills them up.
    if (checked) {
      EXPECT_EQ(checked->files, good->files) << "bit of byte " << at;
    }
  }
  EXPECT_GT(refused, 190);
}

TEST_F(BundleAttack, WhatFollowsTheEndIsRefused) {
  writeRawBundle(file_, tiny_.bundle(headerAround(tiny_.list())));
  const std::string whole = textOf(file_);
  writeText(file_, whole + "something");
  EXPECT_FALSE(verifyBundle(file_));
  EXPECT_FALSE(importBundle(file_, folder_ / "world/library"));
  writeRawBundle(folder_ / "second", {{"evil.txt", "gotcha"}});
  writeText(file_, whole + textOf(folder_ / "second"));
  expectRefused(ErrorCode::badField, {"evil.txt", "does not name"});
}

TEST_F(BundleAttack, WhatIsNoBundleAtAllIsCalledSo) {
  const auto isNone = [&] { expectRefused(ErrorCode::badHeader, {"is not a case bundle", "choose a file"}); };
  writeText(file_, "");
  isNone();
  writeText(file_, "PK\x03\x04 a zip");
  isNone();
  writeText(file_, std::string(100'000, '\0'));
  isNone();
  writeText(file_, textOf(folder_ / "mine/volumes/v.mha"));
  isNone();
  writeRawBundle(file_, {{"case.json", tiny_.manifest}});
  isNone();
  // The same entries without compression: another kind of file.
  archive* out = archive_write_new();
  archive_write_set_format_ustar(out);
  ASSERT_EQ(archive_write_open_filename(out, file_.c_str()), ARCHIVE_OK);
  archive_write_free(out);
  isNone();
  fs::remove(file_);
  EXPECT_EQ(importBundle(file_, folder_ / "world/library").error().code, ErrorCode::notFound);
  EXPECT_EQ(importBundle(folder_.path(), folder_ / "world/library").error().code, ErrorCode::badHeader);
}

TEST_F(BundleAttack, NewerFormatsAndOtherKindsSayThatTheProgramIsTooOld) {
  auto header = headerAround(tiny_.list());
  header["format"] = kBundleFormat + 1;
  header["parcels"] = {{"unheard of", 1}};
  writeRawBundle(file_, tiny_.bundle(header));
  expectRefused(ErrorCode::newerFormat, {"format 2", "update EchoWeave"});
  header = headerAround(tiny_.list());
  header["kind"] = "course";
  writeRawBundle(file_, tiny_.bundle(header));
  expectRefused(ErrorCode::unsupported, {"\"course\"", "update EchoWeave"});
  TinyCase newer;
  auto manifest = manifestOfVolumeCase("knee");
  manifest["format"] = 99;
  newer.manifest = manifest.dump();
  writeRawBundle(file_, newer.bundle(headerAround(newer.list())));
  expectRefused(ErrorCode::newerFormat, {"case.json has format 99", "newer EchoWeave"});
}

TEST_F(BundleAttack, ACaseThatTheSchemaRefusesIsRefusedWithTheField) {
  TinyCase wrong;
  auto manifest = manifestOfVolumeCase("knee");
  manifest["title"] = 3;
  wrong.manifest = manifest.dump();
  writeRawBundle(file_, wrong.bundle(headerAround(wrong.list())));
  expectRefused(ErrorCode::badField, {"'title'", "cannot be used"});
  wrong.manifest = "{ no JSON";
  writeRawBundle(file_, wrong.bundle(headerAround(wrong.list())));
  expectRefused(ErrorCode::badHeader, {"cannot be used"});
  wrong.manifest = manifestOfVolumeCase("shoulder").dump();
  writeRawBundle(file_, wrong.bundle(headerAround(wrong.list())));
  expectRefused(ErrorCode::badField, {"\"knee\"", "\"shoulder\""});
}

TEST_F(BundleAttack, ACaseWhoseFilesAreNotAllInTheBundleIsRefused) {
  writeRawBundle(file_, {{"bundle.json", headerAround(nlohmann::json::array({listed("case.json", tiny_.manifest)})).dump()},
                         {"case.json", tiny_.manifest}});
  const auto imported = importBundle(file_, folder_ / "world/library");
  ASSERT_FALSE(imported);
  EXPECT_EQ(imported.error().code, ErrorCode::notFound) << imported.error();
  EXPECT_NE(imported.error().sentence().find("volumes/v.mha"), std::string::npos);
  EXPECT_EQ(treeOf(folder_ / "world"), before_);
}

TEST_F(BundleAttack, IdsThatAreNoNamesOfFoldersAreRefused) {
  for (const char* id : {"../../evil", "/tmp/evil", ".hidden", "a/b", "", "a b"}) {
    SCOPED_TRACE(id);
    writeRawBundle(file_, tiny_.bundle(headerAround(tiny_.list(), id)));
    expectRefused(ErrorCode::badField, {"'id'"});
  }
}

TEST_F(BundleAttack, ListsOfWrongShapeAreRefusedInTheWordsOfAllFiles) {
  for (const auto& [field, value] : std::vector<std::pair<std::string, nlohmann::json>>{{"files", "none"},
                                                                                        {"files", {1, 2}},
                                                                                        {"files", nullptr},
                                                                                        {"revision", -1},
                                                                                        {"revision", 1e300},
                                                                                        {"title", 5},
                                                                                        {"format", "1"},
                                                                                        {"unheard_of", true}}) {
    SCOPED_TRACE(field + value.dump());
    auto header = headerAround(tiny_.list());
    header[field] = value;
    writeRawBundle(file_, tiny_.bundle(header));
    expectRefused(ErrorCode::badField, {field});
  }
}

TEST_F(BundleAttack, ABombOfZerosIsRefusedBeforeItGrows) {
  // 300 MB of zeros, honestly listed: a hundred kilobytes.
  const std::string zeros(300u << 20, '\0');
  writeWith({.path = "volumes/zeros.raw", .content = zeros}, true);
  EXPECT_LT(fs::file_size(file_), 1u << 20);
  expectRefused(ErrorCode::tooLarge, {"would grow", "do not use"});
  // The same under a list that keeps silent about it, as an entry of its own and behind the end.
  writeWith({.path = "volumes/zeros.raw", .content = zeros}, false);
  expectRefused(ErrorCode::badField, {"does not name"});
  auto files = tiny_.list();
  files.push_back({{"path", "volumes/zeros.raw"}, {"size", 10}, {"sha256", sumOf("0123456789")}});
  auto entries = tiny_.bundle(headerAround(files));
  entries.push_back({"volumes/zeros.raw", zeros});
  writeRawBundle(file_, entries);
  expectRefused(ErrorCode::badField, {"volumes/zeros.raw", "not what was put in"});
}

TEST_F(BundleAttack, ABombBehindTheEndOrInTheListIsStopped) {
  writeRawBundle(file_, tiny_.bundle(headerAround(tiny_.list())));
  const std::string whole = textOf(file_);
  // Nested zeros: empty blocks, of which a tar may have any number behind its end.
  archive* out = archive_write_new();
  archive_write_set_format_raw(out);
  archive_write_add_filter_zstd(out);
  const fs::path bomb = folder_ / "zeros.zst";
  ASSERT_EQ(archive_write_open_filename(out, bomb.c_str()), ARCHIVE_OK);
  archive_entry* entry = archive_entry_new();
  archive_entry_set_pathname(entry, "zeros");
  archive_entry_set_filetype(entry, AE_IFREG);
  ASSERT_EQ(archive_write_header(out, entry), ARCHIVE_OK);
  const std::string zeros(64u << 20, '\0');
  for (int n = 0; n < 32; ++n) archive_write_data(out, zeros.data(), zeros.size());
  archive_entry_free(entry);
  archive_write_close(out);
  archive_write_free(out);
  std::string tail = textOf(bomb);
  while (tail.size() < (1u << 20)) tail += tail;  // tens of gigabytes
  writeText(file_, whole + tail);
  expectRefused(ErrorCode::tooLarge, {"more than its list names"});
  writeRawBundle(file_, {{"bundle.json", std::string(200u << 20, ' ')}});
  expectRefused(ErrorCode::tooLarge, {"list", "too long"});
}

TEST_F(BundleAttack, DeclaredSizesAndCountsBeyondTheLimitsAreRefusedBeforeAnythingIsWritten) {
  auto files = tiny_.list();
  files.push_back({{"path", "volumes/huge.mha"}, {"size", 1ll << 52}, {"sha256", std::string(64, '0')}});
  writeRawBundle(file_, tiny_.bundle(headerAround(files)));
  expectRefused(ErrorCode::tooLarge, {"MiB"});
  // Sizes whose sum runs over 64 bits.
  for (int n = 0; n < 5000; ++n)
    files.push_back({{"path", "volumes/huge" + std::to_string(n) + ".mha"}, {"size", 1ll << 52}, {"sha256", std::string(64, '0')}});
  writeRawBundle(file_, tiny_.bundle(headerAround(files)));
  expectRefused(ErrorCode::tooLarge, {"MiB"});
  // More room than any medium has.
  BundleLimits generous;
  generous.maxBytes = 1ull << 60;
  generous.maxExpansion = 1e30;
  files = tiny_.list();
  files.push_back({{"path", "volumes/huge.mha"}, {"size", 1ll << 52}, {"sha256", std::string(64, '0')}});
  writeRawBundle(file_, tiny_.bundle(headerAround(files)));
  const auto noRoom = importBundle(file_, folder_ / "world/library", generous);
  ASSERT_FALSE(noRoom);
  EXPECT_EQ(noRoom.error().code, ErrorCode::notWritable);
  EXPECT_NE(noRoom.error().sentence().find("free some room"), std::string::npos) << noRoom.error();
  EXPECT_EQ(treeOf(folder_ / "world"), before_);
  // Too many files.
  files = tiny_.list();
  for (int n = 0; n < 100'000; ++n) files.push_back({{"path", std::to_string(n)}, {"size", 0}, {"sha256", sumOf("")}});
  writeRawBundle(file_, tiny_.bundle(headerAround(files)));
  expectRefused(ErrorCode::tooLarge, {"100002 files"});
  // A path too long for folders that are deep already.
  writeWith({.path = "media/" + std::string(300, 'n'), .content = "x"}, true);
  expectRefused(ErrorCode::badField, {"longer than 240 bytes"});
}

TEST_F(BundleAttack, AFullMediumLeavesTheLibraryAsItWas) {
  makeVolumeCase(folder_ / "large", "knee", {100, 100, 100});
  ASSERT_TRUE(exportBundle(folder_ / "large", file_));
  // No file may grow beyond 100 kB: what a full medium does to whoever writes.
  rlimit usual{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &usual), 0);
  rlimit tight = usual;
  tight.rlim_cur = 100'000;
  auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &tight), 0);
  const auto imported = importBundle(file_, folder_ / "world/library");
  const auto published = publishCase(folder_ / "large", folder_ / "world/library");
  const auto exported = exportBundle(folder_ / "large", folder_ / "world/y.ewcase");
  ::setrlimit(RLIMIT_FSIZE, &usual);
  std::signal(SIGXFSZ, handler);
  for (const auto code : {imported.error().code, published.error().code, exported.error().code}) EXPECT_EQ(code, ErrorCode::notWritable);
  EXPECT_EQ(imported.error().sentence().find(".ew-"), std::string::npos) << "names of the user's alone: " << imported.error();
  EXPECT_EQ(treeOf(folder_ / "world"), before_);
}

}  // namespace
}  // namespace ew::test::bundle_attack_test
