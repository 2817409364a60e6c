#include "http.h"

#include <pthread.h>

#include <algorithm>
#include <cctype>
#include <chrono>
#include <csignal>
#include <ctime>
#include <mutex>
#include <nlohmann/json.hpp>

#include "ew/core/foreign_json.h"
#include "ew/core/numbers.h"
#include "ew/core/version.h"
#include "iri.h"

namespace ew::records {
namespace {

constexpr std::size_t kLargestAnswer_bytes = 4u << 20;
constexpr std::size_t kLargestHeaders_bytes = 64u << 10;
constexpr int kLookUp_ms = 50;  // how often it is looked whether to stop

void startCurlOnce() {
  static std::once_flag once;
  std::call_once(once, [] { curl_global_init(CURL_GLOBAL_DEFAULT); });
}

struct Reading {
  HttpAnswer answer;
  std::size_t header_bytes = 0;
  bool isTooLarge = false;
};

std::size_t takeBody(char* bytes, std::size_t, std::size_t count, void* user) {
  auto& reading = *static_cast<Reading*>(user);
  reading.isTooLarge = reading.answer.body.size() + count > kLargestAnswer_bytes;
  if (reading.isTooLarge) return 0;
  reading.answer.body.append(bytes, count);
  return count;
}

std::size_t takeHeader(char* bytes, std::size_t, std::size_t count, void* user) {
  auto& reading = *static_cast<Reading*>(user);
  reading.header_bytes += count;
  reading.isTooLarge = reading.header_bytes > kLargestHeaders_bytes;
  if (reading.isTooLarge) return 0;
  const std::string line(bytes, count);
  if (line.starts_with("HTTP/")) reading.answer.headers.clear();  // of the final answer, not of "100 Continue"
  const auto colon = line.find(':');
  if (colon == std::string::npos) return count;
  std::string name = line.substr(0, colon), value = line.substr(colon + 1);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  value.erase(0, value.find_first_not_of(" \t"));
  value.erase(value.find_last_not_of(" \t\r\n") + 1);
  reading.answer.headers[name] = value;
  return count;
}

struct EasyEnd {
  void operator()(CURL* easy) const { curl_easy_cleanup(easy); }
};
struct MultiEnd {
  void operator()(CURLM* multi) const { curl_multi_cleanup(multi); }
};
struct ListEnd {
  void operator()(curl_slist* list) const { curl_slist_free_all(list); }
};
using Easy = std::unique_ptr<CURL, EasyEnd>;
using Multi = std::unique_ptr<CURLM, MultiEnd>;
using HeaderList = std::unique_ptr<curl_slist, ListEnd>;

HeaderList headerListOf(const std::vector<std::string>& headers) {
  curl_slist* list = nullptr;
  for (const std::string& header : headers) list = curl_slist_append(list, header.c_str());
  return HeaderList(list);
}

HttpTrouble troubleOf(CURLcode code, CURL* easy) {
  switch (code) {
    case CURLE_COULDNT_RESOLVE_PROXY:
    case CURLE_COULDNT_RESOLVE_HOST:
    case CURLE_COULDNT_CONNECT:
    case CURLE_URL_MALFORMAT:
    case CURLE_UNSUPPORTED_PROTOCOL:
      return HttpTrouble::unreachable;
    case CURLE_PEER_FAILED_VERIFICATION:
    case CURLE_SSL_CACERT_BADFILE:
    case CURLE_SSL_ISSUER_ERROR:
    case CURLE_SSL_INVALIDCERTSTATUS:
      return HttpTrouble::untrusted;
    default: {
      curl_off_t beforeSending_us = 0;  // 0 as long as the connection, with its encryption, does not stand
      curl_easy_getinfo(easy, CURLINFO_PRETRANSFER_TIME_T, &beforeSending_us);
      return beforeSending_us > 0 ? HttpTrouble::lost : HttpTrouble::unreachable;
    }
  }
}

/// No SIGPIPE in this thread: OpenSSL writes to a connection that the other side may have closed, and the signal would end the program.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    sigset_t pending;
    sigpending(&pending);
    wasPending_ = sigismember(&pending, SIGPIPE) == 1;
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  ~NoPipeSignal() {
    const timespec atOnce{0, 0};
    while (!wasPending_ && sigtimedwait(&pipe_, nullptr, &atOnce) == SIGPIPE) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;

 private:
  sigset_t pipe_{}, before_{};
  bool wasPending_ = false;
};

/// Polled, for curl's own progress call comes once a second. Empty: cancelled.
std::optional<CURLcode> perform(CURLM* multi, const Progress& progress) {
  for (int running = 1; running > 0;) {
    if (progress.cancelRequested()) return std::nullopt;
    if (curl_multi_perform(multi, &running) != CURLM_OK) return CURLE_FAILED_INIT;
    if (running > 0) curl_multi_poll(multi, nullptr, 0, kLookUp_ms, nullptr);
  }
  int left = 0;
  const CURLMsg* message = curl_multi_info_read(multi, &left);
  return message != nullptr ? message->data.result : CURLE_FAILED_INIT;
}

}  // namespace

HttpClient::HttpClient(const RecordStore& store)
    : allowsHttp_(store.allowsHttp), certificates_(store.certificates), connect_s_(store.connect_s), timeout_s_(store.timeout_s) {
  startCurlOnce();
}

HttpResult HttpClient::ask(const HttpQuestion& question, const Progress& progress) {
  if (const auto safe = safeAddress(question.url, allowsHttp_, say<"the address">()); !safe)
    return tl::unexpected(HttpFailure{HttpTrouble::unreachable, safe.error().sentence()});
  const NoPipeSignal noSignal;
  // What a question needs outlives the handles, which are closed in the reverse order.
  Reading reading;
  std::vector<std::string> headers = question.headers;
  headers.emplace_back("Expect:");  // no second round trip before a body
  const HeaderList list = headerListOf(headers);
  char why[CURL_ERROR_SIZE] = "";
  const Multi multi(curl_multi_init());
  const Easy easy(curl_easy_init());
  if (!multi || !easy || !list) return tl::unexpected(HttpFailure{HttpTrouble::unreachable, "there is not enough memory"});
  const auto set = [&](CURLoption option, auto value) { curl_easy_setopt(easy.get(), option, value); };
  const std::string host = hostOf(question.url);
  set(CURLOPT_URL, question.url.c_str());
  set(CURLOPT_PROTOCOLS_STR, question.url.starts_with("http:") ? "http" : "https");
  if (host == "localhost" || host == "127.0.0.1" || host == "[::1]") set(CURLOPT_PROXY, "");
  set(CURLOPT_FOLLOWLOCATION, 0L);
  set(CURLOPT_HTTP_VERSION, static_cast<long>(CURL_HTTP_VERSION_1_1));
  // curl sends again by itself what it had sent over a kept connection that turns out to be closed: a statement might arrive twice.
  set(CURLOPT_FRESH_CONNECT, 1L);
  set(CURLOPT_FORBID_REUSE, 1L);
  set(CURLOPT_QUICK_EXIT, 1L);  // whoever stops does not wait for a name server
  set(CURLOPT_NOSIGNAL, 1L);
  set(CURLOPT_SSLVERSION, static_cast<long>(CURL_SSLVERSION_TLSv1_2));
  set(CURLOPT_SSL_VERIFYPEER, 1L);
  set(CURLOPT_SSL_VERIFYHOST, 2L);
  if (!certificates_.empty()) set(CURLOPT_CAINFO, certificates_.c_str());
  set(CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(connect_s_ * 1000.0));
  set(CURLOPT_TIMEOUT_MS, static_cast<long>(timeout_s_ * 1000.0));
  const std::string agent = std::string("EchoWeave/") + kVersion;
  set(CURLOPT_USERAGENT, agent.c_str());
  set(CURLOPT_HTTPHEADER, list.get());
  set(CURLOPT_ERRORBUFFER, static_cast<char*>(why));
  set(CURLOPT_WRITEFUNCTION, takeBody);
  set(CURLOPT_WRITEDATA, static_cast<void*>(&reading));
  set(CURLOPT_HEADERFUNCTION, takeHeader);
  set(CURLOPT_HEADERDATA, static_cast<void*>(&reading));
  if (question.method != "GET") {
    set(CURLOPT_POSTFIELDSIZE_LARGE, static_cast<curl_off_t>(question.body.size()));
    set(CURLOPT_POSTFIELDS, question.body.c_str());
    set(CURLOPT_CUSTOMREQUEST, question.method.c_str());
  }
  curl_multi_add_handle(multi.get(), easy.get());
  const auto code = perform(multi.get(), progress);
  const auto failed = [&](HttpTrouble trouble, std::string words) { return tl::unexpected(HttpFailure{trouble, std::move(words)}); };
  HttpResult result;
  if (!code)
    result = failed(HttpTrouble::cancelled, "stopped");
  else if (reading.isTooLarge)
    result = failed(HttpTrouble::lost, "it answers with more than " + std::to_string(kLargestAnswer_bytes >> 20) + " MiB");
  else if (*code != CURLE_OK)
    result = failed(troubleOf(*code, easy.get()), tamed(why[0] != '\0' ? why : curl_easy_strerror(*code)));
  else {
    curl_easy_getinfo(easy.get(), CURLINFO_RESPONSE_CODE, &reading.answer.status);
    result = std::move(reading.answer);
  }
  curl_multi_remove_handle(multi.get(), easy.get());
  return result;
}

HttpQuestion questionFor(const RecordStore& store, const std::string& method, const std::string& resource, std::string body) {
  HttpQuestion question{method, store.endpoint + resource, {}, std::move(body)};
  question.headers = {std::string("X-Experience-API-Version: ") + "1.0.3", "Accept: application/json"};
  if (!store.authorization.empty()) question.headers.push_back("Authorization: " + store.authorization);
  if (method != "GET") question.headers.emplace_back("Content-Type: application/json");
  return question;
}

std::string wordsOf(const HttpAnswer& answer, const std::vector<std::string>& secrets) {
  const auto json = jsonOrNull(answer.body);
  for (const char* name : {"message", "error-text", "error", "errors", "warnings", "detail", "title"})
    if (!memberOf(json, name).empty()) return tamed(wordsAt(json, name), secrets);
  return tamed(answer.body, secrets);
}

double waitAskedFor_s(const HttpAnswer& answer) {
  const auto asked = answer.headers.find("retry-after");
  if (asked == answer.headers.end()) return 0.0;
  if (const auto seconds = parseNumber(asked->second)) return std::max(*seconds, 0.0);
  const std::time_t until = curl_getdate(asked->second.c_str(), nullptr);
  if (until < 0) return 0.0;
  const auto date = answer.headers.find("date");
  const std::time_t now = date != answer.headers.end() ? curl_getdate(date->second.c_str(), nullptr) : std::time_t{-1};
  const auto own = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return std::max(0.0, std::difftime(until, now >= 0 ? now : own));
}

}  // namespace ew::records
