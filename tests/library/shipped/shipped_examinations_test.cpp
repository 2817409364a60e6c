#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "ew/library/bundle.h"
#include "library/coarse_case.h"
#include "library/examination_world.h"

namespace ew::test::shipped_examinations_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// What trainees may read of a case, by its place in case.json; "*" is any place in a list. Written down a second time, on purpose: the
/// program's own list is trainee_view.cpp, and what a test takes from there it cannot test.
const std::set<std::string> kReadable = {"title_for_trainees",
                                         "region",
                                         "patient.name",
                                         "patient.sex",
                                         "patient.age_years",
                                         "complaint",
                                         "history",
                                         "indication",
                                         "mannequin",
                                         "probes.*",
                                         "presets.*",
                                         "start_pose.*",
                                         "volume.file_to_world.*",
                                         "volume.attribution",
                                         "volume.licence",
                                         "previous_examinations.*.when",
                                         "previous_examinations.*.kind",
                                         "previous_examinations.*.findings",
                                         "laboratory.*.when",
                                         "laboratory.*.findings",
                                         "parts.lessons.lessons.*.title",
                                         "parts.lessons.lessons.*.language",
                                         "parts.lessons.lessons.*.level",
                                         "parts.lessons.lessons.*.minutes",
                                         "parts.lessons.lessons.*.steps.*.task",
                                         "parts.lessons.lessons.*.steps.*.title",
                                         "parts.lessons.lessons.*.steps.*.text",
                                         "parts.lessons.lessons.*.steps.*.options.*.text",
                                         "parts.lessons.lessons.*.steps.*.unit",
                                         "parts.lessons.lessons.*.steps.*.time_s",
                                         "parts.lessons.lessons.*.steps.*.shortest_s"};

struct Leaves {
  std::set<std::string> readable, secretTexts, secretNumbers;
};

/// A number as files write it, when it is one that is not met by chance: five digits and more, three of which count.
std::string unmistakable(const json& number) {
  constexpr std::ptrdiff_t kDigits = 5, kSignificant = 3;
  const std::string text = number.dump();
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  const auto first = std::find_if(text.begin(), text.end(), [](char c) { return c >= '1' && c <= '9'; });
  const bool isOne = number.is_number_float() && std::count_if(text.begin(), text.end(), isDigit) >= kDigits &&
                     std::count_if(first, text.end(), isDigit) >= kSignificant;
  return isOne ? text : std::string();
}

void gather(const json& value, const std::string& place, bool isReadable, Leaves& into) {
  if (value.is_object()) {
    // Texts of steps that come after the first question, and of experts' scans, are not for trainees.
    bool hasAsked = false;
    for (const auto& [key, inner] : value.items()) {
      const std::string at = place.empty() ? key : place + "." + key;
      if (key != "steps") {
        gather(inner, at, isReadable, into);
        continue;
      }
      for (const json& step : inner) {
        const std::string task = step["task"];
        const bool asks = task != "read" && task != "watch";
        hasAsked = hasAsked || asks;
        gather(step, at + ".*", isReadable && task != "watch" && (asks || !hasAsked), into);
      }
    }
    return;
  }
  if (value.is_array()) {
    for (const json& inner : value) gather(inner, place + ".*", isReadable, into);
    return;
  }
  const bool may = isReadable && kReadable.contains(place);
  if (value.is_string())
    (may ? into.readable : into.secretTexts).insert(value.get<std::string>());
  else if (may)
    into.readable.insert(value.dump());
  else if (const std::string number = unmistakable(value); !number.empty())
    into.secretNumbers.insert(number);
}

/// Names of fields: what is called like one is no secret of a case.
void gatherFieldNames(const json& value, std::string& names) {
  if (value.is_object())
    for (const auto& [key, inner] : value.items()) names += key + "\n";
  if (value.is_structured())
    for (const json& inner : value) gatherFieldNames(inner, names);
}

/// Texts of three letters are met everywhere; what trainees read anyway is no secret although it stands in a field that is.
bool isTelling(const std::string& text, const std::string& everythingReadable) {
  constexpr std::size_t kShortest = 4;
  return text.size() >= kShortest && everythingReadable.find(text) == std::string::npos;
}

/// A number as a whole, not as a part of another one.
std::string placeOfNumber(const std::string& number, const std::map<std::string, std::string>& files) {
  const auto isDigit = [](char c) { return (c >= '0' && c <= '9') || c == '.'; };
  for (const auto& [name, bytes] : files)
    for (auto at = bytes.find(number); at != std::string::npos; at = bytes.find(number, at + 1)) {
      const bool goesOn = at + number.size() < bytes.size() && isDigit(bytes[at + number.size()]);
      if (!goesOn && (at == 0 || !isDigit(bytes[at - 1]))) return name;
    }
  return {};
}

Leaves leavesOf(const fs::path& folder) {
  Leaves leaves;
  gather(json::parse(textOf(folder / "case.json")), {}, true, leaves);
  for (const auto& each : fs::recursive_directory_iterator(folder)) {
    const std::string name = each.path().lexically_relative(folder).string();
    if (each.path().extension() != ".json" || name == "case.json") continue;
    const json document = json::parse(textOf(each.path()));
    if (!name.starts_with("words/")) {
      gather(document, {}, false, leaves);  // recipe, sweeps
      continue;
    }
    for (const auto& [text, translation] : document["words"].items())
      (leaves.readable.contains(text) ? leaves.readable : leaves.secretTexts).insert(translation.get<std::string>());
  }
  return leaves;
}

class ShippedExamination : public ::testing::TestWithParam<std::string> {};

TEST_P(ShippedExamination, HoldsNoTextAndNoNumberOfTheAnswerKey) {
  const TemporaryFolder folder;
  const EnvironmentValue cache("ECHOWEAVE_CACHE", (folder / "cache").string());
  copyCoarse(*shippedCasesFolder() / GetParam(), folder / "case", 6.0);  // what it looks like is not looked at here
  const SecretKey key = *SecretKey::make();
  const auto made = makeExamination(folder / "case", folder / "e", {.instructors = {key.publicKey()}});
  ASSERT_TRUE(made) << made.error();
  ASSERT_TRUE(exportBundle(folder / "e", folder / "e.ewcase"));
  const auto files = filesInBundle(folder / "e.ewcase");
  const Leaves leaves = leavesOf(folder / "case");
  std::string readable;
  for (const std::string& each : leaves.readable) readable += each + "\n";
  for (const char* name : {"case.json", "bundle.json"}) gatherFieldNames(json::parse(files.at(name)), readable);
  std::size_t looked = 0;
  for (const std::string& text : leaves.secretTexts) {
    if (!isTelling(text, readable)) continue;
    ++looked;
    EXPECT_EQ(placeOf(text, files), "") << text;
  }
  for (const std::string& number : leaves.secretNumbers) {
    if (leaves.readable.contains(number)) continue;
    ++looked;
    EXPECT_EQ(placeOfNumber(number, files), "") << number;
  }
  EXPECT_GT(looked, 100u) << "of the key hardly anything was looked for";
  std::cout << GetParam() << ": " << looked << " texts and numbers of the key, " << files.size() << " files\n";
  EXPECT_EQ(placeOf(GetParam(), files), "") << "the id names the finding";

  ASSERT_TRUE(openExamination(folder / "e", key, folder / "again"));
  EXPECT_EQ(filesInFolder(folder / "again"), filesInFolder(folder / "case"));
}

INSTANTIATE_TEST_SUITE_P(Cases, ShippedExamination, ::testing::ValuesIn(shippedIds()), nameOfCase);

}  // namespace
}  // namespace ew::test::shipped_examinations_test
