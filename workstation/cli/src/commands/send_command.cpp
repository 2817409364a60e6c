#include <algorithm>

#include "ew/export/outbox.h"
#include "run/arguments.h"
#include "run/command.h"

namespace ew::cli {
namespace {

struct SendArguments {
  std::vector<std::string> files;
  std::string outbox;
  DicomArchive archive;
  int rounds = 8;
  bool retriesRefused = false;
};

Result<int> send(const SendArguments& arguments, Run& run) {
  run.isPublished = true;  // what was taken stays in the outbox, whatever happens next
  run.stopped = {};
  for (const std::string& file : arguments.files)
    if (auto kept = run.input(file); !kept) return passOn(kept.error());
  auto outbox = DicomOutbox::open(arguments.outbox);
  if (!outbox) return passOn(outbox.error());
  if (outbox->damage()) run.remark(*outbox->damage());
  std::size_t known = 0;
  for (const std::string& file : arguments.files) {
    const auto isNew = outbox->add(file);
    if (!isNew) return passOn(isNew.error());
    known += *isNew ? 0 : 1;
  }
  if (known > 0) run.remark(say<"In the outbox already, or sent before, and not sent twice: %1.">(known));
  if (arguments.retriesRefused)
    if (auto waits = outbox->retryRefused(); !waits) return passOn(waits.error());

  RetryOptions options;
  options.mostRounds = arguments.rounds;
  const auto sent = sendOutbox(*outbox, arguments.archive, options, run.progress);
  if (!sent) return passOn(sent.error());
  for (const OutboxEntry& entry : outbox->entries()) {
    run.report.details["objects"].push_back({{"instance_uid", entry.id},
                                             {"class_uid", aboutOf(entry, kObjectClass)},
                                             {"status", std::string(wordOf(entry.status))},
                                             {"attempts", entry.attempts},
                                             {"problem", entry.problem}});
    if (entry.status == OutboxStatus::refused) run.remark(say<"The archive refuses %1: %2.">(entry.id, verbatim(entry.problem)));
  }
  run.report.options = {{"host", arguments.archive.host},
                        {"port", arguments.archive.port},
                        {"archive", arguments.archive.aeTitle},
                        {"own_title", arguments.archive.ownAeTitle},
                        {"rounds", arguments.rounds}};
  run.report.quality = {{"verified", sent->verified},
                        {"accepted", sent->accepted},
                        {"refused", sent->refused},
                        {"left", sent->left},
                        {"rounds", sent->rounds}};
  run.progress.clear();
  if (sent->accepted > 0)
    run.say("The archive said that it stored " + counted(sent->accepted, "object") +
            "; it cannot be asked what it has, so this counts as delivered.");
  if (sent->rounds == 0)
    run.say("Nothing was waiting in the outbox, so nothing was sent.");
  else if (sent->verified > 0)
    run.say("The archive has " + counted(sent->verified, "object") + " now.");
  const std::size_t refused = outbox->count(OutboxStatus::refused);
  if (sent->left == 0 && refused == 0) return kDone;
  if (sent->left == 0)
    return run.answer(
        {ErrorCode::notWritable,
         say<"Refused by the archive: %1, see the notes. What was refused stays in the outbox; send with --retry when the archive "
             "would take it.">(refused),
         {}});
  return run.answer({ErrorCode::notWritable,
                     say<"Not in the archive yet, but safe in the outbox: %1. Give the command again, without files, to go on. %2">(
                         sent->left, sent->problem),
                     {}});
}

}  // namespace

void addSend(CLI::App& root, Selection& selection) {
  auto arguments = std::make_shared<SendArguments>();
  auto& app = addCommand(root, selection, "send", "Send DICOM files to an archive, through an outbox that survives crashes and networks",
                         {"send clip.dcm report.dcm --outbox outbox --host archive.example --port 4242 --archive ORTHANC",
                          "send --outbox outbox --host archive.example --port 4242 --archive ORTHANC --rounds 20"},
                         [arguments](Run& run) { return send(*arguments, run); });
  app.add_option("FILES", arguments->files, "DICOM files, as the window, 'replay' and 'measure' write them; none: what the outbox has")
      ->type_name("");
  app.add_option("--outbox", arguments->outbox, "The folder where copies wait until the archive says that it has them; made when missing")
      ->required()
      ->type_name("DIR");
  app.add_option("--host", arguments->archive.host, "Name or address of the archive's machine")->required()->type_name("HOST");
  addCount(app, "--port", arguments->archive.port, 1, 65535, "Port of the archive (104)");
  app.add_option("--archive", arguments->archive.aeTitle, "The archive's application entity title, up to 16 letters")
      ->required()
      ->type_name("TITLE");
  app.add_option("--own-title", arguments->archive.ownAeTitle, "The title under which the archive knows this program (ECHOWEAVE)")
      ->type_name("TITLE");
  addNumber(app, "--timeout", arguments->archive.timeout_s, {1.0, 600.0}, "Seconds until an archive that is silent counts as away (30)");
  addCount(app, "--rounds", arguments->rounds, 1, 1000,
           "Connections that are tried, with 1 s in between, then twice as long each time, at most 300 s (8)");
  app.add_flag("--retry", arguments->retriesRefused, "Also send what the archive refused before");
}

}  // namespace ew::cli
