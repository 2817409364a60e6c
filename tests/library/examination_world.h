#pragma once

#include <archive.h>
#include <archive_entry.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "ew/library/sealed_answers.h"
#include "library/bundle_world.h"
#include "library/small_case.h"
#include "library/temporary_folder.h"

namespace ew::test {

/// So that a test takes milliseconds; the figures of the product are PassphraseCost's own.
inline constexpr PassphraseCost kCheapCost{.passes = 1, .memory_bytes = 64 << 10};

/// Words of the answer key of makeAnsweredCase, each of which stands in one field that trainees may not read.
inline const std::vector<std::string> kAnswerWords = {
    "SECRETTITLE",  "SECRETFINDING",     "SECRETDIAGNOSIS", "SECRETDIFFERENTIAL", "SECRETTAG",      "SECRETPRESET",
    "SECRETTARGET", "SECRETMEASUREMENT", "SECRETAIM",       "SECRETLESSONTAG",    "SECRETSOURCE",   "SECRETHINT",
    "SECRETAFTER",  "SECRETWHY",         "SECRETLOOK",      "SECRETMARK",         "SECRETLATE",     "SECRETTISSUE",
    "secretstep",   "secretlesson",      "secretid",        "secret-scan",        "secret-picture", "SECRETGERMAN",
    "SECRETFUTURE", "SECRETPNGTEXT",     "SECRETPLUGIN",    "SECRETFILE",         "SECRETSETTING"};
/// ... and numbers.
inline const std::vector<std::string> kAnswerNumbers = {"31.4159", "27.1828", "16.1803", "14.1421",
                                                        "17.3205", "22.3606", "26.4575", "0.61803"};

/// The smallest PNG, one grey pixel, with a text in it and one behind its end.
inline std::string pngWithText() {
  const auto bytes = [](std::initializer_list<int> values) {
    std::string text;
    for (const int value : values) text += static_cast<char>(value);
    return text;
  };
  const std::string words = "Comment" + std::string(1, '\0') + "SECRETPNGTEXT";
  return "\x89PNG\r\n\x1a\n" + bytes({0, 0, 0, 13}) + "IHDR" + bytes({0, 0, 0, 1, 0, 0, 0, 1, 8, 0, 0, 0, 0, 0x3a, 0x7e, 0x9b, 0x55}) +
         bytes({0, 0, 0, static_cast<int>(words.size())}) + "tEXt" + words + bytes({1, 2, 3, 4}) + bytes({0, 0, 0, 10}) + "IDAT" +
         bytes({0x78, 0x9c, 0x63, 0x68, 0, 0, 0, 0x82, 0, 0x81, 0x77, 0xcd, 0x72, 0xb6}) + bytes({0, 0, 0, 0}) + "IEND" +
         bytes({0xae, 0x42, 0x60, 0x82}) + "SECRETPNGTEXT";
}

/// A case of one volume whose every field that trainees may not read holds a word or a number of the lists above.
inline nlohmann::json manifestOfAnsweredCase() {
  using nlohmann::json;
  const json pose = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const json expert = {1, 0, 0, 31.4159, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  json steps = {
      {{"id", "secretstep-read"},
       {"task", "read"},
       {"title", "Before you begin"},
       {"text", "Read this."},
       {"picture", "media/secret-picture.png"}},
      {{"id", "secretstep-watch"},
       {"task", "watch"},
       {"title", "The expert SECRETFILE"},
       {"recording", "scans/secret-scan.txt"},
       {"marks", {{{"time_s", 1.5}, {"text", "SECRETMARK"}}}}},
      {{"id", "secretstep-plane"},
       {"task", "plane"},
       {"title", "Find the plane"},
       {"text", "Set it."},
       {"target", "SECRETTARGET plane"},
       {"position_tolerance_mm", 14.1421},
       {"hints", {"SECRETHINT"}},
       {"after", "SECRETAFTER"},
       {"look_for", "SECRETLOOK"},
       {"aids", {{"compass", true}, {"own_path", true}}},
       {"pass_level", 0.61803},
       {"time_s", 120}},
      {{"id", "secretstep-measure"},
       {"task", "measure"},
       {"title", "Measure"},
       {"measurement", "SECRETMEASUREMENT"},
       {"tolerance", 17.3205}},
      {{"id", "secretstep-point"}, {"task", "point"}, {"title", "Point"}, {"target", "SECRETTARGET point"}},
      {{"id", "secretstep-settings"},
       {"task", "settings"},
       {"title", "Set the machine"},
       {"probes", {"SECRETSETTING"}},
       {"bands", {{{"setting", "depth_mm"}, {"lowest", 22.3606}, {"highest", 26.4575}}}}},
      {{"id", "secretstep-answer"},
       {"task", "answer"},
       {"title", "Decide"},
       {"text", "What is it?"},
       {"options", {{{"text", "One thing"}, {"right", true}, {"why", "SECRETWHY"}}, {{"text", "Another thing"}, {"right", false}}}}},
      {{"id", "secretstep-number"},
       {"task", "answer"},
       {"title", "How wide?"},
       {"number", 27.1828},
       {"tolerance", 16.1803},
       {"unit", "mm"}},
      {{"id", "secretstep-free"}, {"task", "free"}, {"title", "Look around"}, {"shortest_s", 5}, {"targets", {"SECRETTARGET plane"}}},
      {{"id", "secretstep-late"}, {"task", "read"}, {"title", "What it was"}, {"text", "SECRETLATE"}}};
  const json lesson = {{"id", "secretlesson"}, {"title", "An examination"},   {"aim", "SECRETAIM"},          {"level", 2},
                       {"minutes", 9},         {"tags", {"SECRETLESSONTAG"}}, {"sources", {"SECRETSOURCE"}}, {"language", "en"},
                       {"steps", steps},       {"future", "SECRETFUTURE"}};
  return {
      {"format", 2},
      {"id", "secretid"},
      {"title", "A SECRETTITLE"},
      {"title_for_trainees", "A joint"},
      {"region", "knee"},
      {"patient", {{"name", "Ada Quill"}, {"sex", "female"}, {"age_years", 41}, {"future", "SECRETFUTURE"}}},
      {"complaint", "It hurts."},
      {"history", "She fell."},
      {"indication", "Fluid?"},
      {"previous_examinations",
       {{{"when", "last year"},
         {"kind", "ultrasound"},
         {"findings", "Nothing then."},
         {"pictures", {"media/secret-picture.png"}},
         {"future", "SECRETFUTURE"}}}},
      {"laboratory", {{{"when", "today"}, {"findings", "CRP 3 mg/l."}}}},
      {"findings", {"SECRETFINDING"}},
      {"diagnosis", "SECRETDIAGNOSIS"},
      {"differential", {"SECRETDIFFERENTIAL"}},
      {"presets", {"SECRETPRESET", "abdomen-convex-3.5"}},
      {"difficulty", 4},
      {"tags", {"SECRETTAG"}},
      {"targets",
       {{{"kind", "plane"}, {"name", "SECRETTARGET plane"}, {"probe_to_world", expert}},
        {{"kind", "point"}, {"name", "SECRETTARGET point"}, {"at_mm", {1, 31.4159, 2}}},
        {{"kind", "structure"}, {"name", "SECRETTARGET structure"}, {"label", 3}}}},
      {"measurements", {{{"name", "SECRETMEASUREMENT"}, {"kind", "distance"}, {"unit", "mm"}, {"value", 27.1828}, {"tolerance", 16.1803}}}},
      {"start_pose", pose},
      {"expert_pose", expert},
      {"scene",
       {{"tissues",
         {{{"label", 3}, {"name", "SECRETTISSUE"}, {"attenuation_db_per_cm_mhz", 2.5}},
          {{"label", 4}, {"name", "SECRETTISSUE two"}, {"attenuation_db_per_cm_mhz", 2.5}}}}}},
      {"volume",
       {{"file", "volumes/v.mha"},
        {"labels", "volumes/l.mha"},
        {"file_to_world", pose},
        {"attribution", "made for a test"},
        {"future", "SECRETFUTURE"}}},
      {"future", "SECRETFUTURE"},
      {"parts", {{"lessons", {{"format", 1}, {"lessons", {lesson}}}}, {"other", {{"text", "SECRETPLUGIN"}}}}}};
}

inline void makeAnsweredCase(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "volumes");
  ASSERT_TRUE(writeVolume(noisyVolume({20, 18, 16}, 5), folder / "volumes/v.mha"));
  Volume labels = noisyVolume({20, 18, 16}, 5);
  for (std::size_t n = 0; n < labels.echo.size(); ++n) labels.echo[n] = static_cast<std::uint8_t>(n % 5);
  ASSERT_TRUE(writeVolume(labels, folder / "volumes/l.mha"));
  writeText(folder / "media/secret-picture.png", pngWithText());
  writeText(folder / "parts/lessons/media/secret-picture.png", pngWithText());
  writeText(folder / "parts/lessons/scans/secret-scan.txt", "SECRETFILE");
  writeText(folder / "notes/SECRETFILE.txt", "SECRETFILE");
  writeText(folder / "words/de.json", nlohmann::json{{"format", 1},
                                                     {"words",
                                                      {{"A joint", "Ein Gelenk"},
                                                       {"What is it?", "Was ist es?"},
                                                       {"SECRETDIAGNOSIS", "SECRETGERMAN"},
                                                       {"SECRETHINT", "SECRETGERMAN"}}}}
                                          .dump());
  writeText(folder / "case.json", manifestOfAnsweredCase().dump(2));
}

/// Every file of a bundle as it is read from the tar.
inline std::map<std::string, std::string> filesInBundle(const std::filesystem::path& bundle) {
  std::map<std::string, std::string> files;
  archive* in = archive_read_new();
  archive_read_support_filter_zstd(in);
  archive_read_support_format_tar(in);
  EXPECT_EQ(archive_read_open_filename(in, bundle.c_str(), 1 << 16), ARCHIVE_OK);
  archive_entry* entry = nullptr;
  while (archive_read_next_header(in, &entry) == ARCHIVE_OK) {
    std::string& content = files[archive_entry_pathname(entry)];
    std::string piece(1 << 16, '\0');
    for (la_ssize_t count = 0; (count = archive_read_data(in, piece.data(), piece.size())) > 0;)
      content.append(piece, 0, static_cast<std::size_t>(count));
  }
  archive_read_free(in);
  return files;
}

/// The same of a folder.
inline std::map<std::string, std::string> filesInFolder(const std::filesystem::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& each : std::filesystem::recursive_directory_iterator(folder))
    if (each.is_regular_file()) files[each.path().lexically_relative(folder).string()] = textOf(each.path());
  return files;
}

/// Whether a text stands in a name or the bytes of any of the files; says where.
inline std::string placeOf(const std::string& secret, const std::map<std::string, std::string>& files) {
  for (const auto& [name, bytes] : files)
    if (name.find(secret) != std::string::npos || bytes.find(secret) != std::string::npos) return name;
  return {};
}

/// An examination of the answered case with the key that opens it.
struct ExaminationWorld {
  const TemporaryFolder folder;
  SecretKey key = *SecretKey::make();
  Examination made;

  ExaminationWorld() {
    makeAnsweredCase(folder / "case");
    auto examination = makeExamination(folder / "case", folder / "examination", {.instructors = {key.publicKey()}});
    EXPECT_TRUE(examination) << examination.error();
    if (examination) made = *examination;
  }
  [[nodiscard]] std::filesystem::path place() const { return folder / "examination"; }
};

}  // namespace ew::test
