// Cases from elsewhere: recipes that are not what they should be, samples outside of the folder, pipes in place of files.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>

#include "ew/io/volume_file.h"
#include "ew/library/case.h"
#include "ew/library/file_import.h"
#include "ew/library/preparation.h"
#include "library/temporary_folder.h"

namespace ew::library_limits_test {
namespace {

using nlohmann::json;
using test::EnvironmentValue;
using test::TemporaryFolder;
using test::writeText;

json manifestOfRecipe() { return {{"format", 1}, {"id", "x"}, {"title", "X"}, {"volume", {{"recipe", "patient.json"}}}}; }

// The window asks these on its own thread, for every case of a folder: what leaves them as an exception ends it, and unsaved work with it.
TEST(HardCasesLibrary, NoRecipeMakesAPlanOrAnEstimateThrow) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", folder / "cache");
  writeText(folder / "case/case.json", manifestOfRecipe().dump());
  std::string chain;
  for (int n = 0; n < 20000; ++n)
    chain +=
        "\"p" + std::to_string(n) + R"(": {"default": "=p)" + std::to_string(n + 1) + R"(", "lowest": 0, "highest": 9, "unit": "mm"}, )";
  for (const auto& [patient, base] :
       {std::pair<std::string, std::string>{R"({"format": 1, "name": "c", "extends": "base.json", "parameters": {"a": 2}})",
                                            R"({"format": 1, "name": "b", "parameters": {"a": 1}})"},
        {R"({"format": 1, "name": "c", "extends": "base.json", "remove": {"organs": ["egg"]}})",
         R"({"format": 1, "name": "b", "organs": {"egg": 1}})"},
        {R"({"format": 1, "name": "c", "parameters": {)" + chain + R"("p20000": 1}})", "{}"},
        {R"({"format": 1, "name": 7, "parameters": 7, "organs": 7, "tissues": [7]})", "[]"}}) {
    writeText(folder / "case/patient.json", patient);
    writeText(folder / "case/base.json", base);
    const auto opened = loadCase(folder / "case");
    ASSERT_TRUE(opened) << opened.error();
    EXPECT_NO_THROW({
      EXPECT_FALSE(caseNeedsPreparation(*opened));
      const auto estimate = estimatePreparation(*opened);
      ASSERT_FALSE(estimate) << patient.substr(0, 80);
      EXPECT_NE(estimate.error().code, ErrorCode::internal) << estimate.error();
      EXPECT_TRUE(estimate.error().sentence().ends_with('.')) << estimate.error();
      EXPECT_EQ(listCases(folder.path()).cases.size(), 1u);
    }) << patient.substr(0, 80);
  }
}

TEST(HardCasesLibrary, SamplesThatAHeaderKeepsOutsideOfTheCaseFolderAreRefused) {
  const TemporaryFolder folder;
  const std::string samples(8, 'x');
  writeText(folder / "secret.raw", samples);
  writeText(folder / "case/inside.raw", samples);
  std::filesystem::create_symlink(folder / "secret.raw", folder / "case/link.raw");
  const auto meta = [](const std::string& data) {
    return "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = " + data +
           "\n";
  };
  const auto nrrd = [](const std::string& data) {
    return "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nspace: left-posterior-superior\n"
           "space directions: (2,0,0) (0,2,0) (0,0,2)\nspace origin: (0,0,0)\nencoding: raw\ndata file: " +
           data + "\n";
  };
  for (const char* field : {"file", "labels"}) {
    for (const auto& [name, header] : {std::pair<const char*, std::string (*)(const std::string&)>{"v.mhd", meta}, {"v.nhdr", nrrd}}) {
      json manifest = {{"format", 1}, {"id", "x"}, {"title", "X"}, {"volume", {{"file", name}}}};
      if (std::string(field) == "labels") manifest["volume"] = {{"file", "good.mha"}, {"labels", name}};
      writeText(folder / "case/good.mha", meta("LOCAL") + samples);
      writeText(folder / "case/case.json", manifest.dump());
      for (const std::string& outside : {(folder / "secret.raw").string(), std::string("../secret.raw"), std::string("link.raw")}) {
        writeText(folder / "case" / name, header(outside));
        const auto problems = validateCase(folder / "case");
        ASSERT_EQ(problems.size(), 1u) << name << " " << outside;
        EXPECT_EQ(problems.front().code, ErrorCode::badField) << problems.front();
        EXPECT_NE(problems.front().sentence().find("outside of the case folder"), std::string::npos) << problems.front();
        EXPECT_FALSE(loadCase(folder / "case")) << name << " " << outside;
        // One that was changed after the case was opened.
        writeText(folder / "case" / name, header("inside.raw"));
        const auto opened = loadCase(folder / "case");
        ASSERT_TRUE(opened) << opened.error();
        writeText(folder / "case" / name, header(outside));
        EXPECT_FALSE(loadCaseVolume(*opened, noProgress())) << name << " " << outside;
      }
      writeText(folder / "case" / name, header("inside.raw"));
      EXPECT_TRUE(validateCase(folder / "case").empty()) << name;
      const auto opened = loadCase(folder / "case");
      ASSERT_TRUE(opened) << opened.error();
      EXPECT_TRUE(loadCaseVolume(*opened, noProgress())) << name;
    }
  }
}

TEST(HardCasesLibrary, APipeOrADeviceIsNeverOpenedToSeeWhatItIs) {
  const TemporaryFolder folder;
  for (const char* name : {"a.vol", "b", "c.dcm", "d.mha", "e.png", "f.nii.gz"}) {
    ASSERT_EQ(::mkfifo((folder / name).c_str(), 0600), 0);
    const auto kind = kindOfFile(folder / name);
    ASSERT_FALSE(kind) << name;
    EXPECT_EQ(kind.error().code, ErrorCode::notReadable) << kind.error();
    EXPECT_FALSE(importFile(folder / name, {})) << name;
  }
  EXPECT_FALSE(kindOfFile("/dev/zero"));
}

TEST(HardCasesLibrary, ProbesThatAreNotThereAndAStartThatSeesNothingAreNamedByValidation) {
  const TemporaryFolder folder;
  writeText(folder / "case/v.mha",
            "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 100 100 100\nElementType = MET_UCHAR\n"
            "ElementDataFile = LOCAL\n12345678");
  json manifest = {{"format", 1}, {"id", "x"}, {"title", "X"}, {"volume", {{"file", "v.mha"}}}, {"probes", {"convex-3.5", "nosuch"}}};
  const auto startAt = [&](double z_mm) { manifest["start_pose"] = {1, 0, 0, 50, 0, 1, 0, 50, 0, 0, 1, z_mm, 0, 0, 0, 1}; };
  const auto fields = [&] {
    writeText(folder / "case/case.json", manifest.dump());
    std::vector<std::string> named;
    for (const Error& problem : validateCase(folder / "case")) named.push_back(problem.context.front().second);
    return named;
  };
  startAt(5000.0);
  EXPECT_EQ(fields(), (std::vector<std::string>{"probes[1]", "start_pose"}));
  EXPECT_TRUE(loadCase(folder / "case")) << "it can be opened all the same";
  manifest["probes"] = {"convex-3.5"};
  startAt(-40.0);
  EXPECT_EQ(fields(), std::vector<std::string>{});
  manifest["volume"]["file_to_world"] = {1, 0, 0, 0, 0, 1, 0, 900, 0, 0, 1, 0, 0, 0, 0, 1};
  EXPECT_EQ(fields(), std::vector<std::string>{"start_pose"}) << "the volume was moved, the start was not";
}

}  // namespace
}  // namespace ew::library_limits_test
