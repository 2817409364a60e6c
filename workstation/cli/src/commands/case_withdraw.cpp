#include "commands/case_withdraw.h"

#include "ew/library/case.h"
#include "ew/library/withdrawn.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;

struct WithdrawArguments {
  std::string chosen;
  std::string library;
};

/// A folder, its case.json, or what an id means in the library.
Result<fs::path> folderToWithdraw(const std::string& caseOrId, const fs::path& library) {
  std::error_code ignored;
  if (fs::is_directory(caseOrId, ignored)) return fs::path(caseOrId);
  if (const fs::path file = fs::absolute(caseOrId, ignored); file.filename() == "case.json" && fs::exists(file, ignored))
    return file.parent_path();
  return caseToWithdraw(caseOrId, library);
}

Result<int> withdraw(const WithdrawArguments& arguments, Run& run) {
  const fs::path library = arguments.library.empty() ? libraryFolder() : fs::path(arguments.library);
  const auto folder = folderToWithdraw(arguments.chosen, library);
  if (!folder) return passOn(folder.error());
  const auto taken = withdrawCase(*folder, library);
  if (!taken) return passOn(taken.error());
  run.isPublished = true;
  run.report.outputs.push_back(taken->folder.string());
  run.report.details["case"] = {{"id", taken->id}, {"from", taken->from.string()}, {"folder", taken->folder.string()}};
  run.say(taken->id + " was taken out of the library; it lies in " + taken->folder.string() + ". Moved back to " + taken->from.string() +
          ", it is there again.");
  return kDone;
}

}  // namespace

void addCaseWithdraw(CLI::App& group, Selection& selection) {
  auto arguments = std::make_shared<WithdrawArguments>();
  auto& app = addCommand(group, selection, "withdraw", "Take a case of your own, or all revisions of a published one, out of the library",
                         {"case withdraw liver-cyst", "case withdraw ~/EchoWeave/cases/first-try"},
                         [arguments](Run& run) { return withdraw(*arguments, run); });
  app.add_option("CASE", arguments->chosen,
                 "Its folder, or the id of a case that is your own or published; it is moved aside and not deleted")
      ->required()
      ->type_name("");
  app.add_option("--library", arguments->library, "Another library than your own")->type_name("DIR");
}

}  // namespace ew::cli
