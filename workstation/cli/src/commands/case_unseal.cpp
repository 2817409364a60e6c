#include <unistd.h>

#include "commands/case_library.h"
#include "ew/library/bundle.h"
#include "ew/library/instructor_log.h"
#include "ew/library/learning_progress.h"
#include "ew/library/sealed_answers.h"
#include "run/arguments.h"
#include "run/command.h"
#include "run/passphrase_input.h"
#include "run/volume_input.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;

struct UnsealArguments {
  std::string examination;
  std::string output;
  std::vector<std::string> attempts;
  std::string passphrase = "ask";
};

/// The examination's folder: given, or what a bundle holds, taken into a library of its own below `scratch`.
Result<fs::path> folderOfExamination(const std::string& named, const fs::path& scratch, Run& run) {
  std::error_code ignored;
  if (!fs::is_regular_file(named, ignored) || fs::path(named).filename() == "case.json") {
    const auto found = findCase(named);
    if (!found) return passOn(found.error());
    return found->folder;
  }
  if (auto kept = run.input(named); !kept) return passOn(kept.error());
  const auto imported = importBundle(named, scratch, {}, run.progress);
  if (!imported) return passOn(imported.error());
  return imported->folder;
}

/// What becomes the library for `assess`: the whole case, and attempts at it.
Result<OpenExamination> fill(const UnsealArguments& arguments, const fs::path& library, Run& run) {
  const auto passphrase = readPassphrase(arguments.passphrase, say<"Passphrase of your key:">());
  if (!passphrase) return passOn(passphrase.error());
  const auto key = openSecretKey(instructorKeyFile(), *passphrase);
  if (!key) return passOn(key.error());
  const fs::path scratch = library / ".examination";
  const auto examination = folderOfExamination(arguments.examination, scratch, run);
  if (!examination) return passOn(examination.error());
  std::error_code problem;
  fs::create_directories(library / "cases", problem);
  auto opened = openExamination(*examination, *key, library / "cases/opened", run.progress);
  if (!opened) return passOn(opened.error());
  fs::rename(library / "cases/opened", library / "cases" / opened->caseId, problem);
  fs::remove_all(scratch, problem);
  for (const std::string& attempt : arguments.attempts) {
    if (auto kept = run.input(fs::path(attempt) / "attempt.json"); !kept) return passOn(kept.error());
    if (auto taken = takeExamined(attempt, *opened, attemptsFolder(library), run.progress); !taken) return passOn(taken.error());
  }
  return opened;
}

Result<int> unseal(const UnsealArguments& arguments, Run& run) {
  if (auto announced = run.outputs.announceNewFolder(arguments.output); !announced) return passOn(announced.error());
  run.report.outputs.push_back(arguments.output);
  const auto opened = fill(arguments, run.outputs.staged(arguments.output), run);
  if (!opened) return passOn(opened.error());
  run.report.details["case"] = opened->caseId;
  run.report.quality = {{"attempts", arguments.attempts.size()}};
  if (auto logged = logChange(libraryFolder(), "answers opened", opened->examinationId, {}, opened->sealedSha256); !logged)
    return passOn(logged.error());
  run.say("Opened the answers of " + opened->examinationId + ": the case " + opened->caseId + ", with " +
          counted(arguments.attempts.size(), "attempt") + ".");
  run.say("Score them with: echoweave assess --library " + arguments.output);
  return kDone;
}

}  // namespace

void addCaseUnseal(CLI::App& group, Selection& selection) {
  auto arguments = std::make_shared<UnsealArguments>();
  auto& app =
      addCommand(group, selection, "unseal", "Open the sealed answers of an examination with your key, and take attempts to be scored",
                 {"case unseal friday.ewcase -o friday --attempts handed-in/*", "assess --library friday"},
                 [arguments](Run& run) { return unseal(*arguments, run); });
  app.add_option("EXAMINATION", arguments->examination, "The bundle as you exported it, or its folder; never one that came with an attempt")
      ->required()
      ->type_name("");
  app.add_option("-o,--output", arguments->output, "A new folder, a library of its own: the whole case, and the attempts as attempts at it")
      ->required()
      ->type_name("DIR");
  app.add_option("--attempts", arguments->attempts, "Folders of attempts that were handed in")->type_name("ATTEMPT");
  app.add_option("--passphrase", arguments->passphrase, "Where the key's passphrase comes from (ask)")->type_name(kPassphraseSource);
}

}  // namespace ew::cli
