#include "case_withdraw.h"

#include "ew/library/case.h"
#include "ew/library/instructor_log.h"
#include "ew/library/published.h"
#include "ew/library/withdrawn.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;

struct WithdrawArguments {
  std::string chosen;
  std::string library;
};

Result<int> withdraw(const WithdrawArguments& arguments, Run& run) {
  const fs::path library = arguments.library.empty() ? libraryFolder() : fs::path(arguments.library);
  fs::path folder = arguments.chosen;
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored)) {
    if (const auto published = latestPublished(library, arguments.chosen)) folder = published->folder;
  }
  const auto moved = withdrawCase(folder, library);
  if (!moved) return passOn(moved.error());
  run.isPublished = true;
  run.report.outputs.push_back(moved->string());
  if (auto logged = logChange(library, "case withdrawn", folder.filename().string(), {}, moved->string()); !logged)
    run.remark(logged.error().message);
  run.say("Taken out of the library; it lies in " + moved->string() + ". Moved back, it is there again.");
  return kDone;
}

}  // namespace

void addCaseWithdraw(CLI::App& group, Selection& selection) {
  auto arguments = std::make_shared<WithdrawArguments>();
  auto& app = addCommand(group, selection, "withdraw", "Take a case of your own, or all revisions of a published one, out of the library",
                         {"case withdraw liver-cyst", "case withdraw ~/EchoWeave/cases/first-try"},
                         [arguments](Run& run) { return withdraw(*arguments, run); });
  app.add_option("CASE", arguments->chosen, "Its folder, or the id of a published case; it is moved aside and not deleted")
      ->required()
      ->type_name("");
  app.add_option("--library", arguments->library, "Another library than your own")->type_name("DIR");
}

}  // namespace ew::cli
