#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <random>
#include <thread>

#include "stitching/chain_world.h"

namespace ew::stitching {
namespace {

using Clock = std::chrono::steady_clock;
using test::ChainWorld;

/// Runs the chain in a process of its own. @return whether it came to its end before it was killed
bool runAndKillAfter(ChainWorld& world, const std::filesystem::path& into, std::optional<std::chrono::microseconds> life) {
  const pid_t child = ::fork();
  if (child == 0) {
    ChainOptions options;
    options.threads = 2;
    options.keepVolumes = false;
    options.keepBytes = 0;  // everything there is this project's, and none of it may go
    ::_exit(world.run(into, noProgress(), options) ? 0 : 1);
  }
  EXPECT_GT(child, 0);
  const auto end = life ? Clock::now() + *life : Clock::time_point::max();
  for (;;) {
    int status = 0;
    if (::waitpid(child, &status, WNOHANG) == child) {
      EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << "status " << status;
      return true;
    }
    if (Clock::now() >= end) {
      ::kill(child, SIGKILL);
      ::waitpid(child, &status, 0);
      return WIFEXITED(status);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
}

TEST(KilledChain, GoesOnWithoutRedoingWhatWasFinishedAndEndsWithTheSameBytes) {
  ChainWorld world;
  const auto started = Clock::now();
  ASSERT_TRUE(runAndKillAfter(world, world.folder / "whole", std::nullopt));
  const auto whole = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - started);
  const auto expected = ChainWorld::resultIn(world.folder / "whole");
  ASSERT_FALSE(expected.at("volume.mha").empty());

  std::mt19937 random(19);
  std::uniform_int_distribution<long> moment(0, static_cast<long>(whole.count()));
  int kills = 0, resumed = 0, ends = 0, folders = 0;
  while (kills < 50) {
    const auto into = world.folder / ("killed-" + std::to_string(folders++));
    for (bool ended = false; !ended;) {
      const auto before = ChainWorld::entriesIn(into);
      // The last kill of all is followed by a run that is left alone.
      const bool alone = kills >= 50;
      ended = runAndKillAfter(world, into, alone ? std::nullopt : std::optional(std::chrono::microseconds(moment(random))));
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
        ::_exit(state ? 0 : state.error().code == ErrorCode::notWritable && state.error().sentence.ends_with('.') ? 7 : 1);
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
}  // namespace ew::stitching
