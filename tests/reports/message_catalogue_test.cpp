#include "ew/reports/message_catalogue.h"

#include <gtest/gtest.h>

#include "ew/core/figures.h"
#include "library/temporary_folder.h"

namespace ew::message_catalogue_test {
namespace {

constexpr const char* kCatalogue = R"(<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context><name>ew::ui::Other</name>
  <message><source>%1 of %2 &amp; more</source><translation>falscher Ort</translation></message></context>
<context><name>ew::Message</name>
  <message><source>%1 of %2 &amp; more</source><translation>von %2 &lt;%1&gt; und mehr</translation></message>
  <message><source>not yet</source><translation type="unfinished">halb</translation></message></context>
</TS>
)";

TEST(MessageCatalogue, SaysMessagesAsTheWindowDoes) {
  const test::TemporaryFolder folder;
  test::writeText(folder / "a.ts", kCatalogue);
  const auto german = MessageCatalogue::read(folder / "a.ts");
  ASSERT_TRUE(german) << german.error();
  const Message message = say<"%1 of %2 & more">(fixedNumeral(1.5, 1), verbatim("a.b %1"));
  EXPECT_EQ(german->words(message), "von a.b %1 <1,5> und mehr");
  EXPECT_EQ(german->words(say<"not yet">()), "not yet");
  EXPECT_EQ(german->words(joined({message, verbatim("2.5")}, "; ")), "von a.b %1 <1,5> und mehr; 2.5");
  EXPECT_EQ(MessageCatalogue().words(message), message.english());
}

TEST(MessageCatalogue, OfTheProgramIsThereAndSaysWhatIsWrongWithAnother) {
  const auto german = MessageCatalogue::ofLanguage("de");
  ASSERT_TRUE(german) << german.error();
  EXPECT_NE(german->words(say<"The case is not saved.">()), "The case is not saved.");
  ASSERT_TRUE(MessageCatalogue::ofLanguage("en"));
  EXPECT_FALSE(MessageCatalogue::ofLanguage("xx"));
  const test::TemporaryFolder folder;
  test::writeText(folder / "b.ts", "<TS><context>");
  const auto broken = MessageCatalogue::read(folder / "b.ts");
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.error().code, ErrorCode::badHeader);
}

}  // namespace
}  // namespace ew::message_catalogue_test
