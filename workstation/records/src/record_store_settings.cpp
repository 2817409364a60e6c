#include "ew/records/record_store_settings.h"

#include <cstdlib>

#include "ew/core/json_fields.h"
#include "ew/core/word_table.h"
#include "ew/io/json_files.h"
#include "ew/io/private_file.h"
#include "iri.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using Login = RecordStoreSettings::Login;

constexpr const char* kSettingsFile = "record-store.json";
constexpr WordTable<Login, 2> kLogins = {{{"basic", Login::basic}, {"bearer", Login::bearer}}};

Result<void> checkSettings(const RecordStoreSettings& settings) {
  if (!settings.endpoint.empty())
    if (auto safe = records::safeEndpoint(settings.endpoint, settings.allowsHttp, say<"The record store's address">()); !safe)
      return passOn(safe.error());
  if (!settings.homePage.empty() && !records::isWebAddress(settings.homePage))
    return failure(ErrorCode::badField,
                   say<"The home page of accounts is %1; it must be %2.">(
                       records::inQuotes(settings.homePage), say<"an address of your site, such as https://school.example/">()),
                   {{"field", "home_page"}, {"found", settings.homePage}});
  if (!records::isIri(settings.activityBase))
    return failure(ErrorCode::badField,
                   say<"What ids of activities begin with is %1; it must be %2.">(records::inQuotes(settings.activityBase),
                                                                                  say<"an address or a urn">()),
                   {{"field", "activity_base"}, {"found", settings.activityBase}});
  return {};
}

}  // namespace

Result<fs::path> recordSettingsFolder() {
  if (const char* given = std::getenv("XDG_CONFIG_HOME"); given != nullptr && given[0] == '/') return fs::path(given) / "echoweave";
  if (const char* home = std::getenv("HOME"); home != nullptr && home[0] == '/') return fs::path(home) / ".config" / "echoweave";
  return failure(ErrorCode::notFound, say<"It is not known where your home folder is; set HOME, or name a folder with --settings.">());
}

std::string homePageOf(const RecordStoreSettings& settings) {
  if (!settings.homePage.empty()) return settings.homePage;
  const std::string origin = records::originOf(settings.endpoint);
  return origin.empty() ? origin : origin + "/";
}

fs::path recordOutboxFolder(const fs::path& library) { return library / "records"; }

Result<RecordStoreSettings> readRecordStoreSettings(const fs::path& folder) {
  const fs::path file = folder / kSettingsFile;
  std::error_code ignored;
  if (!fs::exists(file, ignored))
    return failure(ErrorCode::notFound,
                   say<"It is not known yet where records go; say it with 'echoweave records settings --endpoint ADDRESS'.">(),
                   {{"file", file.string()}});
  const auto document = readJsonFile(file, verbatim(kSettingsFile));
  if (!document) return passOn(document.error());
  JsonReading reading{verbatim(kSettingsFile), {"note"}};
  const JsonFields fields(*document, reading);
  const auto format = fields.whole("format", 1, 1'000'000);
  if (reading.good() && format > kRecordStoreFormat)
    return failure(ErrorCode::newerFormat,
                   say<"%1 has format %2, and this program reads formats up to %3; use a newer EchoWeave.">(std::string(kSettingsFile),
                                                                                                            format, kRecordStoreFormat),
                   {{"field", "format"}, {"found", std::to_string(format)}});
  fields.only({"format", "endpoint", "login", "user", "allow_http", "certificates", "home_page", "activity_base"});
  RecordStoreSettings settings;
  settings.endpoint = fields.text("endpoint", std::string(), 0, 1000);
  settings.login = fields.word("login", kLogins, std::optional(Login::basic));
  settings.user = fields.text("user", std::string(), 0);
  settings.allowsHttp = fields.flag("allow_http", false);
  settings.certificates = fields.text("certificates", std::string(), 0, 4000);
  settings.homePage = fields.text("home_page", std::string(), 0, 1000);
  settings.activityBase = fields.text("activity_base", settings.activityBase, 1, 1000);
  if (reading.problem()) return passOn(*reading.problem());
  if (auto usable = checkSettings(settings); !usable) return passOn(usable.error());
  return settings;
}

Result<void> writeRecordStoreSettings(const RecordStoreSettings& settings, const fs::path& folder) {
  if (auto usable = checkSettings(settings); !usable) return usable;
  if (std::error_code ignored; !fs::exists(folder, ignored))
    if (auto made = makePrivateFolder(folder); !made) return made;
  nlohmann::ordered_json made = {
      {"format", kRecordStoreFormat}, {"endpoint", settings.endpoint}, {"login", wordIn(kLogins, settings.login)}};
  const auto text = [&](const char* key, const std::string& value) {
    if (!value.empty()) made[key] = value;
  };
  text("user", settings.user);
  if (settings.allowsHttp) made["allow_http"] = true;
  text("certificates", settings.certificates);
  text("home_page", settings.homePage);
  made["activity_base"] = settings.activityBase;
  return writePrivateFile(folder / kSettingsFile, made.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

Result<RecordStore> recordStoreOf(const fs::path& folder, const SecretOptions& options) {
  const auto settings = readRecordStoreSettings(folder);
  if (!settings) return passOn(settings.error());
  if (settings->endpoint.empty())
    return failure(ErrorCode::notFound,
                   say<"It is not known yet where records go; say it with 'echoweave records settings --endpoint ADDRESS'.">());
  auto secret = readSecret(folder, kRecordStoreSecret, options);
  if (!secret) return passOn(secret.error());
  auto authorization = settings->login == Login::basic ? basicAuthorization(settings->user, *secret) : bearerAuthorization(*secret);
  if (!authorization) return passOn(authorization.error());
  RecordStore store;
  store.endpoint = settings->endpoint;
  store.authorization = std::move(*authorization);
  store.allowsHttp = settings->allowsHttp;
  store.certificates = settings->certificates;
  return store;
}

}  // namespace ew
