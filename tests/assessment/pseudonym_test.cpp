#include "ew/assessment/pseudonym.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <regex>
#include <set>

#include "library/temporary_folder.h"

namespace ew::pseudonym_test {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using test::textOf;
using test::writeText;

std::string hashOf(const std::string& key, const std::string& text) { return keyedHash(std::as_bytes(std::span(key)), text); }

/// RFC 4231, test cases 1, 2, 3, 6 and 7.
TEST(KeyedHash, HasThePublishedValues) {
  EXPECT_EQ(hashOf(std::string(20, '\x0b'), "Hi There"), "b0344c61d8db38535ca8afceaf0bf12b881dc200c9833da726e9376c2e32cff7");
  EXPECT_EQ(hashOf("Jefe", "what do ya want for nothing?"), "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
  EXPECT_EQ(hashOf(std::string(20, '\xaa'), std::string(50, '\xdd')), "773ea91e36800e46854db8ebd09181a72959098b3ef8c122d9635514ced565fe");
  EXPECT_EQ(hashOf(std::string(131, '\xaa'), "Test Using Larger Than Block-Size Key - Hash Key First"),
            "60e431591ee0b67f0d8a26aacbf5b77f8e0bc6213728c5140546040f0ee37f54");
  EXPECT_EQ(hashOf(std::string(131, '\xaa'),
                   "This is a test using a larger than block-size key and a larger than block-size data. The key needs to be hashed before "
                   "being used by the HMAC algorithm."),
            "9b09ffa71b942fcb27635fbcd5b0e944bfdc63644f0713938a7f51535c3a35e2");
}

Pseudonyms::Key keyOf(unsigned char byte) {
  Pseudonyms::Key key;
  key.fill(std::byte{byte});
  return key;
}

TEST(Pseudonyms, AreShortAndTheSameForAKeyAlone) {
  const Pseudonyms one(keyOf(1)), other(keyOf(2));
  const std::string code = one.ofPerson("Ada");
  EXPECT_TRUE(std::regex_match(code, std::regex("T-[0-9A-HJKMNP-TV-Z]{4}-[0-9A-HJKMNP-TV-Z]{4}"))) << code;
  EXPECT_EQ(Pseudonyms(keyOf(1)).ofPerson("Ada"), code);
  EXPECT_NE(other.ofPerson("Ada"), code);
  EXPECT_EQ(one.ofReviewer("Ada"), "R" + code.substr(1)) << "the same person, who is no trainee here";
  EXPECT_NE(one.ofPerson("Ada"), one.ofPerson("ada"));
}

/// Its first 40 bits, five to a letter.
TEST(Pseudonyms, AreTheBeginningOfTheHash) {
  const Pseudonyms one(keyOf(0));
  const std::string key(32, '\0');
  const std::string hash = hashOf(key, "person:Ada");
  std::string bits;
  for (const char digit : hash.substr(0, 10)) {
    const int value = digit <= '9' ? digit - '0' : digit - 'a' + 10;
    for (int bit = 3; bit >= 0; --bit) bits += (value >> bit & 1) != 0 ? '1' : '0';
  }
  std::string expected = "T-";
  for (std::size_t n = 0; n < 8; ++n) {
    expected += "0123456789ABCDEFGHJKMNPQRSTVWXYZ"[std::stoul(bits.substr(5 * n, 5), nullptr, 2)];
    if (n == 3) expected += '-';
  }
  EXPECT_EQ(one.ofPerson("Ada"), expected);
}

TEST(Pseudonyms, TellTenThousandPeopleApart) {
  const Pseudonyms one(keyOf(7));
  std::set<std::string> codes;
  for (int n = 0; n < 10'000; ++n) codes.insert(one.ofPerson("person-" + std::to_string(n)));
  EXPECT_EQ(codes.size(), 10'000u);
}

TEST(Pseudonyms, OfALibraryHaveAKeyThatIsMadeOnceAndOnlyItsOwnerReads) {
  const TemporaryFolder library, another;
  const auto first = Pseudonyms::ofLibrary(library.path());
  ASSERT_TRUE(first) << first.error();
  const fs::path file = pseudonymKeyFile(library.path());
  EXPECT_EQ(file, library / "assessment" / "pseudonyms.key");
  struct stat found {};
  ASSERT_EQ(::stat(file.c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0777U, 0600U);
  EXPECT_EQ(textOf(file).size(), 65u);
  const std::string key = textOf(file);
  const auto second = Pseudonyms::ofLibrary(library.path());
  ASSERT_TRUE(second);
  EXPECT_EQ(second->ofPerson("x"), first->ofPerson("x"));
  EXPECT_EQ(textOf(file), key);
  EXPECT_NE(Pseudonyms::ofLibrary(another.path())->ofPerson("x"), first->ofPerson("x"));
  for (const auto& each : fs::directory_iterator(file.parent_path()))
    EXPECT_TRUE(each.path() == file || each.path().filename() == ".lock") << each.path();
}

TEST(Pseudonyms, NeverReplaceAKeyThatIsDamaged) {
  const TemporaryFolder library;
  const fs::path file = pseudonymKeyFile(library.path());
  const std::vector<std::string> wrongs = {
      "", "abc\n", std::string(64, 'g'), std::string(63, 'a'), std::string(65, 'a'), std::string(5000, 'a')};
  for (const std::string& wrong : wrongs) {
    writeText(file, wrong);
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
    const auto pseudonyms = Pseudonyms::ofLibrary(library.path());
    ASSERT_FALSE(pseudonyms) << wrong;
    EXPECT_EQ(pseudonyms.error().code, ErrorCode::badHeader);
    EXPECT_NE(pseudonyms.error().sentence().find("everybody then gets other codes"), std::string::npos);
    EXPECT_EQ(textOf(file), wrong);
  }
}

TEST(Pseudonyms, RefuseAKeyThatOthersMayReadOrThatLiesElsewhere) {
  const TemporaryFolder library, another;
  ASSERT_TRUE(Pseudonyms::ofLibrary(library.path()));
  const fs::path file = pseudonymKeyFile(library.path());
  fs::permissions(file, fs::perms::group_read, fs::perm_options::add);
  EXPECT_EQ(Pseudonyms::ofLibrary(library.path()).error().code, ErrorCode::notReadable);
  fs::permissions(file, fs::perms::group_read, fs::perm_options::remove);
  EXPECT_TRUE(Pseudonyms::ofLibrary(library.path()));
  fs::create_directories(pseudonymKeyFile(another.path()).parent_path());
  fs::create_symlink(file, pseudonymKeyFile(another.path()));
  EXPECT_FALSE(Pseudonyms::ofLibrary(another.path()));
  fs::remove(pseudonymKeyFile(another.path()));
  fs::create_symlink(another / "nowhere", pseudonymKeyFile(another.path()));
  EXPECT_FALSE(Pseudonyms::ofLibrary(another.path())) << "nor is a key written through a link";
  EXPECT_FALSE(fs::exists(another / "nowhere"));
}

TEST(Pseudonyms, SayThatTheLibraryCannotBeWritten) {
  const TemporaryFolder library;
  writeText(library / "assessment", "a file");
  EXPECT_EQ(Pseudonyms::ofLibrary(library.path()).error().code, ErrorCode::notWritable);
}

TEST(Pseudonyms, AreTheSameOfWindowsThatStartAtOnce) {
  for (int trial = 0; trial < 10; ++trial) {
    const TemporaryFolder library;
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    for (int window = 0; window < 4; ++window) {
      if (::fork() != 0) continue;
      const auto pseudonyms = Pseudonyms::ofLibrary(library.path());
      const std::string code = pseudonyms ? pseudonyms->ofPerson("Ada") : std::string("T-FAIL-FAIL");
      ::_exit(::write(ends[1], code.data(), code.size()) == static_cast<ssize_t>(code.size()) ? 0 : 1);
    }
    ::close(ends[1]);
    for (int window = 0; window < 4; ++window) {
      int status = 0;
      ::wait(&status);
      EXPECT_EQ(status, 0);
    }
    std::string all;
    for (char one = 0; ::read(ends[0], &one, 1) == 1;) all += one;
    ::close(ends[0]);
    const std::string code = Pseudonyms::ofLibrary(library.path())->ofPerson("Ada");
    EXPECT_EQ(all, code + code + code + code);
  }
}

}  // namespace
}  // namespace ew::pseudonym_test
