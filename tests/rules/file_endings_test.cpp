#include <gtest/gtest.h>

#include <algorithm>

#include "rules/source_tree.h"

// Dialogs take "sheet.CSV" for a .csv file; whoever writes or reads it has to take it for one as well.
namespace ew::rules::file_endings_test {
namespace {

std::vector<Offence> comparedLetterByLetter(const Source& source) {
  auto found = matchesOf(source, R"(extension\(\)\s*(==|!=))");
  for (const Offence& offence : matchesOf(source, R"(\b(ends_with|endsWith)\()")) {
    const bool isEnding = offence.what.find("ends_with(\".") != std::string::npos ||
                          offence.what.find("endsWith(QStringLiteral(\".") != std::string::npos ||
                          offence.what.find("endsWith(QLatin1String(\".") != std::string::npos;
    if (isEnding && offence.what.find("Qt::CaseInsensitive") == std::string::npos) found.push_back(offence);
  }
  return found;
}

TEST(FileEndings, AreComparedWhateverTheSizeOfTheirLetters) {
  const std::string own = "Names that the program gives itself.";
  const std::string lowered = "The name is in small letters by then.";
  const std::vector<Exception> exceptions = {
      {"workstation/annotation/src/body_mark_json.cpp", own},

      {"workstation/assessment/src/attempts/series_files.cpp", own},
      {"workstation/assessment/src/rating/rating_record.cpp", own},
      {"workstation/library/src/index/index.cpp", own},
      {"workstation/library/src/making/old_results.cpp", own},
      {"workstation/library/src/making/file_import.cpp", lowered},
      {"workstation/library/src/files/content_name.cpp", lowered},
      {"workstation/export/src/outbox.cpp", own},
      {"workstation/io/src/files/outbox.cpp", own},
      {"workstation/io/src/sweeps/sequence_read.cpp", lowered},
      {"workstation/io/src/files/image_header.cpp", lowered},
      {"workstation/reports/src/report_numbers.cpp", "A number, no file."},
      {"plugins/stitching/panel/stitch_runs.cpp", own},
      {"workstation/assessment/src/attempts/review_comment.cpp", own},
      {"workstation/io/src/sweeps/sequence_write.cpp", lowered},
      {"workstation/library/src/case/body_landmarks.cpp", own},
      {"workstation/library/src/access/sealed_answers.cpp", own},
      {"workstation/records/src/statement_outbox.cpp", own},
      {"workstation/tracking/src/calibration_file.cpp", own},
      {"workstation/ui/src/images/image_store.cpp", own},
  };
  EXPECT_EQ(brokenBy(comparedLetterByLetter, exceptions, "hasEnding() of ew/core/ending.h."), "");
}

TEST(FileEndings, AComparisonLetterByLetterIsFound) {
  EXPECT_EQ(comparedLetterByLetter({"a.cpp", "if (file.extension() == \".csv\") return csv();"}).size(), 1u);
  EXPECT_EQ(comparedLetterByLetter({"a.cpp", "if (!file.endsWith(QStringLiteral(\".dcm\"))) return;"}).size(), 1u);
  EXPECT_EQ(comparedLetterByLetter({"a.cpp", "if (name.ends_with(\".mhd\")) return;"}).size(), 1u);
  EXPECT_TRUE(comparedLetterByLetter({"a.cpp", "if (hasEnding(file, \".csv\")) return csv();"}).empty());
  EXPECT_TRUE(comparedLetterByLetter({"a.cpp", "if (file.endsWith(QLatin1String(\".nii\"), Qt::CaseInsensitive)) return;"}).empty());
  EXPECT_TRUE(comparedLetterByLetter({"a.cpp", "if (sentence.ends_with(\"!\")) return;"}).empty());
}

}  // namespace
}  // namespace ew::rules::file_endings_test
