#include "run/access_gate.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "run/passphrase_input.h"

namespace ew::cli {
namespace {

/// Commands that show no answer and nobody's attempt: they work on files that their user names, or say what is there.
constexpr std::array<std::string_view, 23> kForAnybody = {
    "import",   "screen",        "reconstruct",  "register",      "slice",         "level",        "scan",         "measure",
    "criteria", "send",          "plugins list", "preset list",   "preset check",  "case import",  "case verify",  "lesson list",
    "key show", "access status", "access lock",  "access unlock", "tracker print", "tracker list", "tracker check"};

constexpr std::array<std::pair<std::string_view, Permission>, 14> kNeeds = {{{"case card", Permission::editCases},
                                                                             {"case export", Permission::exportCases},
                                                                             {"case publish", Permission::exportCases},
                                                                             {"case unseal", Permission::judge},
                                                                             {"case new", Permission::editCases},
                                                                             {"lesson record", Permission::editCases},
                                                                             {"assess", Permission::judge},
                                                                             {"rate", Permission::judge},
                                                                             {"records", Permission::seeOthersAttempts},
                                                                             {"replay", Permission::seeOthersAttempts},
                                                                             {"key", Permission::changeLock},
                                                                             {"access", Permission::changeLock},
                                                                             {"case", Permission::seeAnswers},
                                                                             {"lesson", Permission::seeAnswers}}};

/// "key" stands for "key new" as well.
bool covers(std::string_view entry, std::string_view command) {
  return command == entry || (command.starts_with(entry) && command[entry.size()] == ' ');
}

}  // namespace

std::optional<Permission> permissionFor(std::string_view command) {
  if (std::find(kForAnybody.begin(), kForAnybody.end(), command) != kForAnybody.end()) return std::nullopt;
  const auto need = std::find_if(kNeeds.begin(), kNeeds.end(), [&](const auto& each) { return covers(each.first, command); });
  return need == kNeeds.end() ? Permission::seeAnswers : need->second;
}

Result<void> passGate(std::string_view command, const std::string& unlockFrom, AccessPolicy& policy) {
  const auto permission = permissionFor(command);
  if (!policy.isLocked() || !permission) return {};
  if (!unlockFrom.empty()) {
    const auto passphrase = readPassphrase(unlockFrom, say<"Instructor's passphrase:">());
    if (!passphrase) return passOn(passphrase.error());
    if (auto opened = policy.unlock(*passphrase); !opened) return opened;
  }
  return policy.require(*permission);
}

}  // namespace ew::cli
