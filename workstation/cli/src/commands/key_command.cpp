#include <ostream>

#include "ew/library/access.h"
#include "ew/library/instructor_key.h"
#include "ew/library/instructor_log.h"
#include "ew/library/timestamp.h"
#include "run/command.h"
#include "run/passphrase_input.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;

struct KeyArguments {
  std::string passphrase = "ask";
  std::string output;
};

Result<int> makeKey(const KeyArguments& arguments, Run& run) {
  const fs::path file = instructorKeyFile();
  const auto passphrase = readNewPassphrase(arguments.passphrase, say<"A passphrase for the new key:">());
  if (!passphrase) return passOn(passphrase.error());
  const auto key = SecretKey::make();
  if (!key) return passOn(key.error());
  if (auto kept = keepSecretKey(*key, *passphrase, file); !kept) return passOn(kept.error());
  run.isPublished = true;
  run.report.outputs.push_back(file.string());
  run.report.details["public"] = textOf(key->publicKey());
  if (auto logged = logChange(libraryFolder(), "key made", shortNameOf(key->publicKey())); !logged) run.remark(logged.error().message);
  run.say("Made the key " + shortNameOf(key->publicKey()) + ": " + file.string());
  run.say("Keep a copy of that file and remember its passphrase: without them no examination made for it can be judged.");
  run.say(textOf(key->publicKey()));
  return kDone;
}

Result<int> showKey(const KeyArguments& arguments, Run& run) {
  const auto key = publicKeyKeptIn(instructorKeyFile());
  if (!key) return passOn(key.error());
  run.report.details["public"] = textOf(*key);
  if (arguments.output.empty()) {
    run.out() << textOf(*key) << "\n";
    return kDone;
  }
  if (auto announced = run.output(arguments.output); !announced) return passOn(announced.error());
  if (auto written = writePublicKey(*key, run.outputs.staged(arguments.output)); !written) return passOn(written.error());
  run.say("Wrote the public key " + shortNameOf(*key) + " to " + arguments.output + ".");
  return kDone;
}

Result<int> lock(const KeyArguments& arguments, Run& run) {
  AccessPolicy policy = AccessPolicy::of(libraryFolder());
  if (policy.isLocked()) {
    run.say("The library is locked for trainees already.");
    return kDone;
  }
  const auto passphrase = readNewPassphrase(arguments.passphrase, say<"A passphrase for the lock:">());
  if (!passphrase) return passOn(passphrase.error());
  if (auto set = setLock(policy, *passphrase); !set) return passOn(set.error());
  run.isPublished = true;
  run.say("Locked for trainees: " + policy.library().string());
  return kDone;
}

Result<int> unlock(const KeyArguments& arguments, Run& run) {
  AccessPolicy policy = AccessPolicy::of(libraryFolder());
  if (!policy.hasLock()) {
    run.say("The library has no lock.");
    return kDone;
  }
  const auto passphrase = readPassphrase(arguments.passphrase, say<"Instructor's passphrase:">());
  if (!passphrase) return passOn(passphrase.error());
  if (auto opened = policy.unlock(*passphrase); !opened) return passOn(opened.error());
  if (auto removed = removeLock(policy); !removed) return passOn(removed.error());
  run.isPublished = true;
  run.say("The lock is gone: " + policy.library().string());
  return kDone;
}

Result<int> status(Run& run) {
  const bool locked = AccessPolicy::of(libraryFolder()).hasLock();
  run.out() << (locked ? "Locked for trainees: " : "No lock: ") << libraryFolder().string() << "\n";
  run.report.quality = {{"locked", locked}};
  return kDone;
}

Result<int> changes(Run& run) {
  const auto log = readInstructorLog(libraryFolder());
  if (!log) return passOn(log.error());
  for (const InstructorChange& each : log->changes) {
    run.out() << timestampText(each.at) << "  " << each.who << "  " << each.what;
    if (!each.of.empty()) run.out() << "  " << each.of;
    if (!each.before.is_null() || !each.after.is_null()) run.out() << "  " << each.before.dump() << " -> " << each.after.dump();
    run.out() << "\n";
  }
  run.report.quality = {{"changes", log->changes.size()}, {"damaged", log->damaged}};
  if (log->damaged > 0) run.remark(say<"Lines that cannot be read, torn by a crash or edited: %1.">(log->damaged));
  return kDone;
}

}  // namespace

void addKey(CLI::App& root, Selection& selection) {
  auto& group = *root.add_subcommand("key", "An instructor's key, for which answers of examinations are sealed");
  group.require_subcommand(1);
  auto arguments = std::make_shared<KeyArguments>();
  auto& made = addCommand(group, selection, "new", "Make the key of this account; its secret half is kept under a passphrase", {"key new"},
                          [arguments](Run& run) { return makeKey(*arguments, run); });
  made.add_option("--passphrase", arguments->passphrase, "Where the passphrase comes from (ask)")->type_name(kPassphraseSource);
  auto& shown = addCommand(group, selection, "show", "The public half, for whoever makes examinations", {"key show -o anna.pub"},
                           [arguments](Run& run) { return showKey(*arguments, run); });
  shown.add_option("-o,--output", arguments->output, "Into a file")->type_name("KEY.pub");
}

void addAccess(CLI::App& root, Selection& selection) {
  auto& group = *root.add_subcommand("access", "Lock this account's library for trainees, and see what instructors changed");
  group.require_subcommand(1);
  auto arguments = std::make_shared<KeyArguments>();
  auto& locked = addCommand(group, selection, "lock", "Show trainees what trainees may see, until an instructor's passphrase comes",
                            {"access lock"}, [arguments](Run& run) { return lock(*arguments, run); });
  locked.add_option("--passphrase", arguments->passphrase, "Where the new passphrase comes from (ask)")->type_name(kPassphraseSource);
  auto& opened = addCommand(group, selection, "unlock", "Take the lock away", {"access unlock"},
                            [arguments](Run& run) { return unlock(*arguments, run); });
  opened.add_option("--passphrase", arguments->passphrase, "Where the passphrase comes from (ask)")->type_name(kPassphraseSource);
  addCommand(group, selection, "status", "Whether there is a lock", {"access status"}, [](Run& run) { return status(run); });
  addCommand(group, selection, "changes", "What instructors changed, the first change first", {"access changes"},
             [](Run& run) { return changes(run); });
}

}  // namespace ew::cli
