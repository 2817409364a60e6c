#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "bench/tools/bench_page.h"
#include "ew/core/progress.h"
#include "ew/core/result.h"
#include "run/command.h"

namespace ew::cli {

/// Collects what benches measure: rows for the report, lines for the screen, sections for the page.
class BenchResults {
 public:
  using SectionsOf = std::vector<BenchSection> (*)(const nlohmann::json& measured);

  /// @param isOneOfMany the report keeps the figures of each bench under its name
  BenchResults(Run& run, bool isOneOfMany) : run_(run), isOneOfMany_(isOneOfMany) {}

  /// Takes what a bench measured, or passes on why it could not.
  [[nodiscard]] Result<void> take(const char* name, Result<nlohmann::json> measured, SectionsOf sectionsOf);
  /// Figures that stand beside those of the bench, under a name of their own; they are not told on the screen.
  [[nodiscard]] Result<void> takeBeside(const char* name, Result<nlohmann::json> measured, SectionsOf sectionsOf);

  [[nodiscard]] const std::string& machine() const { return machine_; }
  [[nodiscard]] const std::vector<BenchSection>& sections() const { return sections_; }

 private:
  void addSections(std::vector<BenchSection> sections);

  Run& run_;
  bool isOneOfMany_;
  std::string machine_;
  std::vector<BenchSection> sections_;
};

/// One bench below `bench`: what it can be asked, and how it is run. What it draws is the sections that it hands to the results.
class BenchEntry {
 public:
  BenchEntry() = default;
  BenchEntry(const BenchEntry&) = delete;
  BenchEntry& operator=(const BenchEntry&) = delete;
  virtual ~BenchEntry();

  virtual void addOptions(CLI::App& app) = 0;
  /// Announces what is written beside page and report, before anything is measured. @error as OutputSet
  [[nodiscard]] virtual Result<void> announce(Run& run);
  [[nodiscard]] virtual Result<void> measure(Run& run, BenchResults& results, Progress& progress) = 0;
};

/// How a bench is called.
struct BenchWords {
  const char* name;
  const char* description;
  std::vector<std::string> examples;
  bool isOneOfMany = false;  ///< it runs several, whose figures the report keeps apart
};

/// Adds the bench as a command, with the options of the page: `--html`, `--note`.
void addBenchEntry(CLI::App& group, Selection& selection, const BenchWords& words, const std::shared_ptr<BenchEntry>& entry);

}  // namespace ew::cli
