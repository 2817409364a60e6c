#include "commands/case_library.h"

#include <algorithm>
#include <map>
#include <ostream>

#include "ew/core/ending.h"
#include "ew/core/numbers.h"
#include "ew/core/word_table.h"
#include "ew/library/bundle.h"
#include "ew/library/instructor_log.h"
#include "ew/library/learning_progress.h"
#include "ew/library/preparation.h"
#include "ew/library/publishing.h"
#include "ew/library/sealed_answers.h"
#include "run/arguments.h"
#include "run/volume_input.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

struct LibraryArguments {
  std::string chosen;
  std::vector<std::string> several;
  std::string output;
  std::string library;
  bool isExamination = false;
  std::vector<std::string> forWhom;
  std::string examinationId;
};

fs::path libraryOf(const LibraryArguments& arguments) { return arguments.library.empty() ? libraryFolder() : fs::path(arguments.library); }

bool isBundle(const fs::path& named) {
  std::error_code ignored;
  return hasEnding(named, kBundleEnding) || (fs::is_regular_file(named, ignored) && named.filename() != "case.json");
}

/// The folder of a case: as findCase, the author's own first, but a case that cannot be opened has one, too.
Result<fs::path> folderOfCase(const std::string& caseOrId, Run& run) {
  std::error_code ignored;
  if (fs::is_directory(caseOrId, ignored)) return fs::path(caseOrId);
  if (auto isCase = expectNoBundle(caseOrId); !isCase) return passOn(isCase.error());
  if (fs::exists(caseOrId, ignored)) return fs::absolute(caseOrId, ignored).parent_path();
  if (const auto own = ownCases(caseOrId, libraryFolder()); !own.empty()) return own.front();
  const auto taken = takenPublished(libraryFolder(), caseOrId);
  if (const auto published = latestPublished(libraryFolder(), caseOrId)) {
    if (taken.back().revision != published->revision)
      run.remark(say<"Revision %1 of '%2' is not complete, so revision %3 is taken; 'echoweave case verify %2' says what is wrong.">(
          taken.back().revision, caseOrId, published->revision));
    return published->folder;
  }
  const auto found = findCase(caseOrId);
  if (!found) return passOn(found.error());
  return found->folder;
}

/// Of an id that an author's own case and a published one share: which of them is exported, and how to export the other.
void tellWhichIsExported(const std::string& caseOrId, const fs::path& folder, Run& run) {
  std::error_code ignored;
  if (fs::exists(caseOrId, ignored)) return;
  const auto published = latestPublished(libraryFolder(), caseOrId);
  if (!published || published->folder == folder) return;
  run.remark(say<"'%1' means your own case in '%2'; to export revision %3, which is published, name its folder '%4'.">(
      caseOrId, folder, published->revision, published->folder));
}

/// Every file of the case is read: no output may lie over one.
Result<void> readsCase(const fs::path& folder, Run& run) {
  if (auto kept = run.input(folder / "case.json"); !kept) return kept;
  const auto files = filesOfCase(folder);
  if (!files) return {};  // whoever reads them says so
  for (const FileSum& each : *files)
    if (auto kept = run.outputs.protect(folder / each.path); !kept) return kept;
  return {};
}

std::string sizeText(const std::vector<FileSum>& files) {
  std::uint64_t bytes = 0;
  for (const FileSum& each : files) bytes += each.size_bytes;
  return counted(files.size(), "file") + ", " + rounded(static_cast<double>(bytes) / 1048576.0, 1) + " MiB";
}

/// @param to where the bundle is written
Result<Examination> exportAsExamination(const fs::path& folder, const LibraryArguments& arguments, const fs::path& to, Run& run) {
  ExaminationOptions options{.instructors = {}, .id = arguments.examinationId, .preparation = {}};
  for (const std::string& file : arguments.forWhom) {
    if (auto kept = run.input(file); !kept) return passOn(kept.error());
    const auto key = readPublicKey(file);
    if (!key) return passOn(key.error());
    options.instructors.push_back(*key);
  }
  if (const auto opened = loadCase(folder); opened && caseNeedsPreparation(*opened))
    if (const auto estimate = estimatePreparation(*opened))
      run.remark(say<"The volume of the case is made first, in about %1 s; an examination carries it instead of the patient's recipe.">(
          numeral(rounded(estimate->seconds, 0))));
  const StepClock clock(run.report, "export");
  auto made = exportExamination(folder, to, options, run.progress);
  if (made)
    for (const Message& note : made->notes) run.remark(note);
  return made;
}

