#include "bench/teaching/teaching_commands.h"

#include "run/arguments.h"

namespace ew::cli {

void addTeachingCases(CLI::App& app, TeachingArguments& arguments) {
  app.add_option("--case", arguments.cases, "A case; may be given several times (every shipped one)")->type_name("CASE");
}

void addTeachingThreads(CLI::App& app, TeachingArguments& arguments) {
  addCount(app, "--threads", arguments.threads, 0, 256, "Threads; 0: one per processor (0)");
}

}  // namespace ew::cli
