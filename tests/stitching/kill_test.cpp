#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <optional>
#include <random>
#include <thread>

#include "stitching/chain_world.h"

namespace ew::stitching::kill_test {
namespace {

using test::ChainWorld;

/// Counts what work says and asks, and writes a byte into a pipe when it has done so for the n-th time: the moment to kill it, by how far
/// it has come and not by a clock.
class Beats final : public Progress {
 public:
  Beats(int pipe, long at) : pipe_(pipe), at_(at) {}
  void report(const Message&, double) override { beat(); }
  [[nodiscard]] bool cancelRequested() const override {
    beat();
    return false;
  }
  [[nodiscard]] long count() const { return count_; }

 private:
  void beat() const {
    if (++count_ != at_) return;
    [[maybe_unused]] const auto told = ::write(pipe_, "!", 1);
  }
  int pipe_;
  long at_;
  mutable std::atomic<long> count_{0};
};

struct Outcome {
  bool ended = false;  ///< it came to its end before it was killed
  long beats = 0;      ///< of a run that was left alone
};

/// Runs the chain in a process of its own. @param beat at which it is killed, and so much later; empty: it is left alone
Outcome runAndKillAt(ChainWorld& world, const std::filesystem::path& into, std::optional<long> beat, std::chrono::microseconds later = {}) {
  int ends[2];
  EXPECT_EQ(::pipe(ends), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    ::close(ends[0]);
    ChainOptions options;
    options.threads = 2;
    options.keepVolumes = false;
    options.keepBytes = 0;  // everything there is this project's, and none of it may go
    Beats beats(ends[1], beat.value_or(-1));
    if (!world.run(into, beats, options)) ::_exit(1);
    const std::string count = std::to_string(beats.count());
    ::_exit(beat || ::write(ends[1], count.data(), count.size()) > 0 ? 0 : 1);
  }
  EXPECT_GT(child, 0);
  ::close(ends[1]);
  std::array<char, 32> told{};
  const auto length = ::read(ends[0], told.data(), told.size() - 1);  // waits for the beat or the end
  if (beat && length > 0) {
    std::this_thread::sleep_for(later);
    ::kill(child, SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ::close(ends[0]);
  const bool ended = WIFEXITED(status);
  if (ended) {
    EXPECT_EQ(WEXITSTATUS(status), 0);
  }
  return {ended, beat ? 0 : std::atol(told.data())};
}

TEST(KilledChain, GoesOnWithoutRedoingWhatWasFinishedAndEndsWithTheSameBytes) {
  ChainWorld world;
  const Outcome whole = runAndKillAt(world, world.folder / "whole", std::nullopt);
  ASSERT_TRUE(whole.ended);
  ASSERT_GT(whole.beats, 100);
  const auto expected = ChainWorld::resultIn(world.folder / "whole");
  ASSERT_FALSE(expected.at("volume.mha").empty());

  std::mt19937 random(19);
  std::uniform_int_distribution<long> moment(1, whole.beats);
  std::uniform_int_distribution<int> later_us(0, 3000);  // so that it also dies where it neither says nor asks anything
  int kills = 0, resumed = 0, ends = 0, folders = 0;
  while (kills < 50) {
    const auto into = world.folder / ("killed-" + std::to_string(folders++));
    for (bool ended = false; !ended;) {
      const auto before = ChainWorld::entriesIn(into);
      // The last kill of all is followed by a run that is left alone.
      const bool alone = kills >= 50;
      ended = runAndKillAt(world, into, alone ? std::nullopt : std::optional(moment(random)), std::chrono::microseconds(later_us(random)))
                  .ended;
      kills += ended ? 0 : 1;
      const auto after = ChainWorld::entriesIn(into);
      for (const auto& [name, time] : before) {
        ASSERT_TRUE(after.contains(name)) << name << " was finished and is gone";
        EXPECT_EQ(after.at(name), time) << name << " was finished and was made again";
        ++resumed;
      }
    }
    ++ends;
    EXPECT_EQ(ChainWorld::resultIn(into), expected) << "after the kills in " << into;
    EXPECT_EQ(ChainWorld::leftoversIn(into), std::vector<std::string>{});
  }
  EXPECT_EQ(kills, 50);
  EXPECT_GT(resumed, 50) << "the kills came so early that nothing was ever finished";
  RecordProperty("ends", ends);
}

TEST(ChainOnAFullDisk, SaysSoAndGoesOnWhenThereIsRoom) {
  for (const std::uint64_t streamAbove : {std::uint64_t{1} << 28, std::uint64_t{0}}) {
    ChainWorld world;
    const auto into = world.folder / "out";
    for (const rlim_t room : {rlim_t{0}, rlim_t{3000}, rlim_t{12000}}) {
      const pid_t child = ::fork();
      if (child == 0) {
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{room, room};
        ::setrlimit(RLIMIT_FSIZE, &limit);
        ChainOptions options;
        options.threads = 1;
        options.streamAbove_voxels = streamAbove;
        const auto state = world.run(into, noProgress(), options);
        ::_exit(state ? 0 : state.error().code == ErrorCode::notWritable && state.error().sentence().ends_with('.') ? 7 : 1);
      }
      int status = 0;
      ASSERT_EQ(::waitpid(child, &status, 0), child);
      EXPECT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
      EXPECT_EQ(WEXITSTATUS(status), 7) << "with room for " << room << " bytes";
      EXPECT_FALSE(std::filesystem::exists(into / "volume.mha"));
    }
    ChainOptions options;
    options.streamAbove_voxels = streamAbove;
    const auto state = world.run(into, noProgress(), options);
    ASSERT_TRUE(state) << state.error();
    EXPECT_EQ(ChainWorld::leftoversIn(into), std::vector<std::string>{});
    EXPECT_TRUE(readVolume(into / "volume.mha"));
  }
}

}  // namespace
}  // namespace ew::stitching::kill_test
