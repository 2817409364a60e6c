#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "places.h"
#include "rules/source_tree.h"

// A test reaches the window by its interface (ew/ui/) and by the test door (ew/ui_test_door/), whose headers say by subject what of the
// inside tests know. So what may change without a test is what stands in no header of the door.
namespace ew::rules::ui_test_door_test {
namespace {

namespace fs = std::filesystem;

const fs::path kTop = EW_SOURCE_DIR, kInside = kTop / "workstation/ui/src", kDoor = kTop / "workstation/ui/test_door/ew/ui_test_door";

std::string textOf(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::vector<Source> filesOfTests() {
  std::vector<Source> read;
  for (const auto& entry : fs::recursive_directory_iterator(kTop / "tests")) {
    const fs::path& file = entry.path();
    const bool isRead = file.extension() == ".cpp" || file.extension() == ".h" || file.filename() == "CMakeLists.txt";
    if (entry.is_regular_file() && isRead) read.push_back({fs::relative(file, kTop).generic_string(), textOf(file)});
  }
  return read;
}

std::vector<std::string> includesOf(const std::string& text) {
  static const std::regex include(R"re((?:^|\n)#include "([^"\n]+)")re");
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), include), end; at != end; ++at) found.push_back((*at)[1]);
  return found;
}

/// What a file of tests takes past the door: headers of the inside, or its folder as a place of headers.
std::vector<std::string> pastTheDoor(const Source& file) {
  std::vector<std::string> found;
  if (file.path.ends_with("CMakeLists.txt")) {
    static const std::regex place(R"(target_include_directories\([^)]*(?:workstation/ui/src|\$\{ui_src\})[^)]*\))");
    for (std::sregex_iterator at(file.text.begin(), file.text.end(), place), end; at != end; ++at) found.push_back(at->str());
    return found;
  }
  for (const std::string& name : includesOf(file.text))
    if (fs::exists(kInside / name)) found.push_back(name);
  return found;
}

TEST(UiTestDoor, IsTheOnlyWayOfTestsIntoTheWindow) {
  for (const Source& file : filesOfTests())
    for (const std::string& taken : pastTheDoor(file))
      ADD_FAILURE() << file.path << " takes " << taken << "; a header of workstation/ui/test_door/ew/ui_test_door has it, or is given it.";
}

TEST(UiTestDoor, HasNoHeaderThatNoTestOpens) {
  std::string all;
  for (const Source& file : filesOfTests()) all += file.text;
  for (const auto& entry : fs::directory_iterator(kDoor)) {
    const std::string name = entry.path().filename().string();
    EXPECT_NE(all.find("#include \"ew/ui_test_door/" + name + "\""), std::string::npos) << name;
    for (const std::string& header : includesOf(textOf(entry.path()))) EXPECT_TRUE(fs::exists(kInside / header)) << name << ": " << header;
  }
}

TEST(UiTestDoor, AWayPastItIsFound) {
  const std::string source = "tests/gui/made_test.cpp", list = "tests/gui/CMakeLists.txt";
  EXPECT_EQ(pastTheDoor({source, "#include \"scan/session.h\"\n"}).size(), 1u);
  EXPECT_EQ(pastTheDoor({source, "// One.\n#include <vector>\n\n#include \"window/frame/tour.h\"\n"}),
            std::vector<std::string>{"window/frame/tour.h"});
  EXPECT_TRUE(pastTheDoor({source, "#include \"ew/ui_test_door/scan.h\"\n#include \"trackers/camera_frames.h\"\n"}).empty());
  EXPECT_EQ(pastTheDoor({list, "target_include_directories(t PRIVATE ${CMAKE_SOURCE_DIR}/workstation/ui/src)"}).size(), 1u);
  EXPECT_EQ(pastTheDoor({list, "target_include_directories(t PRIVATE\n  a ${ui_src})\n"}).size(), 1u);
  EXPECT_TRUE(pastTheDoor({list, "set(ui_src ${CMAKE_SOURCE_DIR}/workstation/ui/src)\n"}).empty());
}

}  // namespace
}  // namespace ew::rules::ui_test_door_test
