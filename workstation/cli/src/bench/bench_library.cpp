#include "bench/bench_library.h"

#include <stdlib.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <memory>
#include <ostream>
#include <random>
#include <thread>

#include "bench/tools/bench_parts.h"
#include "ew/core/numbers.h"
#include "ew/io/safe_file.h"
#include "ew/library/index.h"
#include "run/arguments.h"
#include "run/report.h"

namespace ew {
namespace {

using nlohmann::json;
namespace fs = std::filesystem;

constexpr std::size_t kCardsRead = 50;

/// Words of cases; the more often one is used, the earlier it stands.
constexpr const char* kLibraryWords[] = {
    "liver",  "kidney", "gall",     "bladder",     "pain",       "upper",     "abdomen",   "normal",   "portal", "vein",
    "spleen", "aorta",  "fetal",    "biometry",    "thyroid",    "nodule",    "carotid",   "stenosis", "fluid",  "trauma",
    "stone",  "cyst",   "pancreas", "meals",       "fever",      "colic",     "swelling",  "murmur",   "acute",  "chronic",
    "Gefäß",  "Niere",  "Übelkeit", "examination", "systematic", "follow-up", "emergency", "vascular"};
constexpr const char* kLibraryRegions[] = {"upper abdomen", "lower abdomen", "neck", "thorax", "obstetrics", "vessels", "trauma"};

class BenchFolder {
 public:
  static std::unique_ptr<BenchFolder> make() {
    std::error_code failed;
    std::string name = (fs::temp_directory_path(failed) / "echoweave-library-XXXXXX").string();
    if (failed || ::mkdtemp(name.data()) == nullptr) return nullptr;
    return std::unique_ptr<BenchFolder>(new BenchFolder(name));
  }
  ~BenchFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  BenchFolder(const BenchFolder&) = delete;
  BenchFolder& operator=(const BenchFolder&) = delete;
  const fs::path path;

 private:
  explicit BenchFolder(fs::path made) : path(std::move(made)) {}
};

class CaseMaker {
 public:
  explicit CaseMaker(std::uint64_t seed) : random_(seed) {}

  /// As in a language: a few words are everywhere, thousands are rare.
  [[nodiscard]] std::string word() {
    const double share = std::uniform_real_distribution<double>(0.0, 1.0)(random_);
    if (share < 0.6) return kLibraryWords[static_cast<std::size_t>(share * share / 0.36 * static_cast<double>(std::size(kLibraryWords)))];
    constexpr const char* kSyllables[] = {"ra", "li", "to",  "cho", "me", "na",  "sin", "ver",
                                          "po", "ga", "tis", "um",  "hy", "per", "de",  "ly"};
    std::string made;
    for (int n = 1 + upTo(3); n > 0; --n) made += kSyllables[static_cast<std::size_t>(upTo(static_cast<int>(std::size(kSyllables))) - 1)];
    return made;
  }
  [[nodiscard]] std::string text(int count) {
    std::string all;
    for (int n = 0; n < count; ++n) all += (n > 0 ? " " : "") + word();
    return all;
  }
  [[nodiscard]] int upTo(int most) { return std::uniform_int_distribution<int>(1, most)(random_); }

  /// About as long as the shipped ones with their lessons.
  [[nodiscard]] json manifest(int number) {
    json lessons = json::array();
    for (int n = 0; n < 3; ++n) {
      json steps = json::array();
      for (int step = 0; step < 6; ++step)
        steps.push_back({{"id", "step-" + std::to_string(step)},
                         {"kind", "read"},
                         {"title", text(4)},
                         {"text", text(40)},
                         {"hints", {text(10), text(10)}}});
      lessons.push_back({{"id", "lesson-" + std::to_string(n)},
                         {"title", text(4)},
                         {"aim", text(12)},
                         {"level", upTo(5)},
                         {"minutes", 10 + upTo(20)},
                         {"tags", {word()}},
                         {"steps", std::move(steps)}});
    }
    return {{"format", 2},
            {"id", "case-" + std::to_string(number)},
            {"title", text(4) + " " + std::to_string(number)},
            {"title_for_trainees", text(4)},
            {"region", kLibraryRegions[static_cast<std::size_t>(upTo(static_cast<int>(std::size(kLibraryRegions))) - 1)]},
            {"patient", {{"name", text(2)}, {"sex", "female"}, {"age_years", 20 + upTo(60)}}},
            {"history", text(30)},
            {"indication", text(12)},
            {"diagnosis", text(15)},
            {"findings", {text(12), text(12)}},
            {"difficulty", upTo(5)},
            {"tags", {word(), word()}},
            {"volume", {{"file", "volume.mha"}}},
            {"parts", {{"lessons", {{"format", 1}, {"lessons", std::move(lessons)}}}}}};
  }

