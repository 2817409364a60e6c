#include "ew/core/message.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "ew/core/message_json.h"
#include "ew/core/result.h"

namespace ew {
namespace {

TEST(Message, PutsArgumentsToTheirPlacesWhateverTheirOrder) {
  EXPECT_EQ(say<"%2 holds %1 of %2.">(7, std::string("a.mha")).english(), "a.mha holds 7 of a.mha.");
  EXPECT_EQ(say<"100 % of it.">().english(), "100 % of it.");
}

TEST(Message, DoesNotLookIntoWhatWasPutIn) { EXPECT_EQ(say<"%1 and %2">(std::string("%2"), std::string("%1")).english(), "%2 and %1"); }

TEST(Message, HoldsMessagesAsArguments) {
  const Message inner = say<"line %1">(3);
  const Message outer = say<"It breaks at %1.">(inner);
  EXPECT_EQ(outer.english(), "It breaks at line 3.");
  ASSERT_EQ(outer.arguments().size(), 1u);
  EXPECT_STREQ(outer.arguments()[0].text(), "line %1");
  EXPECT_EQ(joined({outer, {}, say<"Mend it.">()}).english(), "It breaks at line 3. Mend it.");
}

TEST(Message, IsEqualWhenItSaysTheSameOfTheSame) {
  EXPECT_EQ(say<"%1 is there.">(1), say<"%1 is there.">(1));
  EXPECT_NE(say<"%1 is there.">(1), say<"%1 is there.">(2));
  EXPECT_NE(say<"It is there.">(), verbatim("It is there."));
  EXPECT_TRUE(Message().empty());
  EXPECT_FALSE(verbatim("a").empty());
  EXPECT_NE(numeral("0.5"), verbatim("0.5"));
  EXPECT_EQ(numeral("0.5").english(), "0.5");
}

TEST(Message, IsListedForTranslators) {
  const Message known = say<"A text that only this test has.">();
  int found = 0;
  for (const MessageText* said = firstMessageText(); said != nullptr; said = said->next) found += said->text == known.text();
  EXPECT_EQ(found, 1);
}

TEST(Message, IsKeptInAFileWithItsArguments) {
  const std::vector<Message> notes = {say<"It breaks at %1 (%2).">(say<"line %1">(3), std::string("%1")), verbatim("as it is"),
                                      joined({say<"line %1">(1), say<"line %1">(2)}, ", "), say<"It is %1 mm wide.">(numeral("0.5")),
                                      Message()};
  const nlohmann::json kept = notes;
  EXPECT_EQ(nlohmann::json::parse(kept.dump()).get<std::vector<Message>>(), notes);
  EXPECT_EQ(nlohmann::json::parse(R"({"text": "No program has this %1.", "with": ["text"]})").get<Message>(),
            verbatim("No program has this text."));
  EXPECT_EQ(nlohmann::json::parse(R"([7, {"with": 3}, {"number": 3}])").get<std::vector<Message>>(), std::vector<Message>(3));
}

TEST(Message, OfAnErrorIsItsSentence) {
  const Result<void> failed = failure(ErrorCode::notFound, say<"There is no %1.">(std::string("b")));
  EXPECT_EQ(failed.error().sentence(), "There is no b.");
}

}  // namespace
}  // namespace ew