void tellExport(const BundleHeader& header, const std::optional<Examination>& examination, const LibraryArguments& arguments, Run& run) {
  run.say("Exported " + header.id + (header.revision > 0 ? ", revision " + std::to_string(header.revision) : "") + " (" +
          sizeText(header.files) + ") to " + arguments.output + ".");
  if (!examination) {
    const auto isSealed = [](const FileSum& each) { return each.path == kSealedName; };
    if (std::any_of(header.files.begin(), header.files.end(), isSealed)) {
      run.say("An examination, as it was made: its answers stay sealed for the instructors whose keys it was made for.");
      return;
    }
    run.say(
        "For practice: whoever opens the bundle can read the answers in its files. For an examination add --examination --for KEY.pub.");
    return;
  }
  run.report.details["examination"] = {
      {"id", examination->id}, {"sealed_sha256", examination->sealedSha256}, {"steps", examination->steps}};
  run.say("An examination: " + counted(examination->steps, "step") + ", answers sealed. Keep this bundle: attempts at " + examination->id +
          " are judged with it alone.");
  if (examination->leftOut > 0)
    run.say("Left out: " + counted(examination->leftOut, "step") + " that show the expert or come after the first question.");
  if (auto logged = logChange(libraryFolder(), "examination made", examination->id, {}, examination->sealedSha256); !logged)
    run.remark(logged.error().message);
}

Result<int> exportCase(const LibraryArguments& arguments, Run& run) {
  if (arguments.isExamination != !arguments.forWhom.empty())
    return failure(ErrorCode::badUsage,
                   say<"--examination and --for go together: answers are sealed for somebody who can judge with them.">());
  const auto folder = folderOfCase(arguments.chosen, run);
  if (!folder) return passOn(folder.error());
  tellWhichIsExported(arguments.chosen, *folder, run);
  if (auto kept = readsCase(*folder, run); !kept) return passOn(kept.error());
  if (auto announced = run.output(arguments.output, kBundleEnding); !announced) return passOn(announced.error());
  const fs::path to = run.outputs.staged(arguments.output);
  std::optional<Examination> examination;
  Result<BundleHeader> header = BundleHeader();
  if (arguments.isExamination) {
    auto made = exportAsExamination(*folder, arguments, to, run);
    if (!made) return passOn(made.error());
    header = made->bundle;
    examination = std::move(*made);
  } else {
    const StepClock clock(run.report, "export");
    header = exportBundle(*folder, to, run.progress);
  }
  if (!header) return passOn(header.error());
  std::error_code ignored;
  const auto bytes = fs::file_size(run.outputs.staged(arguments.output), ignored);
  run.report.quality = {{"files", header->files.size()}, {"revision", header->revision}, {"bundle_bytes", bytes}};
  tellExport(*header, examination, arguments, run);
  return kDone;
}

void tellPublished(const CaseRevision& published, const std::string& what, const std::string& nothing, Run& run) {
  run.isPublished = true;
  run.report.outputs.push_back(published.folder.string());
  run.report.quality = {{"revision", published.revision}, {"was_there", published.wasThere}};
  run.report.details["case"] = {
      {"id", published.id}, {"revision", published.revision}, {"folder", published.folder.string()}, {"was_there", published.wasThere}};
  run.say((published.wasThere ? nothing : what) + " " + published.id + ", revision " + std::to_string(published.revision) + ": " +
          published.folder.string());
}

Result<int> importCase(const LibraryArguments& arguments, Run& run) {
  if (auto kept = run.input(arguments.chosen); !kept) return passOn(kept.error());
  const auto imported = [&] {
    const StepClock clock(run.report, "import");
    return importBundle(arguments.chosen, libraryOf(arguments), {}, run.progress);
  }();
  if (!imported) return passOn(imported.error());
  tellPublished(*imported, "Imported", "The library has this already, and nothing was done:", run);
  return kDone;
}

/// A case beside the one in `folder`, the program's own, or one that is published.
std::optional<Case> caseOf(const std::string& id, const fs::path& folder) {
  if (auto beside = loadCase(fs::absolute(folder).lexically_normal().parent_path() / id); beside && beside->id == id)
    return *std::move(beside);
  if (auto found = findCase(id)) return *std::move(found);
  const auto published = latestPublished(libraryFolder(), id);
  if (!published) return std::nullopt;
  auto read = loadCase(published->folder);
  return read ? std::optional(*std::move(read)) : std::nullopt;
}

