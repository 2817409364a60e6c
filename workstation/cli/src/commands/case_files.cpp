#include "commands/case_files.h"

#include <algorithm>
#include <ostream>

#include "ew/core/printable.h"
#include "ew/library/case_contents.h"
#include "run/arguments.h"
#include "run/volume_input.h"

namespace ew::cli {
namespace {

using nlohmann::json;

constexpr const char* kWhichCase = "A case folder, its case.json, or the id of a case of your own, a published or a shipped one";

struct FilesArguments {
  std::string chosen;
  std::vector<std::string> files;
  bool asJson = false;
};

std::string sizeOfFile(std::uint64_t bytes) {
  if (bytes < 1024) return std::to_string(bytes) + " B";
  const double kib = static_cast<double>(bytes) / 1024.0;
  return kib < 1024.0 ? rounded(kib, 1) + " KiB" : rounded(kib / 1024.0, 1) + " MiB";
}

std::string useOf(const CaseFileUse& file) { return file.usedBy.empty() ? "used by nothing" : joined(file.usedBy, ", ").english(); }

std::string inQuotes(const std::vector<std::string>& paths) {
  std::string text;
  for (const std::string& each : paths) text += (text.empty() ? "'" : ", '") + each + "'";
  return text;
}

json jsonOf(const Case& opened, const std::vector<CaseFileUse>& files, const std::vector<WithdrawnFiles>& aside) {
  json made = {{"case", opened.id}, {"folder", opened.folder.string()}, {"files", json::array()}, {"withdrawn", json::array()}};
  for (const CaseFileUse& each : files) {
    json row = {{"path", each.path}, {"bytes", each.size_bytes}, {"used_by", json::array()}};
    for (const Message& by : each.usedBy) row["used_by"].push_back(by.english());
    made["files"].push_back(std::move(row));
  }
  for (const WithdrawnFiles& each : aside) made["withdrawn"].push_back({{"folder", each.folder.string()}, {"files", each.paths}});
  return made;
}

Result<int> list(const FilesArguments& arguments, Run& run) {
  const auto opened = findCase(arguments.chosen);
  if (!opened) return passOn(opened.error());
  if (auto kept = run.input(opened->folder / "case.json"); !kept) return passOn(kept.error());
  const auto files = fileUsesOf(*opened);
  if (!files) return passOn(files.error());
  const auto aside = withdrawnFilesOf(opened->folder);
  const auto unused = std::count_if(files->begin(), files->end(), [](const CaseFileUse& each) { return each.usedBy.empty(); });
  const json told = jsonOf(*opened, *files, aside);
  run.report.quality = {{"files", files->size()}, {"unused", unused}};
  run.report.details["files"] = told["files"];
  if (arguments.asJson) {
    run.out() << told.dump(2, ' ', false, json::error_handler_t::replace) << "\n";
    return kDone;
  }
  std::size_t pathWidth = 0, sizeWidth = 0;
  for (const CaseFileUse& each : *files) {
    pathWidth = std::max(pathWidth, printableLine(each.path).size());
    sizeWidth = std::max(sizeWidth, sizeOfFile(each.size_bytes).size());
  }
  for (const CaseFileUse& each : *files) {
    const std::string path = printableLine(each.path), size = sizeOfFile(each.size_bytes);
    run.out() << path << std::string(pathWidth - path.size() + 2, ' ') << std::string(sizeWidth - size.size(), ' ') << size << "  "
              << printableLine(useOf(each)) << "\n";
  }
  for (const WithdrawnFiles& each : aside)
    run.remark(say<"%1 taken out before and not handed on: '%2'.">(counted(each.paths.size(), "file"), each.folder));
  return kDone;
}

Result<int> withdraw(const FilesArguments& arguments, Run& run) {
  const auto opened = findCase(arguments.chosen);
  if (!opened) return passOn(opened.error());
  const auto taken = withdrawFiles(*opened, arguments.files, CaseEditor::nobody);
  if (!taken) return passOn(taken.error());
  run.isPublished = true;
  run.report.outputs.push_back(taken->folder.string());
  run.report.details["withdrawn"] = {{"case", opened->id}, {"folder", taken->folder.string()}, {"files", taken->paths}};
  run.say(counted(taken->paths.size(), "file") + " of " + opened->id + " taken out, to " + taken->folder.string() +
          "; no longer handed on with the case. Moved back to " + taken->caseFolder.string() + ", it is there again.");
  for (const auto& [revision, files] : stillPublished(*taken, opened->id, libraryFolder()))
    run.remark(say<"Revision %1 of '%2', which was published before, holds %3 all the same.">(revision, opened->id, inQuotes(files)));
  return kDone;
}

}  // namespace

void addCaseFiles(CLI::App& group, Selection& selection) {
  auto arguments = std::make_shared<FilesArguments>();
  auto& listed =
      addCommand(group, selection, "files", "The files of a case's folder, their sizes, and what uses each",
                 {"case files my-cases/knee", "case files knee --json"}, [arguments](Run& run) { return list(*arguments, run); });
  listed.add_option("CASE", arguments->chosen, kWhichCase)->required()->type_name("");
  listed.add_flag("--json", arguments->asJson, "As JSON");

  auto& withdrawn = addCommand(group, selection, "withdraw-file",
                               "Take files out of a case of your own that nothing uses, so that they are not handed on with it",
                               {"case withdraw-file my-cases/knee volumes/other-patient.mha media/old.png"},
                               [arguments](Run& run) { return withdraw(*arguments, run); });
  withdrawn.add_option("CASE", arguments->chosen, "A case of your own: its folder, its case.json or its id")->required()->type_name("");
  withdrawn
      .add_option("FILES", arguments->files,
                  "Paths in its folder, as `case files` lists them; they are moved aside and not deleted, all or none")
      ->required()
      ->type_name("");
}

}  // namespace ew::cli
