#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "library/temporary_folder.h"
#include "records/record_server.h"
#include "records/record_world.h"

namespace ew::test::records_kill_test {
namespace {

namespace fs = std::filesystem;

constexpr int kStatements = 12;

void sendAll(const fs::path& folder, const std::string& endpoint) {
  auto outbox = StatementOutbox::open(folder);
  if (!outbox) return;
  RecordStore store;
  store.endpoint = endpoint;
  SendStatementsOptions options;
  options.mostTogether = 3;
  options.mostRounds = 1;
  (void)sendStatements(*outbox, store, options);
}

/// A program of its own that sends as soon as it is told where to: it is started before the server's thread.
class SendingProgram {
 public:
  explicit SendingProgram(const fs::path& folder) {
    int pipe[2] = {-1, -1};
    if (::pipe(pipe) != 0) std::abort();
    child_ = ::fork();
    if (child_ == 0) {
      ::close(pipe[1]);
      char endpoint[128] = "";
      if (::read(pipe[0], endpoint, sizeof endpoint - 1) > 0) sendAll(folder, endpoint);
      ::_exit(0);
    }
    ::close(pipe[0]);
    tell_ = pipe[1];
  }
  ~SendingProgram() { ::close(tell_); }
  SendingProgram(const SendingProgram&) = delete;
  SendingProgram& operator=(const SendingProgram&) = delete;
  void start(const std::string& endpoint) const {
    EXPECT_EQ(::write(tell_, endpoint.data(), endpoint.size()), static_cast<ssize_t>(endpoint.size()));
  }
  void kill() const { ::kill(child_, SIGKILL); }
  [[nodiscard]] bool wasKilled() const {
    int status = 0;
    EXPECT_EQ(::waitpid(child_, &status, 0), child_);
    return WIFSIGNALED(status);
  }

 private:
  pid_t child_ = -1;
  int tell_ = -1;
};

void prepare(const fs::path& folder) {
  auto outbox = StatementOutbox::open(folder);
  ASSERT_TRUE(outbox);
  fill(*outbox, kStatements);
}

void expectEachOnce(const RecordServer& server) {
  const auto arrivals = server.arrivals();
  ASSERT_EQ(arrivals.size(), static_cast<std::size_t>(kStatements));
  for (const auto& [id, count] : arrivals) EXPECT_EQ(count, 1) << id;
}

TEST(RecordsKilled, BetweenTheServersTakingAndOurNoteNothingArrivesTwice) {
  const TemporaryFolder folder;
  for (int at = 1; at <= kStatements / 3; ++at) {
    const fs::path outbox = folder / std::to_string(at);
    prepare(outbox);
    const SendingProgram program(outbox);
    RecordServer server;
    server.taken = [&, n = 0]() mutable {
      if (++n == at) program.kill();
    };
    program.start(server.endpoint());
    EXPECT_TRUE(program.wasKilled());
    server.goAway();
    server.taken = nullptr;
    server.comeBack();
    sendAll(outbox, server.endpoint());
    expectEachOnce(server);
  }
}

/// How long sending takes on this machine: kills are spread over that.
std::chrono::microseconds usualTime(const fs::path& folder) {
  prepare(folder);
  const SendingProgram program(folder);
  const RecordServer server;
  const auto begun = std::chrono::steady_clock::now();
  program.start(server.endpoint());
  EXPECT_FALSE(program.wasKilled());
  return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begun);
}

TEST(RecordsKilled, AtAnyMomentNothingIsLostAndNothingArrivesTwice) {
  const TemporaryFolder folder;
  const auto usual = usualTime(folder / "usual");
  std::mt19937 dice(17);
  int killed = 0;
  for (int n = 0; n < 40; ++n) {
    const fs::path outbox = folder / std::to_string(n);
    prepare(outbox);
    const SendingProgram program(outbox);
    RecordServer server;
    program.start(server.endpoint());
    std::this_thread::sleep_for(usual * static_cast<int>(dice() % 1200) / 1000);
    program.kill();
    killed += program.wasKilled() ? 1 : 0;
    sendAll(outbox, server.endpoint());
    expectEachOnce(server);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_GT(killed, 4) << "too few were killed in the middle to show anything";
}

TEST(RecordsKilled, WhileAddingAStatementIsThereWholeOrNotAtAll) {
  const TemporaryFolder folder;
  std::mt19937 dice(18);
  for (int n = 0; n < 30; ++n) {
    const pid_t child = ::fork();
    if (child == 0) {
      auto outbox = StatementOutbox::open(folder / "o");
      for (int k = 0; outbox && k < 1000; ++k) (void)outbox->add(statementNumbered(k));
      ::_exit(0);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(dice() % 30'000));
    ::kill(child, SIGKILL);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    const auto outbox = StatementOutbox::open(folder / "o");
    ASSERT_TRUE(outbox) << outbox.error();
    for (const OutboxEntry& each : outbox->entries()) EXPECT_TRUE(nlohmann::json::accept(*outbox->textOf(each.id))) << each.id;
  }
}

}  // namespace
}  // namespace ew::test::records_kill_test
