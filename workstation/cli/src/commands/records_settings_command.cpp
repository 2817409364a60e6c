#include <iostream>
#include <ostream>

#include "commands/records_arguments.h"
#include "ew/io/safe_file.h"

namespace ew::cli {
namespace {

namespace fs = std::filesystem;
using Login = RecordStoreSettings::Login;

/// The first line of a file, or of what is typed ("-"): never a word of the command line, which everybody on the machine can see.
Result<std::string> secretIn(const std::string& from) {
  std::string line;
  if (from == "-") {
    std::getline(std::cin, line);
  } else {
    const auto text = readTextFile(from, 64u << 10);
    if (!text) return passOn(text.error());
    line = text->substr(0, text->find('\n'));
  }
  if (!line.empty() && line.back() == '\r') line.pop_back();
  return line;
}

void showSettings(const RecordStoreSettings& settings, bool hasSecret, Run& run) {
  const auto line = [&](const char* name, const std::string& value) { run.out() << name << (value.empty() ? "not set" : value) << "\n"; };
  line("record store:      ", settings.endpoint);
  line("login:             ", settings.login == Login::basic ? "user and password" : "token");
  if (settings.login == Login::basic) line("user:              ", settings.user);
  line("secret:            ", hasSecret ? "kept" : "");
  line("accounts live at:  ", homePageOf(settings));
  line("ids begin with:    ", settings.activityBase);
  if (settings.allowsHttp) run.out() << "http is allowed: everybody on the way can read what is sent\n";
  if (!settings.certificates.empty()) line("trusted:           ", settings.certificates);
}

/// What was asked to be changed. @return whether anything was
bool changeSettings(const RecordsArguments& arguments, RecordStoreSettings& settings) {
  const RecordStoreSettings before = settings;
  if (arguments.endpoint) settings.endpoint = *arguments.endpoint;
  if (arguments.user) settings.user = *arguments.user;
  if (arguments.homePage) settings.homePage = *arguments.homePage;
  if (arguments.activityBase) settings.activityBase = *arguments.activityBase;
  if (arguments.certificates) settings.certificates = arguments.certificates->empty() ? "" : fs::absolute(*arguments.certificates).string();
  if (!arguments.login.empty()) settings.login = arguments.login == "token" ? Login::bearer : Login::basic;
  if (arguments.allowsHttp) settings.allowsHttp = true;
  if (arguments.forbidsHttp) settings.allowsHttp = false;
  return !(settings == before);
}

Result<int> setRecords(const RecordsArguments& arguments, Run& run) {
  staysDone(run);
  const auto place = arguments.settingsPlace();
  if (!place) return passOn(place.error());
  RecordStoreSettings settings;
  if (auto read = readRecordStoreSettings(*place))
    settings = std::move(*read);
  else if (read.error().code != ErrorCode::notFound)
    return passOn(read.error());
  if (changeSettings(arguments, settings))
    if (auto written = writeRecordStoreSettings(settings, *place); !written) return passOn(written.error());
  if (arguments.forgets)
    if (auto gone = forgetSecret(*place, kRecordStoreSecret, arguments.secrets()); !gone) return passOn(gone.error());
  if (!arguments.secretFrom.empty()) {
    const auto secret = secretIn(arguments.secretFrom);
    if (!secret) return passOn(secret.error());
    const auto kept = keepSecret(*place, kRecordStoreSecret, *secret, arguments.secrets());
    if (!kept) return passOn(kept.error());
    run.say(*kept == SecretPlace::keyring ? "The secret is in the system's keyring."
                                          : "No keyring answers, so the secret is in a file that only you can read.");
  }
  const auto secret = readSecret(*place, kRecordStoreSecret, arguments.secrets());
  if (!secret && secret.error().code != ErrorCode::notFound) return passOn(secret.error());
  showSettings(settings, secret.has_value(), run);
  if (!arguments.asks) return kDone;
  const auto store = recordStoreOf(*place, arguments.secrets());
  if (!store) return passOn(store.error());
  if (auto answered = askRecordStore(*store, run.progress); !answered) return passOn(answered.error());
  run.say("The record store answers and lets this program in.");
  return kDone;
}

void addSettingOptions(CLI::App& app, RecordsArguments& arguments) {
  app.add_option("--endpoint", arguments.endpoint, "The record store's xAPI address: https, or http on this machine")->type_name("ADDRESS");
  app.add_option("--login", arguments.login, "How it lets us in: password or token (password)")
      ->type_name("WORD")
      ->check(CLI::IsMember({"password", "token"}));
  app.add_option("--user", arguments.user, "The user, or the key, beside the password")->type_name("NAME");
  app.add_option("--secret-from", arguments.secretFrom, "A file whose first line is the password or the token; - reads it from the input")
      ->type_name("FILE");
  app.add_flag("--forget-secret", arguments.forgets, "Forget the password or the token");
  app.add_option("--home-page", arguments.homePage, "Where people have accounts: an address of your site (the record store's machine)")
      ->type_name("ADDRESS");
  app.add_option("--activity-base", arguments.activityBase, "What ids of lessons and steps begin with (urn:echoweave:)")->type_name("IRI");
  app.add_option("--certificates", arguments.certificates, "PEM file of the authorities to trust instead of the system's")
      ->type_name("FILE");
  app.add_flag("--allow-http", arguments.allowsHttp, "Send without encryption, also to other machines; for a network of your own alone");
  app.add_flag("--forbid-http", arguments.forbidsHttp, "Take that back");
  app.add_flag("--ask", arguments.asks, "Ask the record store whether it lets us in");
}

}  // namespace

void addSettingsPlace(CLI::App& app, RecordsArguments& arguments) {
  app.add_option("--settings", arguments.settings, "Where the settings are (~/.config/echoweave)")->type_name("DIR");
  app.add_flag("--no-keyring", arguments.noKeyring, "Keep and look for the secret in a file alone");
}

void addRecordSettings(CLI::App& group, Selection& selection, const std::shared_ptr<RecordsArguments>& arguments) {
  auto& set =
      addCommand(group, selection, "settings",
                 "Say where records go, or show it; the password goes into the keyring, or into a file that only you can read",
                 {"records settings --endpoint https://records.example/xapi/ --user echoweave --secret-from - --ask", "records settings"},
                 [arguments](Run& run) { return setRecords(*arguments, run); });
  addSettingOptions(set, *arguments);
  addSettingsPlace(set, *arguments);
}

}  // namespace ew::cli