/// Cases that lessons refer to, by id; read when the first is asked for.
CaseById caseByIdFor(const Case& opened) {
  auto known = std::make_shared<std::map<std::string, std::optional<Case>>>();
  return [known, folder = opened.folder](const std::string& id) -> const Case* {
    const auto [at, isNew] = known->try_emplace(id);
    if (isNew) at->second = caseOf(id, folder);
    return at->second ? &*at->second : nullptr;
  };
}

constexpr WordTable<CheckItem::State, 3> kCheckItemStateWords{
    {{"done", CheckItem::State::done}, {"look at", CheckItem::State::warning}, {"missing", CheckItem::State::missing}}};
const char* wordOf(CheckItem::State state) { return wordIn(kCheckItemStateWords, state); }

/// The list an author goes through; what is done goes into the report alone.
void tellList(const std::vector<CheckItem>& list, Run& run) {
  json items = json::array();
  for (const CheckItem& each : list) {
    items.push_back({{"state", wordOf(each.state)}, {"what", each.what.english()}, {"field", each.field}});
    if (each.state != CheckItem::State::done && !run.quiet()) run.out() << wordOf(each.state) << ": " << each.what.english() << "\n";
  }
  run.out() << std::flush;
  run.report.details["check_list"] = std::move(items);
}

Result<int> publish(const LibraryArguments& arguments, Run& run) {
  const auto folder = folderOfCase(arguments.chosen, run);
  if (!folder) return passOn(folder.error());
  if (auto kept = readsCase(*folder, run); !kept) return passOn(kept.error());
  const char* nothing = "Nothing has changed since, and nothing was done:";
  if (const auto opened = loadCase(*folder)) {
    if (opened->sealed) nothing = "An examination is published as it was made, and was published before, so nothing was done:";
    const auto list = [&] {
      const StepClock clock(run.report, "check");
      return publishingList(*opened, {.caseById = caseByIdFor(*opened)});
    }();
    if (!list) return passOn(list.error());
    tellList(*list, run);
  }
  const auto published = [&] {
    const StepClock clock(run.report, "publish");
    return publishCase(*folder, libraryOf(arguments), run.progress);
  }();
  if (!published) return passOn(published.error());
  tellPublished(*published, "Published", nothing, run);
  return kDone;
}

json rowOf(const std::string& name, const CaseCheck& check) {
  json problems = json::array();
  for (const Error& problem : check.problems) {
    json row = {{"code", nameOf(problem.code)}, {"sentence", problem.sentence()}};
    for (const auto& [key, value] : problem.context)
      if (key == "file") row["file"] = value;
    problems.push_back(std::move(row));
  }
  return {{"name", name}, {"files", check.files}, {"bytes", check.bytes}, {"has_sums", check.hasSums}, {"problems", problems}};
}

/// One thing to check, and how it is called.
struct Checked {
  std::string name;
  fs::path folder;  ///< empty: a bundle of that name
};

/// What a word stands for: a bundle, a folder, or every revision of a published case, also those that are no longer complete.
Result<std::vector<Checked>> checkedBy(const std::string& named, Run& run) {
  std::error_code ignored;
  std::vector<Checked> all;
  if (!fs::exists(named, ignored))
    for (const CaseRevision& each : takenPublished(libraryFolder(), named))
      all.push_back({named + ", revision " + std::to_string(each.revision), each.folder});
  if (!all.empty()) return all;
  if (isBundle(named)) return std::vector<Checked>{{named, {}}};
  auto folder = folderOfCase(named, run);
  if (!folder) return passOn(folder.error());
  return std::vector<Checked>{{named, *std::move(folder)}};
}

/// Checked to its last byte. What is wrong with it is the answer; that it is not there or cannot be read is an error.
Result<CaseCheck> checkOne(const Checked& wanted, Run& run, Progress& progress) {
  if (!wanted.folder.empty()) {
    if (auto kept = readsCase(wanted.folder, run); !kept) return passOn(kept.error());
    return verifyCase(wanted.folder, progress);
  }
  const std::string& named = wanted.name;
  if (auto kept = run.input(named); !kept) return passOn(kept.error());
  const auto header = verifyBundle(named, {}, progress);
  CaseCheck check{.hasSums = true, .files = 0, .bytes = 0, .problems = {}};
  if (header) {
    check.files = header->files.size();
    for (const FileSum& each : header->files) check.bytes += each.size_bytes;
    return check;
  }
  const ErrorCode code = header.error().code;
  if (code == ErrorCode::cancelled || code == ErrorCode::notFound || code == ErrorCode::notReadable) return passOn(header.error());
  check.problems.push_back(header.error());
  return check;
}

