#include "run/program.h"

#include <spdlog/sinks/ostream_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <iostream>
#include <memory>

#include "run/printable_stream.h"

namespace ew::cli {
namespace {

std::atomic<bool> stopAsked{false};
static_assert(std::atomic<bool>::is_always_lock_free, "set from a signal handler");

extern "C" void askToStop(int) { stopAsked.store(true); }

}  // namespace

std::ostream& beginProgram() {
  std::signal(SIGXFSZ, SIG_IGN);  // a file that may not grow is a sentence and a clean folder, not the end of the program
  static PrintableStream err(std::cerr);
  spdlog::set_default_logger(std::make_shared<spdlog::logger>("echoweave", std::make_shared<spdlog::sinks::ostream_sink_mt>(err, true)));
  return err;
}

int runUntilStopped(const std::function<int(const Surroundings&)>& run) {
  struct sigaction action {};
  action.sa_handler = askToStop;
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);  // a second Ctrl-C ends the program the hard way
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  return run({std::cout, std::cerr, isatty(STDERR_FILENO) == 1, &stopAsked});
}

}  // namespace ew::cli
