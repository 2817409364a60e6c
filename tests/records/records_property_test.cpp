#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>

#include "library/temporary_folder.h"
#include "records/record_server.h"
#include "records/record_world.h"

namespace ew::test::records_property_test {
namespace {

constexpr Fault kFaults[] = {Fault::closeBeforeTaking, Fault::closeAfterTaking, Fault::halfAnswer, Fault::answerTwice, Fault::busy429,
                             Fault::busy503,           Fault::failBefore,       Fault::failAfter,  Fault::otherPage,   Fault::goAway};

int sequences() {
  const char* asked = std::getenv("EW_RECORDS_RUNS");
  return asked != nullptr ? std::max(1, std::atoi(asked)) : 240;
}

/// Some questions of a call go wrong, at random; between calls statements are added, also ones that are there already, and the program ends
/// and begins again.
struct Sequence {
  explicit Sequence(unsigned seed) : dice(seed) {}
  int below(int limit) { return static_cast<int>(dice() % static_cast<unsigned>(limit)); }

  std::mt19937 dice;
  TemporaryFolder folder;
  RecordServer server;
  RecordStore store;
  SendStatementsOptions options;
  int faults = 0;
};

void runSequence(unsigned seed, std::map<Fault, int>& met) {
  Sequence world(seed);
  world.server.knowsIds = world.below(4) == 0;
  world.server.refusesWhatIsThere = world.below(4) == 0;
  world.server.namesWhatItTook = world.below(5) != 0;
  world.server.retryAfter = world.below(3) == 0 ? "" : "3";
  const int count = 3 + world.below(10);
  const int badOne = world.below(3) == 0 ? world.below(count) : -1;
  if (badOne >= 0) world.server.bad = {idNumbered(badOne)};
  const int chance_percent = 20 + world.below(60);
  std::mt19937 faultDice(seed ^ 0x5bd1e995u);
  world.server.fault = [&](const ServerQuestion&) {
    if (world.faults >= 40 || static_cast<int>(faultDice() % 100) >= chance_percent) return Fault::none;
    ++world.faults;
    const Fault fault = kFaults[faultDice() % std::size(kFaults)];
    ++met[fault];
    return fault;
  };
  world.store.endpoint = world.server.endpoint();
  world.options.mostTogether = static_cast<std::size_t>(1 + world.below(6));
  world.options.mostRounds = 1 + world.below(4);
  world.options.wait = [&](double) {
    if (world.below(2) == 0) world.server.comeBack();
    return true;
  };
  int added = 0;
  for (int call = 0; call < 400; ++call) {
    auto outbox = StatementOutbox::open(world.folder / "o");
    ASSERT_TRUE(outbox) << outbox.error();
    for (int n = world.below(4); n > 0 && added < count; --n) ASSERT_TRUE(outbox->add(statementNumbered(added++)));
    if (added > 0) (void)outbox->add(statementNumbered(world.below(added)));
    ASSERT_TRUE(sendStatements(*outbox, world.store, world.options));
    world.server.comeBack();
    const bool isDone = outbox->count(OutboxStatus::waiting) + outbox->count(OutboxStatus::doubtful) == 0;
    if (added == count && isDone) break;
  }
  const auto arrivals = world.server.arrivals();
  for (int n = 0; n < count; ++n) {
    const auto at = arrivals.find(idNumbered(n));
    EXPECT_EQ(at == arrivals.end() ? 0 : at->second, n == badOne ? 0 : 1) << "statement " << n << " of sequence " << seed;
  }
}

TEST(RecordsProperty, EveryStatementArrivesExactlyOnceWhateverGoesWrong) {
  std::map<Fault, int> met;
  for (int n = 0; n < sequences(); ++n) {
    runSequence(static_cast<unsigned>(n) + 1, met);
    if (testing::Test::HasFailure()) return;
  }
  if (sequences() < 100) return;
  for (const Fault fault : kFaults) EXPECT_GT(met[fault], 20) << "fault " << static_cast<int>(fault) << " was hardly met";
}

}  // namespace
}  // namespace ew::test::records_property_test