 private:
  std::mt19937_64 random_;
};

Result<void> writeCase(const fs::path& folder, const json& manifest) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  // Neither aside nor synced: ten thousand of those would measure the disk.
  std::ofstream out(folder / "case.json", std::ios::binary);
  out << manifest.dump(2);
  out.close();
  if (!out)
    return failure(ErrorCode::notWritable,
                   say<"'%1' cannot be written; make room in the folder of temporary files.">(folder / "case.json"));
  return {};
}

template <class Work>
double msOf(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double mib(const fs::path& file) {
  double bytes = 0.0;
  for (const char* ending : {"", "-wal"}) {
    std::error_code failed;
    const auto size = fs::file_size(file.string() + ending, failed);
    if (!failed) bytes += static_cast<double>(size);
  }
  return bytes / (1 << 20);
}

/// Everything is opened anew, as the start of the program does.
struct LibraryBench {
  fs::path file;
  std::vector<LibraryRoot> roots;
  Error error;

  bool refresh(LibraryIndex& index, Progress& progress, RefreshReport& report) {
    auto done = index.refresh(roots, progress);
    const bool isDone = done.has_value();
    if (isDone)
      report = *std::move(done);
    else
      error = done.error();
    return isDone;
  }
};

Result<json> measure(const LibraryBenchOptions& options, const BenchFolder& folder, CaseMaker& maker, Progress& progress) {
  LibraryBench bench{folder.path / "library.index", {{folder.path / "cases", LibraryKind::own}}, {}};
  const auto nameOf = [&](int number) { return folder.path / "cases" / ("case-" + std::to_string(number)); };
  json report = {{"cases", options.cases}, {"queries", options.queries}, {"changed", options.changed}};
  RefreshReport seen;
  bool good = true;
  {
    auto index = openIndex(bench.file);
    if (!index) return passOn(index.error());
    PartOfProgress part(progress, 0.3, 0.7);
    report["first_index_s"] = 1e-3 * msOf([&] { good = bench.refresh(**index, part, seen); });
    if (!good) return passOn(bench.error);
    report["first_read"] = seen.read;
  }
  std::unique_ptr<LibraryIndex> index;
  report["warm_open_ms"] = msOf([&] {
    if (auto opened = openIndex(bench.file)) index = std::move(*opened);
    good = index && search(*index, {}, 0, kCardsRead).has_value();
  });
  if (!good) return failure(ErrorCode::notReadable, say<"The index that was just made cannot be read; run the benchmark again.">());
  report["unchanged_refresh_ms"] = msOf([&] { good = bench.refresh(*index, noProgress(), seen); });
  report["unchanged_read"] = seen.read;
  for (int n = 0; good && n < options.changed; ++n) {
    const int number = static_cast<int>(static_cast<long long>(n) * options.cases / options.changed);
    if (auto written = writeCase(nameOf(number), maker.manifest(number)); !written) return passOn(written.error());
  }
  if (good) report["changed_refresh_ms"] = msOf([&] { good = bench.refresh(*index, noProgress(), seen); });
  if (!good) return passOn(bench.error);
  report["changed_read"] = seen.read;

  std::vector<double> letters_us;
  std::size_t most = 0;
  for (int n = 0; n < options.queries && good; ++n) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
    progress.report(say<"Searching as people type">(), 0.8 + 0.2 * n / options.queries);
    const std::string typed = maker.text(maker.upTo(3));
    for (std::size_t length = 1; length <= typed.size(); ++length) {
      CaseQuery query;
      query.words = typed.substr(0, length);
      letters_us.push_back(1e3 * msOf([&] {
                             const auto page = search(*index, query, 0, kCardsRead);
                             good = page.has_value();
                             if (page) most = std::max(most, page->total);
                           }));
    }
  }
  const cli::StepSummary summary = cli::summarise(letters_us);
  report["letters"] = summary.count;
  report["search_median_ms"] = 1e-3 * summary.median_us;
  report["search_p99_ms"] = 1e-3 * summary.p99_us;
  report["search_worst_ms"] = 1e-3 * summary.max_us;
  report["most_found"] = most;
  report["index_mib"] = mib(bench.file);
  report["machine"] = machineName();
  return report;
}

}  // namespace

