#include <openssl/evp.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "ew/core/foreign_json.h"
#include "http.h"
#include "iri.h"

namespace ew {
namespace {

constexpr std::size_t kShortestHidden = 4;

bool hasControls(const std::string& text) {
  return std::any_of(text.begin(), text.end(), [](char letter) { return static_cast<unsigned char>(letter) < 32 || letter == 127; });
}

}  // namespace

namespace records {

std::string base64Of(const std::string& bytes) {
  std::string text((bytes.size() + 2) / 3 * 4 + 1, '\0');
  const int size = EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), reinterpret_cast<const unsigned char*>(bytes.data()),
                                   static_cast<int>(bytes.size()));
  text.resize(static_cast<std::size_t>(size));
  return text;
}

std::vector<std::string> secretsIn(const std::string& authorization) {
  if (authorization.empty()) return {};
  std::vector<std::string> found = {authorization};
  const auto space = authorization.find(' ');
  if (space == std::string::npos) return found;
  const std::string token = authorization.substr(space + 1);
  found.push_back(token);
  if (token.size() % 4 != 0) return found;
  std::string bytes(token.size() / 4 * 3 + 1, '\0');
  const int size = EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()), reinterpret_cast<const unsigned char*>(token.data()),
                                   static_cast<int>(token.size()));
  if (size < 0) return found;
  bytes.resize(static_cast<std::size_t>(size));
  while (!bytes.empty() && bytes.back() == '\0') bytes.pop_back();  // what the '=' at its end stands for
  // A password of a letter or two would take every such letter out of what a server says.
  if (const auto colon = bytes.find(':'); colon != std::string::npos && bytes.size() - colon > kShortestHidden)
    found.push_back(bytes.substr(colon + 1));
  return found;
}

}  // namespace records

Result<std::string> basicAuthorization(const std::string& user, const std::string& secret) {
  if (user.find(':') != std::string::npos || hasControls(user) || hasControls(secret))
    return failure(ErrorCode::badField,
                   say<"The user of the record store must not hold a colon, and neither user nor password a line break; check both.">());
  return "Basic " + records::base64Of(user + ":" + secret);
}

Result<std::string> bearerAuthorization(const std::string& token) {
  const bool isToken = !token.empty() && std::all_of(token.begin(), token.end(), [](char letter) {
    return static_cast<unsigned char>(letter) > 32 && static_cast<unsigned char>(letter) < 127;
  });
  if (!isToken)
    return failure(ErrorCode::badField, say<"The record store's token holds spaces or line breaks, or is empty; copy it again.">());
  return "Bearer " + token;
}

Result<void> askRecordStore(const RecordStore& store, const Progress& progress) {
  RecordStore asked = store;
  const Message what = say<"The record store's address">();
  auto endpoint = records::safeEndpoint(store.endpoint, store.allowsHttp, what);
  if (!endpoint) return passOn(endpoint.error());
  asked.endpoint = *endpoint;
  records::HttpClient client(asked);
  const auto no = [&](Message why) {
    return failure(ErrorCode::notReadable, say<"The record store %1 cannot be used: %2.">(asked.endpoint, std::move(why)),
                   {{"endpoint", asked.endpoint}});
  };
  const auto answer = client.ask(records::questionFor(asked, "GET", "statements?limit=1"), progress);
  if (!answer && answer.error().trouble == records::HttpTrouble::cancelled)
    return failure(ErrorCode::cancelled, say<"Stopped as asked.">());
  if (!answer) return no(verbatim(answer.error().why));
  const long status = answer->status;
  const std::string words = records::wordsOf(*answer, records::secretsIn(asked.authorization));
  if (status == 401 || status == 403) return no(say<"it does not accept user and password (%1)">(status));
  if (status >= 300 && status < 400) return no(say<"it sends us elsewhere (%1); put the final address in the settings">(status));
  if (status != 200) return no(say<"it answers %1 %2">(status, records::inQuotes(words)));
  if (const auto json = jsonOrNull(answer->body); !json.is_object() || !json.contains("statements"))
    return no(say<"what answers there is no record store; check the address">());
  return {};
}

}  // namespace ew
