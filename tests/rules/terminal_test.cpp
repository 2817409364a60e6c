#include <gtest/gtest.h>

#include "rules/source_tree.h"

// What a command writes goes through one stream (workstation/cli/src/run/printable_stream.h), which lets no control character of a foreign
// title or answer reach the terminal.
namespace ew::rules::terminal_test {
namespace {

std::vector<Offence> pastTheStream(const Source& source) {
  if (!source.path.starts_with("workstation/cli/") && source.text.find("std::c") == std::string::npos) return {};
  return matchesOf(source, R"(\bstd::(cout|cerr|clog)\b|\b(std::)?f?printf\(|\b(std::)?f?puts\(|\bsurroundings_?\.(out|err)\b)");
}

TEST(Terminal, IsWrittenToThroughOneStreamAlone) {
  const std::vector<Exception> exceptions = {
      {"workstation/cli/src/run/main.cpp", "Its own sentences are printable()."},
      {"workstation/cli/src/run/command_main.cpp", "Two sentences of ours."},
      {"workstation/cli/src/run/programs.cpp", "Its own sentences are printableLine()."},
      {"workstation/cli/src/run/program.cpp", "Makes the streams of our programs."},
      {"workstation/cli/src/run/command.h", "Puts the stream before the terminal."},
      {"workstation/cli/src/run/run_command.cpp", "Puts the stream before the terminal."},
      {"workstation/cli/src/run/command_line.cpp", "Puts the stream before the terminal."},
      {"workstation/cli/src/run/console_progress.cpp", "The bar moves the cursor itself; its words are printableLine()."},
      {"workstation/ui/src/window/run.cpp", "One sentence of the window, printableLine()."},
  };
  EXPECT_EQ(brokenBy(pastTheStream, exceptions, "run.out(), run.say() or run.remark() of workstation/cli/src/command.h."), "");
}

TEST(Terminal, AWayPastTheStreamIsFound) {
  const std::string file = "workstation/cli/src/made.cpp";
  EXPECT_EQ(pastTheStream({file, "std::cout << opened.title;"}).size(), 1u);
  EXPECT_EQ(pastTheStream({file, "surroundings_.out << opened.title;"}).size(), 1u);
  EXPECT_EQ(pastTheStream({file, "std::fprintf(stderr, \"%s\", title);"}).size(), 1u);
  EXPECT_TRUE(pastTheStream({file, "std::snprintf(text, sizeof text, \"%d\", n);"}).empty());
  EXPECT_TRUE(pastTheStream({file, "run.out() << opened.title;"}).empty());
}

}  // namespace
}  // namespace ew::rules::terminal_test
