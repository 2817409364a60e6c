#include <algorithm>
#include <iterator>
#include <map>
#include <ostream>

#include "commands/case_card.h"
#include "commands/case_files.h"
#include "commands/case_library.h"
#include "commands/case_new.h"
#include "commands/case_withdraw.h"
#include "ew/core/figures.h"
#include "ew/core/json_fields.h"
#include "ew/core/numbers.h"
#include "ew/core/printable.h"
#include "ew/door/door.h"
#include "ew/door/headless_host.h"
#include "ew/imaging/effect_info.h"
#include "ew/io/safe_file.h"
#include "ew/library/case_truth.h"
#include "ew/library/preparation.h"
#include "ew/library/published.h"
#include "ew/library/schema.h"
#include "run/arguments.h"
#include "run/command.h"
#include "run/volume_input.h"

namespace ew::cli {
namespace {

using nlohmann::json;

struct CaseArguments {
  std::string folder;
  std::string chosen;
  std::vector<std::string> several;
  bool all = false;
  bool first = false;
  std::string keepSweeps;
  int threads = 0;
  bool asJson = false;
};

json problemJson(const Error& problem) {
  json context = json::object();
  for (const auto& [name, value] : problem.context) context[name] = value;
  return {{"code", nameOf(problem.code)}, {"sentence", problem.sentence()}, {"context", context}};
}

std::string dumped(const json& value) { return value.dump(2, ' ', false, json::error_handler_t::replace); }

std::string volumeText(const CaseVolume& volume) {
  if (!volume.file.empty()) return volume.file;
  if (!volume.sweeps.empty())
    return "made from " + counted(volume.sweeps.size(), "sweep") + " of " + volume.recipe +
           (volume.reconstruct.spacing_mm ? " at " + figureText(*volume.reconstruct.spacing_mm) + " mm"
                                          : " at the spacing their frames carry");
  if (!volume.recipe.empty()) return "made from " + volume.recipe + " at " + textOf(volume.recipeSpacing_mm) + " mm";
  return "none";
}

/// "gain and DGC, shadow and enhancement", in the console's words.
std::string sceneText(const Scene& scene) {
  std::string text;
  for (const EffectInfo& effect : sceneEffects())
    if (effect.isOn(scene)) text += (text.empty() ? "" : ", ") + std::string(effect.shortName);
  return text.empty() ? "bare" : text;
}

/// Units of the measurements that the patient knows, by name: what is measured stands in the recipe.
std::map<std::string, std::string> unitsOfPatient(const Case& opened, Run& run) {
  std::map<std::string, std::string> units;
  const bool isAsked = std::any_of(opened.measurements.begin(), opened.measurements.end(),
                                   [](const CaseMeasurement& each) { return each.tolerance && each.unit.empty(); });
  if (!isAsked || opened.volume.recipe.empty()) return units;
  const auto truth = loadCaseTruth(opened, run.progress);
  if (!truth) return units;  // the patient cannot be read: 'case validate' says why
  for (const ReferenceMeasurement& each : truth->measurements) units[each.name] = each.unit;
  return units;
}

/// "gall stone, width (12.4 mm), tolerance 2 mm".
std::string measurementText(const CaseMeasurement& measurement, const std::string& unit) {
  const std::string behind = unit.empty() ? "" : " " + unit;
  return measurement.name + (measurement.value ? " (" + textOf(*measurement.value) + behind + ")" : "") +
         (measurement.tolerance ? ", tolerance " + textOf(*measurement.tolerance) + behind : "");
}

/// What is looked for and measured, a line each.
std::vector<std::pair<std::string, std::string>> expectedLines(const Case& opened, const std::map<std::string, std::string>& units) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const auto& each : opened.previousExaminations)
    lines.emplace_back("Before",
                       each.when + (each.kind.empty() ? "" : ", " + each.kind) + (each.findings.empty() ? "" : ": " + each.findings));
  for (const auto& finding : opened.findings) lines.emplace_back("Finding", finding);
  for (const auto& target : opened.targets) lines.emplace_back("Target", target.name + " (" + nameOf(target.kind) + ")");
  for (const auto& each : opened.measurements)
    lines.emplace_back("Measurement",
                       measurementText(each, each.unit.empty() && units.contains(each.name) ? units.at(each.name) : each.unit));
  return lines;
}

