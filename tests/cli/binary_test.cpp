#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "cli/cli_world.h"

namespace ew::test::binary_test {
namespace {

/// Starts the real program without a display; its streams go to files.
pid_t start(const std::vector<std::string>& args, const std::string& outFile, const std::string& errFile) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  ::unsetenv("DISPLAY");
  ::unsetenv("WAYLAND_DISPLAY");
  ::unsetenv("QT_QPA_PLATFORM");
  if (!std::freopen(outFile.c_str(), "w", stdout) || !std::freopen(errFile.c_str(), "w", stderr)) ::_exit(126);
  std::vector<char*> words{const_cast<char*>(EW_PROGRAM)};
  for (const auto& arg : args) words.push_back(const_cast<char*>(arg.c_str()));
  words.push_back(nullptr);
  ::execv(EW_PROGRAM, words.data());
  ::_exit(127);
}

int statusOf(pid_t child) {
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

Outcome runProgram(const std::vector<std::string>& args, const TemporaryFolder& folder) {
  Outcome outcome;
  outcome.status = statusOf(start(args, folder / "stdout", folder / "stderr"));
  outcome.out = readText(folder / "stdout");
  outcome.err = readText(folder / "stderr");
  std::filesystem::remove(folder / "stdout");
  std::filesystem::remove(folder / "stderr");
  return outcome;
}

TEST(Program, WorksHeadlessWithoutADisplay) {
  const TemporaryFolder folder;
  ASSERT_TRUE(writeSequence(parallelSweep(8, 6, 5), folder / "s.igs.mha"));
  const auto reconstructed = runProgram({"reconstruct", folder / "s.igs.mha", "-o", folder / "v.mha", "--spacing", "1"}, folder);
  ASSERT_EQ(reconstructed.status, 0) << reconstructed.err;
  const auto sliced =
      runProgram({"slice", folder / "v.mha", "--pose", kIdentityPose, "-o", folder / "o.png", "--report", folder / "r.json"}, folder);
  ASSERT_EQ(sliced.status, 0) << sliced.err;
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"o.png", "r.json", "s.igs.mha", "v.mha"}));
  EXPECT_GT(readJson(folder / "r.json")["memory_mib"].get<double>(), 1.0);
}

TEST(Program, TellsTheShellHowItWent) {
  const TemporaryFolder folder;
  EXPECT_EQ(runProgram({"--version"}, folder).status, 0);
  EXPECT_EQ(runProgram({"slice", "none.mha", "--pose", kIdentityPose, "--repeat", "1"}, folder).status, 1);
  EXPECT_EQ(runProgram({"slice", "--nonsense"}, folder).status, 2);
  const auto slip = runProgram({"sliec"}, folder);
  EXPECT_EQ(slip.status, 2);
  EXPECT_NE(slip.err.find("'sliec'"), std::string::npos) << slip.err;
  const auto missing = runProgram({"folder/none.mha"}, folder);
  EXPECT_EQ(missing.status, 1);
  EXPECT_NE(missing.err.find("none.mha"), std::string::npos) << missing.err;
}

TEST(Program, HandsTheBenchesTheSameWordsAndTellsTheShellTheSame) {
  const TemporaryFolder folder;
  for (const std::vector<std::string>& words : {std::vector<std::string>{"bench", "--help"}, {"help", "bench"}}) {
    const auto help = runProgram(words, folder);
    EXPECT_EQ(help.status, 0) << help.err;
    EXPECT_NE(help.out.find("Usage: echoweave bench"), std::string::npos) << help.out;
    EXPECT_NE(help.out.find("slicing"), std::string::npos) << help.out;
  }
  const auto wrong = runProgram({"bench", "slicing", "--nonsense"}, folder);
  EXPECT_EQ(wrong.status, 2);
  EXPECT_EQ(wrong.err, "echoweave: Not expected: '--nonsense'; 'echoweave bench slicing --help' shows how.\n");
  const auto done = runProgram({"bench", "slicing", "--side", "8", "--size", "16", "--poses", "2", "--repetitions", "1", "--no-peers",
                                "--report", folder / "r.json"},
                               folder);
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(readJson(folder / "r.json")["command"], "bench slicing");
}

