#pragma once

#include <curl/curl.h>

#include <map>
#include <memory>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "ew/core/progress.h"
#include "ew/records/record_store.h"

namespace ew::records {

struct HttpQuestion {
  std::string method = "GET";
  std::string url;
  std::vector<std::string> headers;  ///< "Name: value"
  std::string body;                  ///< of POST and PUT
};

struct HttpAnswer {
  long status = 0;
  std::map<std::string, std::string> headers;  ///< names in small letters
  std::string body;
};

enum class HttpTrouble {
  unreachable,  ///< nothing of the question got there
  lost,         ///< it may have got there, and even been acted upon
  untrusted,    ///< the other side could not prove who it is
  cancelled
};
struct HttpFailure {
  HttpTrouble trouble = HttpTrouble::unreachable;
  std::string why;  ///< in English, without a full stop
};
using HttpResult = tl::expected<HttpAnswer, HttpFailure>;

/// Asks questions, each over a connection of its own. No redirect is followed: credentials go to the named server alone. Certificates are
/// verified. An answer of more than 4 MiB is cut off as lost.
class HttpClient {
 public:
  /// @param store its endpoint is not looked at, its authorization is not sent by itself
  explicit HttpClient(const RecordStore& store);
  /// Stops within 0.1 s when `progress` asks for it.
  [[nodiscard]] HttpResult ask(const HttpQuestion& question, const Progress& progress);

 private:
  bool allowsHttp_;
  std::string certificates_;
  double connect_s_, timeout_s_;
};

/// A question for a record store: with version and authorization. @param resource "statements?statementId=..." below its endpoint
[[nodiscard]] HttpQuestion questionFor(const RecordStore& store, const std::string& method, const std::string& resource,
                                       std::string body = {});

/// What the server says, tamed: "message", "error", ... of a JSON object, else its text. Empty: it says nothing.
[[nodiscard]] std::string wordsOf(const HttpAnswer& answer, const std::vector<std::string>& secrets);
/// Everything in an authorization that must not get into a sentence: the header, what stands behind its scheme, and the password in that.
[[nodiscard]] std::vector<std::string> secretsIn(const std::string& authorization);

/// Seconds that an answer asks to wait (Retry-After, as a number or a date beside its own Date); 0 when it does not.
[[nodiscard]] double waitAskedFor_s(const HttpAnswer& answer);

[[nodiscard]] std::string base64Of(const std::string& bytes);

}  // namespace ew::records