/// No report is written over a manifest of the folder, also one that cannot be read.
Result<void> protectCasesOf(const std::filesystem::path& folder, Run& run) {
  std::error_code problem;
  for (std::filesystem::directory_iterator at(folder, problem), end; !problem && at != end; at.increment(problem))
    if (auto kept = run.protect(at->path() / "case.json"); !kept) return kept;
  return {};
}

/// A case as it is listed, and what it is to whoever asks.
struct Listed {
  Case entry;
  std::string kind;  ///< "own", "published", "shipped"; empty: of a folder that was named
  int revision = 0;  ///< of a published one
};

struct Listing {
  std::vector<Listed> cases;
  std::vector<Error> problems;
  std::vector<std::filesystem::path> noCases;
};

Result<void> addFolder(Listing& all, const std::filesystem::path& folder, const std::string& kind, Run& run) {
  std::error_code ignored;
  if (!std::filesystem::is_directory(folder, ignored)) return {};
  if (auto kept = run.input(folder); !kept) return kept;
  if (auto kept = protectCasesOf(folder, run); !kept) return kept;
  auto list = listCases(folder);
  for (auto& each : list.cases) all.cases.push_back({std::move(each), kind});
  std::move(list.problems.begin(), list.problems.end(), std::back_inserter(all.problems));
  std::move(list.noCases.begin(), list.noCases.end(), std::back_inserter(all.noCases));
  return {};
}

/// The cases that an id can name: the user's own, those that are published (imported ones are), the shipped ones.
Result<Listing> everyCase(Run& run) {
  Listing all;
  if (auto own = addFolder(all, ownCasesFolder(), "own", run); !own) return passOn(own.error());
  for (const CaseRevision& each : listPublished(libraryFolder())) {
    if (auto kept = run.input(each.folder / "case.json"); !kept) return passOn(kept.error());
    auto opened = loadCase(each.folder);
    if (opened)
      all.cases.push_back({*std::move(opened), "published", each.revision});
    else
      all.problems.push_back(opened.error());
  }
  const auto shipped = shippedCasesFolder();
  if (!shipped) return passOn(shipped.error());
  if (auto added = addFolder(all, *shipped, "shipped", run); !added) return passOn(added.error());
  return all;
}

Result<Listing> listingOf(const CaseArguments& arguments, Run& run) {
  if (arguments.folder.empty()) return everyCase(run);
  std::error_code ignored;
  if (!std::filesystem::is_directory(arguments.folder, ignored))
    return failure(ErrorCode::notFound, say<"There is no folder '%1'; give a folder that holds case folders.">(arguments.folder),
                   {{"file", arguments.folder}});
  Listing all;
  if (auto added = addFolder(all, arguments.folder, {}, run); !added) return passOn(added.error());
  return all;
}

json jsonOf(const Listing& all, const std::string& folder) {
  json shown = {{"cases", json::array()}, {"problems", json::array()}, {"no_cases", json::array()}};
  if (!folder.empty()) shown["folder"] = folder;
  for (const auto& [each, kind, revision] : all.cases) {
    json row = {{"id", each.id},
                {"title", each.title},
                {"region", each.region},
                {"indication", each.indication},
                {"folder", each.folder.string()},
                {"prepared", !caseNeedsPreparation(each)}};
    if (!kind.empty()) row["kind"] = kind;
    if (revision > 0) row["revision"] = revision;
    shown["cases"].push_back(std::move(row));
  }
  for (const auto& problem : all.problems) shown["problems"].push_back(problemJson(problem));
  for (const auto& other : all.noCases) shown["no_cases"].push_back(other.string());
  return shown;
}

