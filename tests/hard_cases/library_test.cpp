#include <gtest/gtest.h>

#include <fstream>

#include "ew/library/case.h"
#include "ew/library/schema.h"
#include "library/temporary_folder.h"

namespace ew::library_test {
namespace {

using nlohmann::json;
using test::TemporaryFolder;
using test::writeText;

json manifestWithFile(const std::string& file) { return {{"format", 1}, {"id", "x"}, {"title", "X"}, {"volume", {{"file", file}}}}; }

TEST(HardCasesLibrary, APathThatLeavesTheCaseFolderIsRefused) {
  const TemporaryFolder folder;
  writeText(folder / "secret.mha", "outside");
  writeText(folder / "case/inside.mha", "inside");
  std::filesystem::create_symlink(folder / "secret.mha", folder / "case/link.mha");
  std::filesystem::create_directory_symlink(folder.path(), folder / "case/linked");
  std::filesystem::create_symlink("inside.mha", folder / "case/own.mha");
  const std::string absolute = (folder / "secret.mha").string();
  for (const std::string& file :
       {absolute, std::string("../secret.mha"), std::string("a/../../secret.mha"), std::string(".."), std::string("link.mha"),
        std::string("linked/secret.mha"), std::string("..\\secret.mha"), std::string("inside.mha\0x", 12), std::string("inside.mha/..")}) {
    writeText(folder / "case/case.json", manifestWithFile(file).dump());
    const auto problems = validateCase(folder / "case");
    ASSERT_EQ(problems.size(), 1u) << file;
    EXPECT_EQ(problems.front().code, ErrorCode::badField) << file << ": " << problems.front();
    EXPECT_EQ(problems.front().context.front().second, "volume.file");
  }
  for (const char* file : {"inside.mha", "./inside.mha", "own.mha"}) {
    writeText(folder / "case/case.json", manifestWithFile(file).dump());
    EXPECT_TRUE(validateCase(folder / "case").empty()) << file;
  }
}

TEST(HardCasesLibrary, AFolderOrADeviceIsNoFileOfACase) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "case/volumes");
  writeText(folder / "case/case.json", manifestWithFile("volumes").dump());
  ASSERT_EQ(validateCase(folder / "case").size(), 1u);
  EXPECT_EQ(validateCase(folder / "case").front().code, ErrorCode::notFound);
}

TEST(HardCasesLibrary, ManifestsMeantToBreakTheReaderAreSentences) {
  const TemporaryFolder folder;
  json longId = manifestWithFile("a.mha");
  longId["id"] = std::string(2'000'000, 'a');  // a recursive regular expression would overflow the stack
  const std::string manifests[] = {
      "",
      "null",
      "[]",
      "\"case\"",
      "\xef\xbb\xbf{",
      std::string(1'000'000, '['),
      "{\"a\":" + std::string(100'000, '['),
      "{\"format\": 1e400}",
      "{\"format\": 99999999999999999999999999}",
      "{\"format\": -1}",
      "{\"format\": 1, \"id\": \"\xff\xfe\"}",
      "{\"format\": 1, \"format\": 2, \"id\": 3}",
      R"({"format": 1, "id": "x", "title": "X", "volume": {"file": "a.mha", "file_to_world": [1e308,1e308,1e308,1e308,1,1,1,1,1,1,1,1,1,1,1,1]}})",
      R"({"format": 1, "id": "x", "title": "X", "volume": null})",
      longId.dump(),
  };
  for (const auto& text : manifests) {
    writeText(folder / "case.json", text);
    const auto opened = loadCase(folder.path());
    ASSERT_FALSE(opened) << text.substr(0, 60);
    EXPECT_TRUE(opened.error().sentence().ends_with('.')) << opened.error();
    EXPECT_LT(opened.error().sentence().size(), 600u) << "a sentence, not the file";
    EXPECT_NE(opened.error().code, ErrorCode::internal) << opened.error();
    EXPECT_FALSE(validateCase(folder.path()).empty());
  }
}

TEST(HardCasesLibrary, AnEnormousManifestIsRefusedBeforeItIsRead) {
  const TemporaryFolder folder;
  writeText(folder / "case.json", "{");
  std::filesystem::resize_file(folder / "case.json", 1ull << 36);  // sparse: 64 GiB on paper
  const auto opened = loadCase(folder.path());
  ASSERT_FALSE(opened);
  EXPECT_EQ(opened.error().code, ErrorCode::tooLarge);
}

TEST(HardCasesLibrary, EveryPrefixOfAManifestIsRefusedWithoutACrash) {
  const TemporaryFolder folder;
  writeText(folder / "a.mha", "x");
  const std::string whole = manifestWithFile("a.mha").dump(2);
  for (std::size_t length = 0; length < whole.size(); ++length) {
    writeText(folder / "case.json", whole.substr(0, length));
    EXPECT_FALSE(loadCase(folder.path())) << length;
  }
  writeText(folder / "case.json", whole);
  EXPECT_TRUE(loadCase(folder.path()));
}

TEST(HardCasesLibrary, TheBoundariesOfAllowedNumbersAreAllowed) {
  const TemporaryFolder folder;
  writeText(folder / "patient.json", "{}");
  for (const double spacing : {0.1, 10.0}) {
    json manifest = {{"format", 1}, {"id", "x"}, {"title", "X"}, {"volume", {{"recipe", "patient.json"}, {"recipe_spacing_mm", spacing}}}};
    for (const int age : {0, 130}) {
      manifest["patient"] = {{"age_years", age}};
      writeText(folder / "case.json", manifest.dump());
      for (const auto& problem : validateCase(folder.path())) ADD_FAILURE() << problem;
    }
  }
}

}  // namespace
}  // namespace ew::library_test