/// Of commands and of their own: "case list" as {"case", "list"}.
void addSubcommands(const std::string& help, const std::vector<std::string>& of, std::vector<std::vector<std::string>>& found) {
  const auto list = help.find("\nSubcommands:\n");
  if (list == std::string::npos) return;
  std::istringstream lines(help.substr(list + 14));
  for (std::string line; std::getline(lines, line) && line.starts_with("  ");) {
    if (line[2] == ' ' || line.find("(plugin ") != std::string::npos) continue;
    found.push_back(of);
    found.back().push_back(line.substr(2, line.find(' ', 2) - 2));
  }
}

TEST(Program, SaysOfEveryCommandWhatTheCommandItselfSays) {
  const TemporaryFolder folder;
  std::vector<std::vector<std::string>> commands{{}};
  for (std::size_t n = 0; n < commands.size(); ++n) {
    const std::vector<std::string> named = commands[n];
    if (!named.empty() && named.front() == "bench") continue;  // answered by a program of its own
    auto words = named;
    words.push_back("--help");
    const auto said = runProgram(words, folder);
    EXPECT_EQ(said.status, 0) << said.err;
    EXPECT_EQ(said.out, run(words).out);
    addSubcommands(said.out, named, commands);
  }
  EXPECT_GT(commands.size(), 50u);
}

TEST(Program, BeginsWithoutTheLibrariesOfItsCommands) {
  const TemporaryFolder folder;
  const std::string list = folder / "libraries";
  ASSERT_EQ(std::system(("LD_TRACE_LOADED_OBJECTS=1 '" EW_PROGRAM "' > '" + list + "'").c_str()), 0);
  std::istringstream lines(readText(list));
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) ++count;
  EXPECT_GT(count, 3u);
  EXPECT_LT(count, 25u) << readText(list);  // ten, and what the sanitizers bring
}

TEST(Program, AnswersWrongWordsAsTheCommandItselfDoes) {
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> wrong{{"register", "a.mha", "b.mha", "--method", "guess", "-o", "t.txt"},
                                                    {"scan", "a.mha", "--size", "0x0"},
                                                    {"case", "list", "--nonsense"},
                                                    {"records"},
                                                    {"help", "nonsense"}};
  for (const auto& words : wrong) {
    const auto said = runProgram(words, folder), own = run(words);
    EXPECT_EQ(said.status, own.status) << words.front();
    EXPECT_EQ(said.out, own.out) << words.front();
    EXPECT_EQ(said.err, own.err) << words.front();
  }
}

TEST(Program, WithoutADisplayTheWindowIsASentenceAndNoCrash) {
  const TemporaryFolder folder;
  const auto outcome = runProgram({"--screenshot", folder / "s.png"}, folder);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.err.rfind("echoweave: ", 0), 0u) << outcome.err;
  EXPECT_TRUE(folder.names().empty());
}

