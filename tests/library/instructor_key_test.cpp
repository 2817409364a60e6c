#include "ew/library/instructor_key.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "library/temporary_folder.h"

namespace ew::test::instructor_key_test {
namespace {

namespace fs = std::filesystem;

/// So that a test takes milliseconds; the figures of the product are PassphraseCost's own.
constexpr PassphraseCost kCheap{.passes = 1, .memory_bytes = 64 << 10};
const Passphrase kWords("correct horse battery");

mode_t modeOf(const fs::path& file) {
  struct stat found {};
  EXPECT_EQ(::lstat(file.c_str(), &found), 0) << file;
  return found.st_mode & 0777;
}

class InstructorKey : public ::testing::Test {
 protected:
  void SetUp() override {
    auto made = SecretKey::make();
    ASSERT_TRUE(made) << made.error();
    key_ = std::make_unique<SecretKey>(*made);
    file_ = folder_ / "keys" / "instructor.key";
    auto kept = keepSecretKey(*key_, kWords, file_, kCheap);
    ASSERT_TRUE(kept) << kept.error();
  }
  void change(const std::function<void(nlohmann::json&)>& how) const {
    auto document = nlohmann::json::parse(textOf(file_));
    how(document);
    writeText(file_, document.dump());
  }
  const TemporaryFolder folder_;
  std::unique_ptr<SecretKey> key_;
  fs::path file_;
};

TEST_F(InstructorKey, ComesBackWithItsPassphraseAlone) {
  const auto opened = openSecretKey(file_, kWords);
  ASSERT_TRUE(opened) << opened.error();
  EXPECT_TRUE(std::equal(opened->bytes(), opened->bytes() + 32, key_->bytes()));
  EXPECT_EQ(opened->publicKey(), key_->publicKey());
  EXPECT_EQ(publicKeyKeptIn(file_), key_->publicKey());
  for (const char* wrong : {"", "correct horse batterz", "Correct horse battery", "correct horse battery "}) {
    const auto refused = openSecretKey(file_, Passphrase(wrong));
    ASSERT_FALSE(refused) << wrong;
    EXPECT_NE(refused.error().sentence().find("does not open"), std::string::npos);
    EXPECT_EQ(refused.error().sentence().find("horse"), std::string::npos) << "an error says no passphrase";
  }
}

TEST_F(InstructorKey, IsForThisAccountAloneAndNotInTheOpen) {
  EXPECT_EQ(modeOf(file_), 0600u);
  EXPECT_EQ(modeOf(file_.parent_path()), 0700u);
  const std::string text = textOf(file_);
  EXPECT_EQ(text.find(std::string(reinterpret_cast<const char*>(key_->bytes()), 32)), std::string::npos);
  EXPECT_EQ(text.find("horse"), std::string::npos);
}

TEST_F(InstructorKey, IsNotReadWhenOthersCouldHaveChangedIt) {
  for (const mode_t wide : {0640, 0604, 0620, 0660}) {
    ::chmod(file_.c_str(), wide);
    const auto refused = openSecretKey(file_, kWords);
    ASSERT_FALSE(refused) << wide;
    EXPECT_NE(refused.error().sentence().find("chmod 600"), std::string::npos);
  }
}

TEST_F(InstructorKey, OfAnotherAccountIsRefused) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can make a file of another account";
  ASSERT_EQ(::chown(file_.c_str(), 65534, 65534), 0);
  const auto refused = openSecretKey(file_, kWords);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence().find("another account"), std::string::npos);
}

TEST_F(InstructorKey, IsNeverWrittenOver) {
  const auto again = keepSecretKey(*SecretKey::make(), kWords, file_, kCheap);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, ErrorCode::notWritable);
  EXPECT_TRUE(openSecretKey(file_, kWords));
  fs::remove(file_);
  fs::create_symlink(folder_ / "elsewhere", file_);
  EXPECT_FALSE(keepSecretKey(*key_, kWords, file_, kCheap)) << "through a link that leads to nothing";
}

