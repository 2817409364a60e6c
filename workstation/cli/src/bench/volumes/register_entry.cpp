#include "bench/volumes/register_entry.h"

#include <filesystem>
#include <memory>

#include "bench/tools/bench_options.h"
#include "bench/volumes/bench_paper.h"
#include "run/arguments.h"

namespace ew::cli {

void RegisterEntry::addOptions(CLI::App& app) {
  addOwnOptions(app, "--side");
  addDrawSeed(app, options.seed);
  addRepetitions(app, repetitions);
  addNoPeers(app, noPeers);
}

void RegisterEntry::addOwnOptions(CLI::App& app, const char* side) {
  addCount(app, side, options.side, 48, 256, "Voxels a side of a pair to register (96)");
  app.add_option("--paper", paper, "Write figures 6 to 8 of the 1998 paper, made from a virtual patient, to this folder")->type_name("DIR");
}

Result<void> RegisterEntry::announce(Run& run) {
  if (paper.empty()) return {};
  return run.outputs.announceFolder(paper);
}

Result<void> RegisterEntry::measure(Run& run, BenchResults& results, Progress& progress) {
  RegisterBenchOptions asked = options;
  asked.repetitions = repetitions.value_or(asked.repetitions);
  asked.peers = !noPeers;
  run.report.options["register"] = {{"side", asked.side}, {"repetitions", asked.repetitions}, {"peers", asked.peers}, {"seed", asked.seed}};
  run.report.seed = asked.seed;
  if (auto taken = results.take("register", benchRegister(asked, progress), registerSections); !taken) return taken;
  return paper.empty() ? Result<void>() : drawPaper(run, results, progress);
}

Result<void> RegisterEntry::drawPaper(Run& run, BenchResults& results, Progress& progress) const {
  PartOfProgress part(progress, 1.0, 1.0);  // a bar does not go back
  PaperBenchOptions asked;
  asked.seed = options.seed;
  const std::filesystem::path folder(paper);
  const auto place = [&](const std::string& name) -> Result<std::filesystem::path> {
    if (auto announced = run.output(folder / name); !announced) return passOn(announced.error());
    return run.outputs.staged(folder / name);
  };
  return results.takeBeside("paper", benchPaper(asked, place, part), paperSections);
}

void addRegisterBench(CLI::App& group, Selection& selection) {
  addBenchEntry(group, selection,
                {"register",
                 "Every way of registering against pairs whose truth is known, beside elastix and plastimatch where they are installed",
                 {"bench register", "bench register --html bench --report bench.json", "bench register --side 128 --no-peers"}},
                std::make_shared<RegisterEntry>());
}

}  // namespace ew::cli