Result<int> listAll(const CaseArguments& arguments, Run& run) {
  const auto all = listingOf(arguments, run);
  if (!all) return passOn(all.error());
  run.report.quality = {{"cases", all->cases.size()}, {"problems", all->problems.size()}};
  if (arguments.asJson) {
    run.out() << dumped(jsonOf(*all, arguments.folder)) << "\n";
    return kDone;
  }
  std::size_t idWidth = 2, titleWidth = 5, regionWidth = 0;
  for (const auto& [each, kind, revision] : all->cases) {
    idWidth = std::max(idWidth, each.id.size());
    titleWidth = std::max(titleWidth, each.title.size());
    regionWidth = std::max(regionWidth, each.region.size());
  }
  const auto padded = [](const std::string& text, std::size_t width) {
    return printableLine(text) + std::string(width - text.size() + 2, ' ');
  };
  for (const auto& [each, kind, revision] : all->cases)
    run.out() << padded(each.id, idWidth) << padded(each.title, titleWidth)
              << (kind.empty() ? printableLine(each.region) : padded(each.region, regionWidth) + kind)
              << (revision > 0 ? ", revision " + std::to_string(revision) : "")
              << (caseNeedsPreparation(each) ? "  (not prepared yet)" : "") << "\n";
  if (all->cases.empty()) run.out() << "No cases in " << arguments.folder << ".\n";
  for (const auto& problem : all->problems) run.remark(problem.message);
  for (const auto& other : all->noCases) run.remark(say<"The folder '%1' is left out: it holds no case.json.">(other.filename().string()));
  return kDone;
}

Result<int> show(const CaseArguments& arguments, Run& run) {
  const auto found = findCase(arguments.chosen);
  if (!found) return passOn(found.error());
  if (auto kept = run.input(found->folder / "case.json"); !kept) return passOn(kept.error());
  if (arguments.asJson) {
    run.out() << dumped(manifestOf(*found)) << "\n";
    return kDone;
  }
  const auto line = [&](std::string name, const std::string& value) {
    if (value.empty()) return;
    name.resize(14, ' ');
    run.out() << name << printableLine(value) << "\n";
  };
  std::string patient = found->patient.name;
  if (!found->patient.sex.empty()) patient += (patient.empty() ? "" : ", ") + found->patient.sex;
  if (found->patient.age_years) patient += (patient.empty() ? "" : ", ") + std::to_string(*found->patient.age_years) + " years";
  std::string probes;
  for (const auto& probe : found->probes) probes += (probes.empty() ? "" : ", ") + probe;
  line("Id", found->id);
  line("Title", found->title);
  line("For trainees", found->titleForTrainees);
  line("Region", found->region);
  line("Patient", patient);
  line("History", found->history);
  line("Indication", found->indication);
  line("Diagnosis", found->diagnosis);
  for (const auto& [name, value] : expectedLines(*found, unitsOfPatient(*found, run))) line(name, value);
  line("Volume", volumeText(found->volume) + (caseNeedsPreparation(*found) ? " (not prepared yet)" : ""));
  line("Probes", probes.empty() ? "all" : probes);
  line("Mannequin", found->mannequin.empty() ? "default" : found->mannequin);
  line("Scene", sceneText(found->scene));
  line("Start pose", found->startPose ? "given" : "none");
  line("Expert pose", found->expertPose ? "given" : "none");
  line("Folder", found->folder.string());
  return kDone;
}

/// What plugins say about the sections that they keep in a case. They are loaded for it, where there is such a section.
std::vector<Error> problemsOfParts(const std::filesystem::path& place, Run& run) {
  std::error_code ignored;
  const auto text = readTextFile(std::filesystem::is_directory(place, ignored) ? place / "case.json" : place);
  if (!text) return {};
  const auto manifest = parseJson(*text, verbatim("case.json"));
  if (!manifest || !manifest->is_object() || !manifest->contains("parts")) return {};  // what else is wrong has been said
  door::HeadlessHost host(run.progress);
  door::PluginList plugins;
  plugins.openAll(host);
  return host.partProblems(*manifest);
}

