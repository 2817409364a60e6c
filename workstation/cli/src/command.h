#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "console_progress.h"
#include "ew/cli/run_command.h"
#include "ew/core/result.h"
#include "outputs.h"
#include "report.h"

namespace ew::cli {

/// One run of one command: what it may touch.
class Run {
 public:
  Run(const Surroundings& surroundings, bool quiet) : progress(surroundings, quiet), surroundings_(surroundings), quiet_(quiet) {}

  ConsoleProgress progress;
  Report report;
  Outputs outputs;

  /// What the user asked to see, on the output stream, quiet or not.
  std::ostream& out() { return surroundings_.out; }
  /// A line that says what was done, told once every output is in place; not when quiet.
  void say(const std::string& line);
  /// A remark on the error stream: something the user should know although it worked; not when quiet.
  void remark(const std::string& line);
  [[nodiscard]] bool quiet() const { return quiet_; }

  /// Names a file the command reads, for the report and so that no output is written over it.
  void input(const std::filesystem::path& file);
  /// Announces a file the command writes (see Outputs::announce) and names it in the report.
  [[nodiscard]] Result<void> output(const std::filesystem::path& file, std::string_view endings = {});

  /// Prints the collected lines.
  void tellWhatWasDone();

 private:
  Surroundings surroundings_;
  bool quiet_;
  std::vector<std::string> said_;
};

/// The body of a command; returns kDone or kVerdict.
using Work = std::function<Result<int>(Run&)>;

/// What the parser found: the body to run and the options every command has.
struct Selection {
  std::string command;  ///< "reconstruct", "case show" …
  Work work;
  std::string reportFile;
  bool quiet = false;
  bool verbose = false;
};

/// Adds a command with the options all commands share; its body runs after the whole line was understood.
/// @param examples whole lines without the program's name, shown under the help
CLI::App& addCommand(CLI::App& parent, Selection& selection, const std::string& name, const std::string& description,
                     const std::vector<std::string>& examples, Work work);

void addImport(CLI::App& root, Selection& selection);
void addReconstruct(CLI::App& root, Selection& selection);
void addRegister(CLI::App& root, Selection& selection);
void addSlice(CLI::App& root, Selection& selection);
void addScan(CLI::App& root, Selection& selection);
void addPhantom(CLI::App& root, Selection& selection);
void addCase(CLI::App& root, Selection& selection);
void addPlugins(CLI::App& root, Selection& selection);
void addBench(CLI::App& root, Selection& selection);

}  // namespace ew::cli
