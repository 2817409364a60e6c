#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <cstdlib>

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

/// A session bus and a keyring of its own, as a desktop has them. @return the exit status of `command` there
int withKeyring(const TemporaryFolder& folder, const std::string& command) {
  std::filesystem::create_directory(folder / "run");
  std::filesystem::permissions(folder / "run", std::filesystem::perms::owner_all);
  const std::string place = folder.path().string();
  writeText(folder / "session.sh", "export HOME='" + place + "' XDG_RUNTIME_DIR='" + place + "/run' XDG_DATA_HOME='" + place + "/data'\n" +
                                       "printf test | gnome-keyring-daemon --unlock --components=secrets > '" + place +
                                       "/started' 2>&1 || exit 77\n" + command + "\n");
  const int status = std::system(("timeout 60 dbus-run-session -- sh '" + place + "/session.sh' > '" + place + "/said' 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(Secrets, LieInTheKeyringWhereThereIsOne) {
  if (!hasKeyring()) GTEST_SKIP() << "this build knows of no keyring";
  if (std::system("command -v dbus-run-session gnome-keyring-daemon timeout > /dev/null") != 0) GTEST_SKIP() << "there is no keyring here";
  const TemporaryFolder folder;
  const std::string self = std::filesystem::read_symlink("/proc/self/exe").string();
  const int status = withKeyring(folder, "'" + self + "' --gtest_also_run_disabled_tests --gtest_filter='*AnsweringKeyring*'");
  if (status == 77 || status == 127) GTEST_SKIP() << "no keyring can be started here: " << textOf(folder / "said");
  EXPECT_EQ(status, 0) << textOf(folder / "said");
}

/// Run by the test above, in a session with a keyring.
TEST(Secrets, DISABLED_LieInAnAnsweringKeyring) {
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
