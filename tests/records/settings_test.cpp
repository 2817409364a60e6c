#include <gtest/gtest.h>
#include <sys/stat.h>

#include "ew/records/record_store_settings.h"
#include "library/temporary_folder.h"

namespace ew::test::record_settings_test {
namespace {

namespace fs = std::filesystem;

const SecretOptions kNoKeyring{false, 1.0};

RecordStoreSettings someSettings() {
  RecordStoreSettings settings;
  settings.endpoint = "https://records.example/xapi";
  settings.user = "mona";
  settings.homePage = "https://school.example/";
  settings.certificates = "/etc/school.pem";
  return settings;
}

mode_t modeOf(const fs::path& place) {
  struct stat found {};
  EXPECT_EQ(::stat(place.c_str(), &found), 0) << place;
  return found.st_mode & 0777;
}

TEST(RecordStoreSettings, ComeBackAsTheyWereWritten) {
  const TemporaryFolder folder;
  auto settings = someSettings();
  ASSERT_TRUE(writeRecordStoreSettings(settings, folder / "c"));
  EXPECT_EQ(readRecordStoreSettings(folder / "c"), settings);
  settings.login = RecordStoreSettings::Login::bearer;
  settings.allowsHttp = true;
  settings.endpoint = "http://records.example/";
  ASSERT_TRUE(writeRecordStoreSettings(settings, folder / "c"));
  EXPECT_EQ(readRecordStoreSettings(folder / "c"), settings);
}

TEST(RecordStoreSettings, RefuseAnEndpointThatPasswordsMayNotGoTo) {
  const TemporaryFolder folder;
  auto settings = someSettings();
  settings.endpoint = "http://records.example/";
  const auto written = writeRecordStoreSettings(settings, folder / "c");
  ASSERT_FALSE(written);
  EXPECT_NE(written.error().sentence().find("use https"), std::string::npos) << written.error();
  EXPECT_FALSE(fs::exists(folder / "c"));
  settings.endpoint = "http://localhost:8080/xapi/";
  EXPECT_TRUE(writeRecordStoreSettings(settings, folder / "c"));
}

TEST(RecordStoreSettings, SayWhatIsWrongWithAFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(readRecordStoreSettings(folder / "none").error().code, ErrorCode::notFound);
  const auto said = [&](const std::string& text) {
    writeText(folder / "c/record-store.json", text);
    const auto read = readRecordStoreSettings(folder / "c");
    return read ? std::string("read") : read.error().sentence();
  };
  EXPECT_NE(said("{\"format\": 2}").find("format 2"), std::string::npos);
  EXPECT_NE(said("{\"format\": 1, \"endpiont\": \"x\"}").find("endpiont"), std::string::npos);
  EXPECT_NE(said("{\"format\": 1, \"endpoint\": \"http://records.example/\"}").find("use https"), std::string::npos);
  EXPECT_NE(said("{\"format\": 1, \"login\": \"magic\"}").find("\"basic\" or \"bearer\""), std::string::npos);
}

TEST(Secrets, LieInAFileThatOnlyItsOwnerReads) {
  const TemporaryFolder folder;
  ASSERT_EQ(keepSecret(folder / "c", "record-store", "pass word", kNoKeyring), SecretPlace::file);
  EXPECT_EQ(readSecret(folder / "c", "record-store", kNoKeyring), "pass word");
  EXPECT_EQ(modeOf(folder / "c/secrets"), 0700u);
  EXPECT_EQ(modeOf(folder / "c/secrets/record-store"), 0600u);
  ASSERT_TRUE(keepSecret(folder / "c", "record-store", "another", kNoKeyring));
  EXPECT_EQ(readSecret(folder / "c", "record-store", kNoKeyring), "another");
  ASSERT_TRUE(forgetSecret(folder / "c", "record-store", kNoKeyring));
  EXPECT_EQ(readSecret(folder / "c", "record-store", kNoKeyring).error().code, ErrorCode::notFound);
  EXPECT_TRUE(forgetSecret(folder / "c", "record-store", kNoKeyring));
}

TEST(Secrets, AFileOrAFolderThatOthersMayReadIsNotUsed) {
  const TemporaryFolder folder;
  ASSERT_TRUE(keepSecret(folder / "c", "record-store", "secret-word", kNoKeyring));
  for (const mode_t mode : {0640u, 0604u, 0660u, 0666u, 0610u}) {
    ::chmod((folder / "c/secrets/record-store").c_str(), mode);
    const auto read = readSecret(folder / "c", "record-store", kNoKeyring);
    ASSERT_FALSE(read) << mode;
    EXPECT_EQ(read.error().code, ErrorCode::notReadable);
    EXPECT_EQ(read.error().sentence().find("secret-word"), std::string::npos);
  }
  ::chmod((folder / "c/secrets/record-store").c_str(), 0600);
  ::chmod((folder / "c/secrets").c_str(), 0750);
  EXPECT_FALSE(readSecret(folder / "c", "record-store", kNoKeyring));
  EXPECT_FALSE(keepSecret(folder / "c", "record-store", "other", kNoKeyring));
  ::chmod((folder / "c/secrets").c_str(), 0700);
  EXPECT_EQ(readSecret(folder / "c", "record-store", kNoKeyring), "secret-word");
}

TEST(Secrets, ALinkIsNotFollowed) {
  const TemporaryFolder folder;
  ASSERT_TRUE(keepSecret(folder / "c", "record-store", "secret-word", kNoKeyring));
  writeText(folder / "elsewhere", "planted");
  ::chmod((folder / "elsewhere").c_str(), 0600);
  fs::remove(folder / "c/secrets/record-store");
  fs::create_symlink(folder / "elsewhere", folder / "c/secrets/record-store");
  EXPECT_FALSE(readSecret(folder / "c", "record-store", kNoKeyring));
  ASSERT_TRUE(keepSecret(folder / "c", "record-store", "mine", kNoKeyring)) << "the link is replaced";
  EXPECT_EQ(textOf(folder / "elsewhere"), "planted");
}

TEST(Secrets, RefuseNamesAndContentsThatCannotBe) {
  const TemporaryFolder folder;
  for (const char* name : {"", "../x", "A", "a b"}) EXPECT_FALSE(keepSecret(folder / "c", name, "s", kNoKeyring)) << name;
  EXPECT_FALSE(keepSecret(folder / "c", "a", "", kNoKeyring));
  EXPECT_FALSE(keepSecret(folder / "c", "a", std::string("a\0b", 3), kNoKeyring));
  EXPECT_FALSE(fs::exists(folder / "c"));
}

TEST(RecordStoreOf, JoinsSettingsAndSecret) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeRecordStoreSettings(someSettings(), folder / "c"));
  EXPECT_EQ(recordStoreOf(folder / "c", kNoKeyring).error().code, ErrorCode::notFound);
  ASSERT_TRUE(keepSecret(folder / "c", kRecordStoreSecret, "secret:1", kNoKeyring));
  const auto store = recordStoreOf(folder / "c", kNoKeyring);
  ASSERT_TRUE(store) << store.error();
  EXPECT_EQ(store->authorization, "Basic bW9uYTpzZWNyZXQ6MQ==");
  EXPECT_EQ(textOf(folder / "c/record-store.json").find("secret:1"), std::string::npos);
}

/// With a keyring of its own: `dbus-run-session` starts one, as a desktop has it (the test is given EW_TEST_KEYRING then).
TEST(Secrets, LieInTheKeyringWhereThereIsOne) {
  if (!hasKeyring()) GTEST_SKIP() << "this build knows of no keyring";
  if (std::getenv("EW_TEST_KEYRING") == nullptr) GTEST_SKIP() << "no keyring was started for this test";
  const TemporaryFolder folder;
  ASSERT_TRUE(keepSecret(folder / "c", "record-store", "in a file", kNoKeyring));
  ASSERT_EQ(keepSecret(folder / "c", "record-store", "in the ring"), SecretPlace::keyring);
  EXPECT_FALSE(fs::exists(folder / "c/secrets/record-store")) << "nothing stays in the file";
  EXPECT_EQ(readSecret(folder / "c", "record-store"), "in the ring");
  EXPECT_EQ(readSecret(folder / "d", "record-store").error().code, ErrorCode::notFound) << "another folder has its own";
  ASSERT_TRUE(forgetSecret(folder / "c", "record-store"));
  EXPECT_EQ(readSecret(folder / "c", "record-store").error().code, ErrorCode::notFound);
}

}  // namespace
}  // namespace ew::test::record_settings_test
