#include "run/programs.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <iostream>

#include "ew/cli/run_command.h"
#include "ew/core/printable.h"

namespace ew::cli {
namespace fs = std::filesystem;

fs::path programBeside(const char* name) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path() / name;
  return !error && fs::exists(program, error) ? program : fs::path();
}

int become(const fs::path& program, const char* what, char** argv) {
  execv(program.c_str(), argv);
  std::cerr << "echoweave: " << what << " in '" << printableLine(program.string()) << "' could not be started (" << std::strerror(errno)
            << "); install EchoWeave again.\n";
  return kFailed;
}

int becomeCommand(char** argv) {
  const fs::path program = programBeside(kCommandProgram);
  if (!program.empty()) return become(program, "The program of the commands", argv);
  std::cerr << "echoweave: The program of the commands, " << kCommandProgram << ", is not here; install EchoWeave again.\n";
  return kFailed;
}

bool hasDisplay() {
  for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
    if (const char* value = std::getenv(name); value && *value) return true;
  return false;
}

bool seemsCommand(std::span<const std::string> args, const Error& problem) {
  return !args.empty() && !args.front().starts_with("-") && problem.code == ErrorCode::notFound &&
         args.front().find_first_of("/.") == std::string::npos;
}

}  // namespace ew::cli