Result<json> benchLibrary(const LibraryBenchOptions& options, Progress& progress) {
  const auto folder = BenchFolder::make();
  if (!folder) return failure(ErrorCode::notWritable, say<"No temporary folder can be made; set TMPDIR to a folder you may write to.">());
  CaseMaker maker(options.seed);
  for (int n = 0; n < options.cases; ++n) {
    if (progress.cancelRequested()) return failure(ErrorCode::cancelled, say<"The benchmark was stopped.">());
    if (n % 100 == 0) progress.report(say<"Making the folders of cases">(), 0.3 * n / options.cases);
    if (auto written = writeCase(folder->path / "cases" / ("case-" + std::to_string(n)), maker.manifest(n)); !written)
      return passOn(written.error());
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(100));  // what was written a moment ago would be read twice
  return measure(options, *folder, maker, progress);
}

namespace cli {

void addLibraryBench(CLI::App& group, Selection& selection) {
  const auto options = std::make_shared<LibraryBenchOptions>();
  auto& app = addCommand(
      group, selection, "library", "The index of a library of many cases: made, opened, refreshed, searched letter by letter",
      {"bench library", "bench library --cases 100000", "bench library --report library.json"}, [options](Run& run) -> Result<int> {
        options->changed = std::min(options->changed, options->cases);
        run.report.options = {
            {"cases", options->cases}, {"queries", options->queries}, {"changed", options->changed}, {"seed", options->seed}};
        run.report.seed = options->seed;
        auto measured = benchLibrary(*options, run.progress);
        if (!measured) return passOn(measured.error());
        run.progress.clear();
        const auto figure = [&](const char* key, int digits) { return rounded((*measured)[key].get<double>(), digits); };
        if (!run.quiet())
          run.out() << options->cases << " cases\nfirst index: " << figure("first_index_s", 2) << " s, " << figure("index_mib", 1)
                    << " MiB\nopened again, all found and the first cards read: " << figure("warm_open_ms", 1)
                    << " ms\nrefreshed with nothing changed: " << figure("unchanged_refresh_ms", 1) << " ms, "
                    << figure("unchanged_read", 0) << " manifests read\nrefreshed with " << options->changed
                    << " changed: " << figure("changed_refresh_ms", 1) << " ms, " << figure("changed_read", 0)
                    << " manifests read\nsearched after each of " << figure("letters", 0) << " letters: median "
                    << figure("search_median_ms", 2) << " ms, 99 % within " << figure("search_p99_ms", 2) << " ms, worst "
                    << figure("search_worst_ms", 2) << " ms\n";
        run.report.quality = *std::move(measured);
        return kDone;
      });
  addCount(app, "--cases", options->cases, 1, 1000000, "Case folders that are made in the folder of temporary files (10000)");
  addCount(app, "--queries", options->queries, 1, 100000, "Queries that are typed letter by letter (200)");
  addCount(app, "--changed", options->changed, 1, 1000000, "Cases that change before a refresh (10)");
  addSeed(app, "--seed", options->seed, "Which words the cases have and which are searched (1)");
}

}  // namespace cli
}  // namespace ew
