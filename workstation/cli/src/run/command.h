#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ew/cli/run_command.h"
#include "ew/core/output_set.h"
#include "ew/core/result.h"
#include "run/console_progress.h"
#include "run/printable_stream.h"
#include "run/report.h"

namespace ew::cli {

/// One run of one command: what it may touch.
class Run {
 public:
  Run(const Surroundings& surroundings, bool quiet)
      : progress(surroundings, quiet), out_(surroundings.out), err_(surroundings.err), quiet_(quiet) {}

  ConsoleProgress progress;
  Report report;
  OutputSet outputs;

  /// What the user asked to see, on the output stream, quiet or not.
  std::ostream& out() { return out_; }
  /// A line that says what was done, told once every output is in place; not when quiet.
  void say(const std::string& line);
  /// A remark on the error stream: something the user should know although it worked; not when quiet.
  void remark(const Message& line);
  [[nodiscard]] bool quiet() const { return quiet_; }

  /// Names a file the command reads, for the report and so that no output is written over it nor over what it names in turn. An empty name
  /// is none.
  /// @error badUsage (an output was announced there)
  [[nodiscard]] Result<void> input(const std::filesystem::path& file);
  /// The same without naming it in the report: for a file that is read, and named, later.
  [[nodiscard]] Result<void> protect(const std::filesystem::path& file);
  /// Announces a file the command writes (see OutputSet::announce) and names it in the report.
  /// @error also badUsage (X.mhd where X.raw is there and is not its own)
  [[nodiscard]] Result<void> output(const std::filesystem::path& file, std::string_view endings = {});

  /// Ends the command with an error that is its answer: everything was done, so outputs and report are put in place before it is told.
  [[nodiscard]] int answer(Error error);
  [[nodiscard]] const std::optional<Error>& answered() const { return answer_; }

  /// What the user reads when the command is stopped. Empty: whoever was stopped says himself what he kept.
  Message stopped = ew::say<"Stopped as asked; nothing was written.">();
  /// The command has put its outputs in place itself: there is nothing left that could be stopped.
  bool isPublished = false;
  /// Outputs that somebody else puts in place, after those of `outputs` and with them: all or none. Empty: there are none.
  std::function<Result<void>()> putInPlace;

  /// Prints the collected lines.
  void tellWhatWasDone();

 private:
  PrintableStream out_, err_;
  bool quiet_;
  std::vector<std::string> said_;
  std::optional<Error> answer_;
};

/// The body of a command; returns kDone or kVerdict.
using Work = std::function<Result<int>(Run&)>;

/// What the parser found: the body to run and the options every command has.
struct Selection {
  std::string command;  ///< "reconstruct", "case show" …
  Work work;
  std::string reportFile;
  std::string simd;        ///< as useSimd; empty: what the environment asks for
  std::string unlockFrom;  ///< as readPassphrase; empty: nobody gives an instructor's passphrase
  bool quiet = false;
  bool verbose = false;
};

/// Of the program that answers for the words of a command line alone: its commands are compiled without what they do, and so do without the
/// libraries that they do it with (decision 0082).
#ifdef EW_WORDS_ALONE
inline constexpr bool kWordsAlone = true;
#else
inline constexpr bool kWordsAlone = false;
#endif

/// As addCommand.
CLI::App& addCommandOf(CLI::App& parent, Selection& selection, const std::string& name, const std::string& description,
                       const std::vector<std::string>& examples, Work work);

/// Adds a command with the options all commands share; its body runs after the whole line was understood.
/// @param examples whole lines without the program's name, shown under the help
/// @param body as Work; where kWordsAlone it is kept, for the options write into what it holds, and not referred to
template <class Body>
CLI::App& addCommand(CLI::App& parent, Selection& selection, const std::string& name, const std::string& description,
                     const std::vector<std::string>& examples, Body body) {
  if constexpr (kWordsAlone)
    return addCommandOf(parent, selection, name, description, examples, [held = std::move(body)](Run&) -> Result<int> { return kDone; });
  else
    return addCommandOf(parent, selection, name, description, examples, Work(std::move(body)));
}

void addImport(CLI::App& root, Selection& selection);
void addReconstruct(CLI::App& root, Selection& selection);
void addRegister(CLI::App& root, Selection& selection);
void addLevel(CLI::App& root, Selection& selection);
void addMeasure(CLI::App& root, Selection& selection);
void addSlice(CLI::App& root, Selection& selection);
void addSurfaces(CLI::App& root, Selection& selection);
void addScan(CLI::App& root, Selection& selection);
void addScreen(CLI::App& root, Selection& selection);
void addReplay(CLI::App& root, Selection& selection);
void addSend(CLI::App& root, Selection& selection);
void addPhantom(CLI::App& root, Selection& selection);
void addCase(CLI::App& root, Selection& selection);
void addCriteria(CLI::App& root, Selection& selection);
void addLesson(CLI::App& root, Selection& selection);
void addAssess(CLI::App& root, Selection& selection);
void addKey(CLI::App& root, Selection& selection);
void addAccess(CLI::App& root, Selection& selection);
void addPreset(CLI::App& root, Selection& selection);
void addRecords(CLI::App& root, Selection& selection);
void addTracker(CLI::App& root, Selection& selection);
void addPlugins(CLI::App& root, Selection& selection);

}  // namespace ew::cli
