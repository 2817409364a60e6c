#include "ew/core/word_table.h"

#include <gtest/gtest.h>

namespace ew {
namespace {

enum class Side { left, right };
constexpr WordTable<Side, 2> kSideWords{{{"left", Side::left}, {"on the right", Side::right}}};

TEST(WordTable, LeadsFromAValueToItsWordAndBack) {
  for (const auto& [word, side] : kSideWords) {
    EXPECT_STREQ(wordIn(kSideWords, side), word);
    EXPECT_EQ(meaningIn(kSideWords, word), side);
  }
  static_assert(std::string_view(wordIn(kSideWords, Side::right)) == "on the right");
}

TEST(WordTable, TellsEnumeratorsFromOtherValues) {
  static_assert(isEnumerator<Side::right>() && isEnumerator<static_cast<Side>(0)>());
  static_assert(!isEnumerator<static_cast<Side>(2)>() && !isEnumerator<static_cast<Side>(-1)>());
}

TEST(WordTable, KnowsNoOtherWords) {
  for (const char* word : {"", "Left", "left ", "on the righ", "unknown"}) EXPECT_FALSE(meaningIn(kSideWords, word)) << word;
}

#ifdef EW_CHECK_CONTRACTS
TEST(WordTable, IsAskedForItsOwnValuesAlone) {
  EXPECT_DEATH(static_cast<void>(wordIn(kSideWords, static_cast<Side>(2))), "contract broken");
}
#endif

}  // namespace
}  // namespace ew