Result<int> verify(const LibraryArguments& arguments, Run& run) {
  run.stopped = say<"Stopped as asked before everything was checked.">();
  std::size_t problems = 0;
  run.report.details["cases"] = json::array();
  std::vector<Checked> wanted;
  for (const std::string& word : arguments.several) {
    auto meant = checkedBy(word, run);
    if (!meant) return passOn(meant.error());
    std::move(meant->begin(), meant->end(), std::back_inserter(wanted));
  }
  for (std::size_t n = 0; n < wanted.size(); ++n) {
    const std::string& named = wanted[n].name;
    const auto all = static_cast<double>(wanted.size());
    PartOfProgress part(run.progress, static_cast<double>(n) / all, static_cast<double>(n + 1) / all);
    const StepClock clock(run.report, "verify");
    const auto check = checkOne(wanted[n], run, part);
    if (!check) return passOn(check.error());
    run.report.details["cases"].push_back(rowOf(named, *check));
    for (const Error& problem : check->problems) run.out() << named << ": " << problem.sentence() << "\n";
    problems += check->problems.size();
    if (check->problems.empty())
      run.say(named + ": " + counted(check->files, "file") +
              (check->hasSums ? ", all as they were kept." : ", and the case can be opened."));
    if (!check->hasSums && check->problems.empty())
      run.remark(say<"'%1' was not published: it has no sums, so nobody can tell whether its files have changed.">(named));
  }
  run.report.quality = {{"checked", wanted.size()}, {"problems", problems}};
  run.out() << std::flush;
  if (problems == 0) return kDone;
  return run.answer({ErrorCode::badField, say<"%1 found; what is listed says what to do.">(counted(problems, "problem")), {}});
}

}  // namespace

void addCaseLibrary(CLI::App& group, Selection& selection) {
  auto arguments = std::make_shared<LibraryArguments>();
  constexpr const char* kCaseText = "A case folder, its case.json, or the id of a case: your own, else published, else shipped";
  constexpr const char* kLibraryText = "The library's folder (ECHOWEAVE_LIBRARY, else ~/EchoWeave)";

  auto& exported =
      addCommand(group, selection, "export", "Write a case into one file that another workstation can import",
                 {"case export my-cases/knee -o knee.ewcase", "case export my-cases/knee -o friday.ewcase --examination --for anna.pub"},
                 [arguments](Run& run) { return exportCase(*arguments, run); });
  exported.add_option("CASE", arguments->chosen, kCaseText)->required()->type_name("");
  exported.add_option("-o,--output", arguments->output, "The bundle to write, X.ewcase")->required()->type_name("X.ewcase");

  exported.add_flag("--examination", arguments->isExamination,
                    "Only what trainees may read; the answers are sealed, and attempts are judged afterwards with the instructor's key");
  exported.add_option("--for", arguments->forWhom, "Public keys of the instructors who judge ('key show'); several are possible")
      ->type_name("KEY.pub");
  exported.add_option("--examination-id", arguments->examinationId, "Its id (a random one: a case's own often names the finding)")
      ->type_name("ID");

  auto& imported = addCommand(group, selection, "import", "Take a bundle into the library, checked to its last byte, or not at all",
                              {"case import knee.ewcase", "case import knee.ewcase --library /srv/echoweave"},
                              [arguments](Run& run) { return importCase(*arguments, run); });
  imported.add_option("BUNDLE", arguments->chosen, "A file that `case export` wrote")->required()->type_name("X.ewcase");
  imported.add_option("--library", arguments->library, kLibraryText)->type_name("DIR");

  auto& published = addCommand(group, selection, "publish", "Make the next revision of a case: a copy that never changes again",
                               {"case publish my-cases/knee"}, [arguments](Run& run) { return publish(*arguments, run); });
  published.add_option("CASE", arguments->chosen, kCaseText)->required()->type_name("");
  published.add_option("--library", arguments->library, kLibraryText)->type_name("DIR");

  auto& verified = addCommand(group, selection, "verify", "Read every byte of cases and bundles; exit status 1 when something is wrong",
                              {"case verify knee.ewcase", "case verify ~/EchoWeave/published/knee/3 my-cases/knee"},
                              [arguments](Run& run) { return verify(*arguments, run); });
  verified.add_option("CASES", arguments->several, "Bundles, case folders, or ids of cases; of a published one every revision is read")
      ->required()
      ->type_name("");
}

}  // namespace ew::cli