/// The line of a process in /proc/PID/status, without its name; empty when it is gone.
std::string statusLine(pid_t process, const std::string& name) {
  std::ifstream in("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(name + ":")) return line.substr(name.size() + 1);
  return {};
}

/// Whether a process listens to a signal by now.
bool catches(pid_t process, int signal) {
  const std::string mask = statusLine(process, "SigCgt");
  return !mask.empty() && (std::stoull(mask, nullptr, 16) >> (signal - 1) & 1u) != 0;
}

/// Processor time that a process has used, in the clock's ticks.
long ticksOf(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/stat");
  std::string text;
  std::getline(in, text);
  std::istringstream fields(text.substr(std::min(text.size(), text.rfind(')') + 1)));
  std::string skipped;
  for (int n = 0; n < 11; ++n) fields >> skipped;  // of the fields behind the name the twelfth and the next are times
  long user = 0, system = 0;
  fields >> user >> system;
  return user + system;
}

TEST(Program, AnInterruptInTheMiddleOfTheWorkEndsItAndLeavesNothing) {
  const TemporaryFolder folder;
  auto sweep = parallelSweep(400, 400, 40);
  ASSERT_TRUE(writeSequence(sweep, folder / "s.igs.mha"));
  const pid_t child = start({"reconstruct", folder / "s.igs.mha", "-o", folder / "v.mha", "--coverage", folder / "c.mha", "--spacing",
                             "0.25", "--threads", "1", "--fill-reach", "12"},
                            folder / "stdout", folder / "stderr");
  const auto lives = [child] {
    const std::string state = statusLine(child, "State");
    return !state.empty() && state.find('Z') == std::string::npos;
  };
  // Not before it listens, and in the middle of its work: after a fifth of a second of the processor.
  const auto waitUntil = [&](const auto& ready) {
    while (!ready() && lives()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  waitUntil([&] { return catches(child, SIGINT); });
  const long began = ticksOf(child);
  waitUntil([&] { return ticksOf(child) >= began + 20; });
  ASSERT_EQ(::kill(child, SIGINT), 0);
  EXPECT_EQ(statusOf(child), 1) << readText(folder / "stderr");
  EXPECT_NE(readText(folder / "stderr").find("Stopped as asked"), std::string::npos) << readText(folder / "stderr");
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"s.igs.mha", "stderr", "stdout"}));
}

/// A terminal of which this process has the far end.
struct FarEnd {
  FarEnd() : far(::posix_openpt(O_RDWR | O_NOCTTY)) {
    if (far < 0 || ::grantpt(far) != 0 || ::unlockpt(far) != 0) return;
    near = ::open(::ptsname(far), O_RDWR | O_NOCTTY);  // held open, so that its settings outlive the program
  }
  ~FarEnd() {
    ::close(near);
    ::close(far);
  }
  [[nodiscard]] bool shows() const {
    termios now{};
    ::tcgetattr(near, &now);
    return (now.c_lflag & ECHO) != 0;
  }
  int far = -1, near = -1;
};

TEST(Program, AnInterruptAtThePassphraseEndsItAndTheTerminalShowsWhatIsTypedAgain) {
  for (const char* key : {"\x03", "\x1c"}) {  // Ctrl-C and Ctrl-backslash
    const TemporaryFolder folder;
    const FarEnd terminal;
    ASSERT_GE(terminal.near, 0);
    ASSERT_TRUE(terminal.shows());
    const pid_t child = ::fork();
    if (child == 0) {
      ::setsid();
      ::ioctl(terminal.near, TIOCSCTTY, 0);
      for (int stream = 0; stream < 3; ++stream) ::dup2(terminal.near, stream);
      rlimit none{0, 0};
      ::setrlimit(RLIMIT_CORE, &none);
      ::setenv("ECHOWEAVE_LIBRARY", (folder / "library").c_str(), 1);
      ::execl(EW_PROGRAM, EW_PROGRAM, "access", "lock", static_cast<char*>(nullptr));
      ::_exit(127);
    }
    while (terminal.shows() && ::waitpid(child, nullptr, WNOHANG) == 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    ASSERT_EQ(::write(terminal.far, key, 1), 1);
    const int status = statusOf(child);
    EXPECT_EQ(status, *key == '\x03' ? 1 : -SIGQUIT);
    EXPECT_TRUE(terminal.shows());
    std::string said(4096, ' ');
    said.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::read(terminal.far, said.data(), said.size()))));
    EXPECT_NE(said.find("passphrase"), std::string::npos) << said;
    EXPECT_EQ(said.find("Stopped as asked") != std::string::npos, *key == '\x03') << said;
  }
}

}  // namespace
}  // namespace ew::test::binary_test
