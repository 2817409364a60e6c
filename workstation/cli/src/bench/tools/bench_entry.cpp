#include "bench/tools/bench_entry.h"

#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "bench/tools/bench_print.h"
#include "ew/core/foreign_json.h"
#include "ew/core/simd.h"
#include "ew/io/safe_file.h"

namespace ew::cli {
namespace {

using nlohmann::json;

constexpr const char* kPage = "accuracy-and-time.html";

/// What every bench with a page can be asked.
struct PageArguments {
  std::string html;  ///< folder
  std::string note;  ///< about the machine
};

void addPageOptions(CLI::App& app, PageArguments& page) {
  app.add_option("--html", page.html,
                 std::string("Also write ") + kPage + ", the curves of accuracy against time; what it held of other benchmarks stays")
      ->type_name("DIR");
  app.add_option("--note", page.note, "A sentence about the machine, for the page: what else it was doing")->type_name("TEXT");
}

/// Before the first measurement: a page that comes to lie there meanwhile is somebody else's.
Result<void> announcePage(const PageArguments& page, Run& run) {
  if (page.html.empty()) return {};
  if (auto writable = run.outputs.announceFolder(page.html); !writable) return writable;
  return run.output(std::filesystem::path(page.html) / kPage);
}

Result<void> writePage(const PageArguments& page, const BenchResults& results, Run& run) {
  if (page.html.empty()) return {};
  const std::filesystem::path file = std::filesystem::path(page.html) / kPage;
  const std::vector<std::string> introduction = {
      "Medians of interleaved repetitions; what stands in one section comes from one run. Times of one thread are its processor time, so "
      "that other programs disturb them little; accuracy is measured against a field known exactly, so its ceiling is the rounding to 256 "
      "grey levels, and that of confidence against the shadows of a forward model. VTK's vtkImageReslice reads the same voxels in the same "
      "memory, on one thread, with its optimisation on. In the charts, up and to the left is better."};
  std::vector<BenchSection> sections = results.sections();
  for (BenchSection& section : sections) {
    section.text += (section.text.empty() ? "" : " ") + ("Machine: " + results.machine() + ".");
    if (simdInUse() != bestSimd()) section.title += ", kernels on " + simdInUse();  // beside the sections of the best
    if (!page.note.empty()) section.text += " " + page.note;
  }
  // What this run did not measure stays on the page.
  std::ostringstream before;
  if (std::ifstream old(file, std::ios::binary); old) before << old.rdbuf();
  const std::string text = benchPage("EchoWeave: accuracy and time", introduction, sections, before.str());
  if (auto written = writeFileSafely(run.outputs.staged(file), text); !written) return written;
  run.say("Wrote " + file.string() + ".");
  return {};
}

Result<int> runEntry(BenchEntry& entry, bool isOneOfMany, const PageArguments& page, Run& run) {
  if (auto announced = announcePage(page, run); !announced) return passOn(announced.error());
  if (auto announced = entry.announce(run); !announced) return passOn(announced.error());
  BenchResults results(run, isOneOfMany);
  if (auto measured = entry.measure(run, results, run.progress); !measured) return passOn(measured.error());
  if (auto written = writePage(page, results, run); !written) return passOn(written.error());
  return kDone;
}

}  // namespace

Result<void> BenchResults::take(const char* name, Result<json> measured, SectionsOf sectionsOf) {
  if (!measured) return passOn(measured.error());
  for (auto& step : (*measured)["steps"]) run_.report.summarisedSteps.push_back(std::move(step));
  measured->erase("steps");
  addSections(sectionsOf(*measured));
  machine_ = textAt(*measured, "machine", "-");
  run_.progress.clear();
  if (!run_.quiet()) printResults(run_.out(), *measured);
  if (isOneOfMany_)
    run_.report.quality[name] = *std::move(measured);
  else
    run_.report.quality = *std::move(measured);
  return {};
}

Result<void> BenchResults::takeBeside(const char* name, Result<json> measured, SectionsOf sectionsOf) {
  if (!measured) return passOn(measured.error());
  addSections(sectionsOf(*measured));
  run_.report.quality[name] = *std::move(measured);
  return {};
}

void BenchResults::addSections(std::vector<BenchSection> sections) {
  for (auto& section : sections) sections_.push_back(std::move(section));
}

BenchEntry::~BenchEntry() = default;

Result<void> BenchEntry::announce(Run&) { return {}; }

void addBenchEntry(CLI::App& group, Selection& selection, const BenchWords& words, const std::shared_ptr<BenchEntry>& entry) {
  const auto page = std::make_shared<PageArguments>();
  auto& app = addCommand(group, selection, words.name, words.description, words.examples,
                         [page, entry, isOneOfMany = words.isOneOfMany](Run& run) { return runEntry(*entry, isOneOfMany, *page, run); });
  addPageOptions(app, *page);
  entry->addOptions(app);
}

}  // namespace ew::cli
