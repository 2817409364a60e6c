#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "ew/cli/run_command.h"
#include "ew/cli/window_arguments.h"
#include "ew/core/printable.h"
#include "run/printable_stream.h"

namespace {

std::atomic<bool> stopAsked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

extern "C" void askToStop(int) { stopAsked.store(true); }

int runHeadless(const std::vector<std::string>& args) {
  struct sigaction action {};
  action.sa_handler = askToStop;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);  // a second Ctrl-C ends the program the hard way
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return ew::cli::runCommand(args, {std::cout, std::cerr, isatty(STDERR_FILENO) == 1, &stopAsked});
}

bool hasDisplay() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    if (const char* value = std::getenv(name); value && *value) return true;
  return false;
}

/// Hands over to the program of the window, which lies beside this one and reads the same words. Returns only when that fails.
int openWindow(char** argv) {
  std::error_code error;
  const std::filesystem::path window = std::filesystem::read_symlink("/proc/self/exe", error).parent_path() / "echoweave-window";
  if (error || !std::filesystem::exists(window, error)) {
    std::cerr << "echoweave: This build has no window; configure it with the part 'ui', or use a command ('echoweave --help').\n";
    return ew::cli::kFailed;
  }
  if (!hasDisplay()) {
    std::cerr << "echoweave: There is no screen here to open the window on; set DISPLAY, start it with './run --screenshot OUT.png' for a "
                 "picture of the window, or use a command ('echoweave --help').\n";
    return ew::cli::kFailed;
  }
  execv(window.c_str(), argv);
  std::cerr << "echoweave: The window in '" << ew::printableLine(window.string()) << "' could not be started (" << std::strerror(errno)
            << "); install EchoWeave again.\n";
  return ew::cli::kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  std::signal(SIGXFSZ, SIG_IGN);                   // a file that may not grow is a sentence and a clean folder, not the end of the program
  static ew::cli::PrintableStream err(std::cerr);  // the output stream is for results
  spdlog::set_default_logger(std::make_shared<spdlog::logger>("echoweave", std::make_shared<spdlog::sinks::ostream_sink_mt>(err, true)));
  const std::vector<std::string> args(argv + 1, argv + argc);
  if (ew::cli::isHeadless(args)) return runHeadless(args);
  const auto wish = ew::cli::windowArguments(args);
  if (wish) return openWindow(argv);
  // A lone word that is nothing to open is most likely a command: one of a plugin that does not announce it, or a slip of the pen.
  if (!args.empty() && !args.front().starts_with("-") && wish.error().code == ew::ErrorCode::notFound &&
      args.front().find_first_of("/.") == std::string::npos)
    return runHeadless(args);
  err << "echoweave: " << wish.error().sentence() << "\n" << std::flush;
  return wish.error().code == ew::ErrorCode::badUsage ? ew::cli::kWrongUsage : ew::cli::kFailed;
}
