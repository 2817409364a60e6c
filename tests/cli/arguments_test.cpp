#include "run/arguments.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <clocale>
#include <locale>

#include "cli/cli_world.h"
#include "ew/cli/window_arguments.h"
#include "ew/core/numbers.h"

namespace ew::arguments_test {
namespace {

using Words = std::vector<std::string>;

TEST(JoinNumberLists, PutsSixteenWordsOfAPoseIntoOneValue) {
  Words words{"slice", "v.mha", "--pose"};
  for (int n = 0; n < 16; ++n) words.push_back(n % 5 == 0 ? "-1.5" : "0");
  words.push_back("-o");
  words.push_back("out.png");
  const Words joined = cli::joinNumberLists(words);
  EXPECT_EQ(joined, (Words{"slice", "v.mha", "--pose=-1.5 0 0 0 0 -1.5 0 0 0 0 -1.5 0 0 0 0 -1.5", "-o", "out.png"}));
}

TEST(JoinNumberLists, KeepsAFileNameAfterPoseAndTheWordsBehindIt) {
  const Words words{"slice", "--pose", "poses.txt", "7.mha", "-o", "o.png"};
  EXPECT_EQ(cli::joinNumberLists(words), words);
}

TEST(JoinNumberLists, AttachesAValueThatStartsWithAMinusSign) {
  EXPECT_EQ(cli::joinNumberLists(Words{"--spacing", "-.5", "x"}), (Words{"--spacing=-.5", "x"}));
  EXPECT_EQ(cli::joinNumberLists(Words{"--pose", "-1 0 0 0"}), (Words{"--pose=-1 0 0 0"}));
}

TEST(JoinNumberLists, NeverLosesOrReordersAWord) {
  rc::check("the characters stay, in order", [] {
    const auto words =
        *rc::gen::container<Words>(rc::gen::element<std::string>("slice", "--pose", "-1", "0.5", "a.mha", "--clip", "-o", "3"));
    std::string before, after;
    for (const auto& word : words) before += word;
    for (const auto& word : cli::joinNumberLists(words))
      for (const char c : word)
        if (c != ' ' && c != '=') after += c;
    RC_ASSERT(before == after);
  });
}

TEST(Numbered, NamesOneImageAsGivenAndSeveralByNumber) {
  EXPECT_EQ(cli::numbered("a/out.png", 0, 1), "a/out.png");
  EXPECT_EQ(cli::numbered("a/out.png", 0, 2), "a/out_0000.png");
  EXPECT_EQ(cli::numbered("a/out.png", 12345, 20000), "a/out_12345.png");
}

TEST(PosesOf, SaysHowManyNumbersAreThereWhenTheyAreNotSixteen) {
  const auto poses = cli::posesOf("1 2 3");
  ASSERT_FALSE(poses);
  EXPECT_EQ(poses.error().code, ErrorCode::badUsage);
  EXPECT_NE(poses.error().sentence().find("3 numbers"), std::string::npos) << poses.error();
}

TEST(WindowArguments, TakeEveryOptionOfTheWindow) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "v.mha", "x");
  const Words words{folder / "v.mha", "--screenshot", folder / "s.png", "--theme=light", "--workspace", "author", "--size", "1280x720"};
  const auto wish = cli::windowArguments(words);
  ASSERT_TRUE(wish) << wish.error();
  EXPECT_EQ(wish->open, folder / "v.mha");
  EXPECT_EQ(wish->screenshot, folder / "s.png");
  EXPECT_EQ(wish->theme, "light");
  EXPECT_EQ(cli::windowArguments(Words{folder / "v.mha", "--lesson", "first"})->lesson, "first");
  EXPECT_FALSE(cli::windowArguments(Words{"--lesson", "first"})) << "of which case";
  EXPECT_EQ(cli::windowArguments(Words{"--launched-by", "lms.example"})->launchedBy, "lms.example");
  EXPECT_EQ(wish->workspace, "author");
  EXPECT_EQ(wish->size_px, glm::ivec2(1280, 720));
  EXPECT_FALSE(wish->startPage);
  EXPECT_EQ(folder.names(), Words{"v.mha"}) << "looking whether the screenshot can be written leaves nothing behind";
}

TEST(WindowArguments, RefuseWhatIsNotThereBeforeAWindowOpens) {
  const auto missing = cli::windowArguments(Words{"no/such/volume.mha"});
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().code, ErrorCode::notFound);
  const auto unwritable = cli::windowArguments(Words{"--screenshot", "/no/such/folder/s.png"});
  ASSERT_FALSE(unwritable);
  EXPECT_EQ(unwritable.error().code, ErrorCode::notWritable);
  const auto unknown = cli::windowArguments(Words{"--theme", "pink"});
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::badUsage);
}

class CommaDecimals final : public std::numpunct<char> {
 protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// A German user's locale, for streams and for the C library.
class GermanLocale {
 public:
  GermanLocale()
      : streams_(std::locale::global(std::locale(std::locale::classic(), new CommaDecimals))), c_(std::setlocale(LC_ALL, nullptr)) {
    for (const char* name : {"de_DE.UTF-8", "de_DE.utf8", "de_DE"})
      if (std::setlocale(LC_NUMERIC, name)) break;
  }
  ~GermanLocale() {
    std::locale::global(streams_);
    std::setlocale(LC_ALL, c_.c_str());
  }

 private:
  std::locale streams_;
  std::string c_;
};

TEST(Locale, ACommaAsDecimalSignChangesNothing) {
  const GermanLocale german;
  EXPECT_EQ(cli::rounded(1234.56, 1), "1234.6");
  const test::TemporaryFolder folder;
  ASSERT_TRUE(writeVolume(test::rampVolume({1200, 4, 4}), folder / "v.mha"));
  const auto outcome = test::run({"slice", folder / "v.mha", "--pose", test::kIdentityPose, "--size", "8x4", "--pixel", "0.5", "-o",
                                  folder / "o.mha", "--report", folder / "r.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("0.5 mm"), std::string::npos) << outcome.out;
  const auto report = test::readJson(folder / "r.json");
  EXPECT_EQ(report.value("/options/pixel_mm"_json_pointer, 0.0), 0.5);
  EXPECT_NE(test::readText(folder / "o.mha").find("0.5"), std::string::npos) << "the image's spacing";
  EXPECT_EQ(test::run({"slice", folder / "v.mha", "--pose", test::kIdentityPose, "--pixel", "0,5", "-o", folder / "p.png"}).status, 2);
}

}  // namespace
}  // namespace ew::arguments_test
