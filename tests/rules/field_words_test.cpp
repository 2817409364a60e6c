#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

#include "places.h"
#include "rules/source_tree.h"

// One concept, one word (resources/docs/developer/glossary.md). A type is a thing: its name begins with a noun or an adjective, not with
// what was done to it, unless textbooks call the thing so. What is seen on a screen is an image.
namespace ew::rules::field_words_test {
namespace {

using Matches = std::sregex_iterator;

/// Types whose participle is the field's own term, each with its reason.
const std::map<std::string, std::string>& participlesOfTheField() {
  static const std::map<std::string, std::string> terms = {
      {"FixedPosition", "Fixed-point arithmetic."},
      {"MappedVolume", "A memory-mapped file."},
      {"SealedBox", "The sealed box of public-key encryption."},
      {"SimulatedHand", "Simulated users, as simulated patients in medical education."},
      {"SimulatedPerson", "Simulated users, as simulated patients in medical education."},
      {"SimulatedStep", "Simulated users, as simulated patients in medical education."},
      {"TrackedBody", "A rigid body that a tracker follows: its vendors' word."},
      {"TrackedFrame", "An image with its pose: the word of PLUS."},
      {"TrackedProbe", "A probe that a tracker follows: the literature's word."},
      {"TrackedProbeOptions", "A probe that a tracker follows: the literature's word."},
      {"UnsavedVolume", "Unsaved work, as every editor says."},
      {"UnsavedVolumes", "Unsaved work, as every editor says."},
      {"UnsavedWork", "Unsaved work, as every editor says."},
  };
  return terms;
}

/// Names of types of a text that begin with a past participle, with where they stand.
std::vector<std::pair<std::string, std::ptrdiff_t>> participlesIn(const std::string& code) {
  static const std::regex type(
      R"(\b(?:class|struct|enum|using)\s+(?:\[\[\w+\]\]\s+)?((?!(?:Bed|Feed|Need|Red|Seed|Speed)[A-Z])(?:[A-Z][a-z]*ed|Begun|Bent|Bound|)"
      R"(Broken|Brought|Built|Caught|Chosen|Done|Drawn|Driven|Fallen|Felt|Found|Frozen|Given|Grown|Heard|Held|Hidden|Kept|Known|Laid|)"
      R"(Left|Lost|Made|Met|Paid|Read|Said|Seen|Sent|Shown|Sold|Spoken|Stuck|Taken|Thought|Thrown|Told|Torn|Worn|Woven|Written)[A-Z]\w*))",
      std::regex::optimize);
  std::vector<std::pair<std::string, std::ptrdiff_t>> found;
  for (Matches at(code.begin(), code.end(), type), end; at != end; ++at) found.emplace_back((*at)[1], at->position(1));
  return found;
}

std::vector<Offence> participles(const Source& source) {
  std::vector<Offence> found;
  for (const auto& [name, at] : participlesIn(codeOf(source))) {
    if (participlesOfTheField().contains(name)) continue;
    const auto line = 1 + std::count(source.text.begin(), source.text.begin() + at, '\n');
    found.push_back({source.path, static_cast<int>(line), name});
  }
  return found;
}

std::vector<Offence> pictures(const Source& source) {
  std::vector<Offence> found;
  const std::string file = source.path.substr(source.path.rfind('/') + 1);
  if (file.find("picture") != std::string::npos) found.push_back({source.path, 1, file});
  if (source.text.find("icture") == std::string::npos) return found;
  // PicturesLocation is Qt's.
  const auto inCode = matchesOf(source, R"(\b(?!PicturesLocation\b)(?=\w)\w*[Pp]icture)");
  found.insert(found.end(), inCode.begin(), inCode.end());
  return found;
}

TEST(FieldWords, ATypeIsNamedByANoun) {
  EXPECT_EQ(brokenBy(participles, {}, "name the thing: RatingRecord, not KeptRating; a term of the field goes into the list here."), "");
}

TEST(FieldWords, EveryTermOfTheFieldIsUsed) {
  std::set<std::string> used;
  for (const Source& source : sources())
    for (const auto& each : participlesIn(codeOf(source))) used.insert(each.first);
  for (const auto& [name, reason] : participlesOfTheField()) EXPECT_TRUE(used.contains(name)) << name << ": " << reason;
}

TEST(FieldWords, WhatIsSeenIsAnImage) {
  EXPECT_EQ(brokenBy(pictures, {}, "say image; what a camera sends is a frame, what is drawn is a drawing."), "");
}

/// Texts of JSON below a folder in which a picture is spoken of.
std::vector<std::string> filesWithPictures(const std::filesystem::path& root) {
  static const std::regex picture(R"(\b[Pp]ictures?\b)");
  std::vector<std::string> found;
  for (const auto& each : std::filesystem::recursive_directory_iterator(root)) {
    // A recipe is known by its bytes: another word in a remark would have its volume made anew.
    if (each.path().extension() != ".json" || each.path().filename() == "patient.json") continue;
    std::ifstream in(each.path(), std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    if (std::regex_search(text, picture)) found.push_back(each.path().string());
  }
  return found;
}

TEST(FieldWords, WhatTraineesReadIsAnImageAsWell) {
  for (const char* folder : {"cases", "resources/templates"})
    EXPECT_EQ(filesWithPictures(std::filesystem::path(EW_SOURCE_DIR) / folder), std::vector<std::string>())
        << "say image, in the translations' keys too";
}

TEST(FieldWords, AreMissedWhereARuleIsBroken) {
  EXPECT_EQ(participles({"a.h", "// text\nstruct KeptRating {\n"}), (std::vector<Offence>{{"a.h", 2, "KeptRating"}}));
  EXPECT_EQ(participles({"a.h", "enum class CountedRatings {}; using LoadedView = int; class [[nodiscard]] SealedIndex;"}).size(), 3U);
  EXPECT_TRUE(participles({"a.h", "struct SeedPoint; class Kept; struct ReaderLimits; class MappedVolume; // class KeptEdits"}).empty());
  EXPECT_EQ(pictures({"a/b_picture.h", "int x;"}).size(), 1U);
  EXPECT_EQ(pictures({"a.cpp", "int pictureCount;\nQImage lastPicture_;"}).size(), 2U);
  EXPECT_TRUE(pictures({"a.cpp", "f(\"picture\");  // a picture\nQStandardPaths::PicturesLocation;"}).empty());
}

}  // namespace
}  // namespace ew::rules::field_words_test
