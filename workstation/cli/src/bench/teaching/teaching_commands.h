#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>
#include <vector>

#include "run/command.h"

namespace ew::cli {

// The benches of what teaches, below `bench`; each says what it found in lines and in its report.

void addCompassBench(CLI::App& group, Selection& selection);
void addExercisesBench(CLI::App& group, Selection& selection);
void addMetricsBench(CLI::App& group, Selection& selection);
void addAttemptsBench(CLI::App& group, Selection& selection);

/// What all of them are asked: `--case`, `--threads`.
struct TeachingArguments {
  std::vector<std::string> cases;  ///< empty: every shipped one
  int threads = 0;                 ///< 0: one per processor
  std::uint64_t seed = 1;
};
void addTeachingCases(CLI::App& app, TeachingArguments& arguments);
void addTeachingThreads(CLI::App& app, TeachingArguments& arguments);

}  // namespace ew::cli