Result<int> validate(const CaseArguments& arguments, Run& run) {
  std::error_code ignored;
  std::filesystem::path place = arguments.chosen;
  if (!std::filesystem::exists(place, ignored)) {
    const auto found = findCase(arguments.chosen);
    if (!found) return passOn(found.error());
    place = found->folder;
  }
  if (auto kept = run.input(place); !kept) return passOn(kept.error());
  auto problems = validateCase(place);
  for (auto& problem : problemsOfParts(place, run)) problems.push_back(std::move(problem));
  run.report.quality = {{"problems", problems.size()}};
  run.report.details["problems"] = json::array();
  for (const auto& problem : problems) run.report.details["problems"].push_back(problemJson(problem));
  if (arguments.asJson)
    run.out() << dumped({{"case", place.string()}, {"valid", problems.empty()}, {"problems", run.report.details["problems"]}}) << "\n";
  else
    for (const auto& problem : problems) run.out() << problem.sentence() << "\n";
  if (problems.empty()) {
    if (!arguments.asJson) run.say("The case is valid.");
    return kDone;
  }
  run.out() << std::flush;
  return run.answer({ErrorCode::badField,
                     say<"The case '%1' has %2; correct what is listed.">(arguments.chosen, counted(problems.size(), "problem")),
                     {{"case", place.string()}}});
}

Result<std::vector<Case>> casesToPrepare(const CaseArguments& arguments, Run& run) {
  if ((arguments.all || arguments.first) != arguments.several.empty() || (arguments.all && arguments.first))
    return failure(ErrorCode::badUsage, say<"Say which cases to prepare, or --all for the shipped ones, or --first for the one that is "
                                            "ready soonest; one of the three.">());
  std::vector<Case> cases;
  if (arguments.several.empty()) {
    const auto shipped = shippedCasesFolder();
    if (!shipped) return passOn(shipped.error());
    auto list = listCases(*shipped);
    for (const auto& problem : list.problems) run.remark(problem.message);
    cases = std::move(list.cases);
  }
  for (const auto& each : arguments.several) {
    auto found = findCase(each);
    if (!found) return passOn(found.error());
    cases.push_back(std::move(*found));
  }
  return cases;
}

/// A folder of each case's own: sweeps of different cases have the same names.
std::filesystem::path recordingsOf(const CaseArguments& arguments, const Case& each) {
  return std::filesystem::path(arguments.keepSweeps) / std::filesystem::absolute(each.folder / "case.json").parent_path().filename();
}

Result<void> announceRecordings(const CaseArguments& arguments, const std::vector<Case>& cases, Run& run) {
  if (auto made = run.outputs.announceFolder(arguments.keepSweeps); !made) return made;
  for (const Case& each : cases)
    if (auto announced = run.outputs.announceNewFolder(recordingsOf(arguments, each)); !announced) return announced;
  return {};
}

/// A case whose sweeps were recorded before has no recordings now.
void leaveOutEmpty(const CaseArguments& arguments, const std::vector<Case>& cases, Run& run) {
  std::error_code ignored;
  for (const Case& each : cases) std::filesystem::remove(run.outputs.staged(recordingsOf(arguments, each)), ignored);  // only an empty one
}

Result<int> prepare(const CaseArguments& arguments, Run& run) {
  auto cases = casesToPrepare(arguments, run);
  if (!cases) return passOn(cases.error());
  for (const auto& each : *cases)
    if (auto kept = run.input(each.folder / "case.json"); !kept) return passOn(kept.error());
  std::vector<Case> waiting = preparationOrder(*cases);
  // With one case ready there is something to scan.
  if (arguments.first && !waiting.empty()) waiting.resize(waiting.size() == cases->size() ? 1 : 0);
  std::vector<double> seconds;
  double total_s = 0.0;
  bool measured = true;
  for (const Case& each : waiting) {
    const auto estimate = estimatePreparation(each);
    if (!estimate) return passOn(estimate.error());
    seconds.push_back(std::max(estimate->seconds, 0.1));
    total_s += seconds.back();
    measured = measured && estimate->measured;
  }
  if (!waiting.empty())
    run.say("Preparing " + counted(waiting.size(), "case") + ", about " + rounded(total_s, 0) + " s" +
            (measured ? "." : " on the machine this was written on; the time left is corrected as it runs."));
  run.report.options = {{"threads", arguments.threads}, {"keep_sweeps", arguments.keepSweeps}};
  if (!arguments.keepSweeps.empty())
    if (auto announced = announceRecordings(arguments, waiting, run); !announced) return passOn(announced.error());
  double done_s = 0.0;
  for (std::size_t n = 0; n < waiting.size(); ++n) {
    PartOfProgress part(run.progress, done_s / total_s, (done_s + seconds[n]) / total_s);
    done_s += seconds[n];
    const StepClock clock(run.report, "prepare");
    const PreparationOptions options{
        .threads = arguments.threads,
        .keepSweeps = arguments.keepSweeps.empty() ? std::filesystem::path() : run.outputs.staged(recordingsOf(arguments, waiting[n]))};
    const auto made = prepareCase(waiting[n], options, part);
    if (!made) return passOn(made.error());
    for (const auto& note : *made) run.remark(note);
    run.say("Prepared " + waiting[n].title + ".");
    run.stopped = say<"Stopped as asked; of %1 %2 prepared and kept%3">(
        counted(waiting.size(), "case"), std::to_string(n + 1) + (n == 0 ? " is" : " are"),
        std::string(arguments.keepSweeps.empty() ? "." : ", and no recording was written."));
  }
  if (!arguments.keepSweeps.empty()) leaveOutEmpty(arguments, waiting, run);
  run.report.quality = {{"cases", cases->size()}, {"prepared_now", waiting.size()}, {"estimated_s", total_s}};
  return kDone;
}

}  // namespace