TEST_F(InstructorKey, ThatWasTamperedWithDoesNotOpen) {
  const auto other = SecretKey::make();
  const std::string whole = textOf(file_);
  const auto refused = [&](const char* what, const std::function<void(nlohmann::json&)>& how) {
    writeText(file_, whole);
    change(how);
    EXPECT_FALSE(openSecretKey(file_, kWords)) << what;
  };
  refused("public key exchanged", [&](auto& d) { d["public"] = textOf(other->publicKey()); });
  refused("bytes", [](auto& d) {
    std::string box = d["sealed"];
    box[5] = box[5] == 'A' ? 'B' : 'A';
    d["sealed"] = box;
  });
  refused("salt", [](auto& d) { d["salt"] = "AAAAAAAAAAAAAAAAAAAAAA=="; });
  refused("short box", [](auto& d) { d["sealed"] = "AAAA"; });
  refused("endless work", [](auto& d) { d["passes"] = 1'000'000; });
  refused("all memory", [](auto& d) { d["memory_bytes"] = 1ull << 40; });
  refused("no passes", [](auto& d) { d.erase("passes"); });
  writeText(file_, whole);
  change([](auto& d) { d["format"] = 2; });
  EXPECT_EQ(openSecretKey(file_, kWords).error().code, ErrorCode::newerFormat);
  writeText(file_, whole.substr(0, whole.size() / 2));
  EXPECT_EQ(openSecretKey(file_, kWords).error().code, ErrorCode::badHeader);
}

TEST_F(InstructorKey, NeedsAPassphraseWorthItsName) {
  const fs::path other = folder_ / "other.key";
  EXPECT_FALSE(keepSecretKey(*key_, Passphrase(), other, kCheap));
  EXPECT_FALSE(keepSecretKey(*key_, Passphrase("seven77"), other, kCheap));
  EXPECT_FALSE(keepSecretKey(*key_, Passphrase("öäüöäüö"), other, kCheap)) << "seven characters of two bytes";
  EXPECT_FALSE(keepSecretKey(*key_, Passphrase("with a\nline"), other, kCheap));
  EXPECT_FALSE(fs::exists(other));
  EXPECT_TRUE(keepSecretKey(*key_, Passphrase("öäüöäüöä"), other, kCheap));
}

TEST(PublicKey, GoesByTextAndBack) {
  const auto key = SecretKey::make()->publicKey();
  EXPECT_EQ(publicKeyOf(textOf(key)), key);
  EXPECT_EQ(publicKeyOf("# a remark\n\n  " + textOf(key) + " \r\n"), key);
  const TemporaryFolder folder;
  ASSERT_TRUE(writePublicKey(key, folder / "k.pub"));
  EXPECT_EQ(readPublicKey(folder / "k.pub"), key);
  EXPECT_EQ(shortNameOf(key).size(), 19u);
}

TEST(PublicKey, ThatWasMistypedAnywhereIsRefused) {
  const auto key = SecretKey::make()->publicKey();
  const std::string text = textOf(key);
  for (std::size_t n = 0; n < text.size(); ++n) {
    std::string wrong = text;
    wrong[n] = wrong[n] == 'x' ? 'y' : 'x';
    const auto read = publicKeyOf(wrong);
    EXPECT_TRUE(!read || *read == key) << wrong;
    EXPECT_FALSE(read) << wrong;
  }
  for (const std::string& wrong : {std::string(), std::string("#"), text.substr(0, 30), text + " more", textOf(PublicKey{}).substr(0, 60)})
    EXPECT_FALSE(publicKeyOf(wrong)) << wrong;
}

TEST(PassphraseHash, FitsItsPassphraseAlone) {
  const auto hash = hashOf(kWords, kCheap);
  ASSERT_TRUE(hash);
  EXPECT_TRUE(fits(kWords, *hash));
  EXPECT_FALSE(fits(Passphrase("correct horse batterz"), *hash));
  EXPECT_FALSE(fits(kWords, ""));
  EXPECT_FALSE(fits(kWords, "correct horse battery"));
  EXPECT_FALSE(fits(kWords, hash->substr(0, hash->size() - 3)));
  EXPECT_NE(*hashOf(kWords, kCheap), *hash) << "each has a salt of its own";
  EXPECT_EQ(hash->find("horse"), std::string::npos);
}

TEST(InstructorKeyFolder, LiesOutsideOfAnyLibrary) {
  const EnvironmentValue none("ECHOWEAVE_KEYS", ""), data("XDG_DATA_HOME", "/somewhere/data");
  EXPECT_EQ(instructorKeyFile(), fs::path("/somewhere/data/echoweave/keys/instructor.key"));
  const EnvironmentValue unset("XDG_DATA_HOME", ""), home("HOME", "/home/x");
  EXPECT_EQ(instructorKeyFolder(), fs::path("/home/x/.local/share/echoweave/keys"));
}

}  // namespace
}  // namespace ew::test::instructor_key_test