void addCase(CLI::App& root, Selection& selection) {
  auto& group = *root.add_subcommand("case", "Make, list, show, validate, prepare, publish and hand on training cases");
  group.require_subcommand(1);
  auto arguments = std::make_shared<CaseArguments>();

  auto& list = addCommand(group, selection, "list", "The cases there are: your own, published or imported ones, and the shipped ones",
                          {"case list", "case list my-cases --json"}, [arguments](Run& run) { return listAll(*arguments, run); });
  list.add_option("FOLDER", arguments->folder, "Only those of this folder, which holds case folders")->type_name("");
  list.add_flag("--json", arguments->asJson, "As JSON");

  auto& shown =
      addCommand(group, selection, "show", "What a case holds", {"case show upper-abdomen-gall-stone", "case show my-cases/knee --json"},
                 [arguments](Run& run) { return show(*arguments, run); });
  shown
      .add_option("CASE", arguments->chosen, "A case folder, its case.json, or the id of a case of your own, a published or a shipped one")
      ->required()
      ->type_name("");
  shown.add_flag("--json", arguments->asJson, "The manifest as JSON");

  auto& checked = addCommand(group, selection, "validate", "Every problem of a case, one a line; exit status 1 when there are any",
                             {"case validate my-cases/knee"}, [arguments](Run& run) { return validate(*arguments, run); });
  checked
      .add_option("CASE", arguments->chosen, "A case folder, its case.json, or the id of a case of your own, a published or a shipped one")
      ->required()
      ->type_name("");
  checked.add_flag("--json", arguments->asJson, "As JSON");

  auto& prepared = addCommand(group, selection, "prepare", "Make the volumes of cases that come as recipes, so that they open at once",
                              {"case prepare --all", "case prepare upper-abdomen-gall-stone --keep-sweeps recordings"},
                              [arguments](Run& run) { return prepare(*arguments, run); });
  prepared.add_option("CASES", arguments->several, "Case folders, case.json files or ids of cases")->type_name("");
  prepared.add_flag("--all", arguments->all, "All shipped cases, the one that is ready soonest first");
  prepared.add_flag("--first", arguments->first, "The shipped case that is ready soonest, unless one is ready already");
  prepared
      .add_option("--keep-sweeps", arguments->keepSweeps,
                  "Also write the recordings of the sweeps that are made now, DIR/CASE/NAME.igs.mha with NAME.xml; DIR/CASE must be new")
      ->type_name("DIR");
  addCount(prepared, "--threads", arguments->threads, 0, 1024, "Threads; 0: all cores; the voxels do not depend on it (0)");

  addCaseCard(group, selection);
  addCaseNew(group, selection);
  addCaseFiles(group, selection);
  addCaseLibrary(group, selection);
  addCaseWithdraw(group, selection);
  addCaseUnseal(group, selection);
}

}  // namespace ew::cli
