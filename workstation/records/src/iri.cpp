#include "iri.h"

#include <curl/curl.h>

#include <algorithm>
#include <cctype>
#include <memory>

#include "ew/core/printable.h"

namespace ew::records {
namespace {

constexpr std::size_t kLongestSentence_bytes = 300;

struct UrlEnd {
  void operator()(CURLU* url) const { curl_url_cleanup(url); }
};
using Url = std::unique_ptr<CURLU, UrlEnd>;

Url parsedUrl(const std::string& address) {
  Url url(curl_url());
  if (address.find_first_of(" \t\r\n\"<>") != std::string::npos) return nullptr;
  if (!url || curl_url_set(url.get(), CURLUPART_URL, address.c_str(), 0) != CURLUE_OK) return nullptr;
  return url;
}

std::string partOf(const Url& url, CURLUPart part, unsigned flags = 0) {
  char* text = nullptr;
  if (!url || curl_url_get(url.get(), part, &text, flags) != CURLUE_OK) return {};
  std::string made = text;
  curl_free(text);
  return made;
}

bool isThisMachine(const std::string& host) { return host == "localhost" || host == "127.0.0.1" || host == "[::1]"; }

bool isWordLetter(char letter) { return std::isalnum(static_cast<unsigned char>(letter)) != 0; }

/// Without what stands between '<' and '>'.
std::string withoutTags(std::string_view text) {
  std::string made;
  bool isInside = false;
  for (const char letter : text) {
    if (letter == '<') isInside = true;
    if (!isInside) made += letter;
    if (letter == '>') {
      isInside = false;
      made += ' ';
    }
  }
  return made;
}

}  // namespace

Message inQuotes(std::string_view text) { return verbatim("\"" + tamed(text.substr(0, 200)) + "\""); }

std::string encoded(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string made;
  for (const char letter : text) {
    if (isWordLetter(letter) || letter == '-' || letter == '.' || letter == '_' || letter == '~') {
      made += letter;
    } else {
      const auto byte = static_cast<unsigned char>(letter);
      made += '%';
      made += kDigits[byte >> 4];
      made += kDigits[byte & 15];
    }
  }
  return made;
}

std::optional<std::string> decoded(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string made;
  for (std::size_t n = 0; n < text.size(); ++n) {
    if (text[n] != '%') {
      made += text[n];
      continue;
    }
    if (n + 2 >= text.size()) return std::nullopt;
    const auto digit = [&](std::size_t at) { return kDigits.find(static_cast<char>(std::tolower(static_cast<unsigned char>(text[at])))); };
    const auto high = digit(n + 1), low = digit(n + 2);
    if (high == std::string_view::npos || low == std::string_view::npos) return std::nullopt;
    made += static_cast<char>(high * 16 + low);
    n += 2;
  }
  return made;
}

bool isIri(std::string_view text) {
  const auto colon = text.find(':');
  if (colon == std::string_view::npos || colon == 0 || colon + 1 == text.size() || text.size() > 1000) return false;
  if (std::isalpha(static_cast<unsigned char>(text.front())) == 0) return false;
  const auto isSchemeLetter = [](char letter) { return isWordLetter(letter) || letter == '+' || letter == '-' || letter == '.'; };
  const std::string_view scheme = text.substr(0, colon);
  return std::all_of(scheme.begin(), scheme.end(), isSchemeLetter) && std::none_of(text.begin(), text.end(), [](char letter) {
           return static_cast<unsigned char>(letter) <= 32 || letter == 127 ||
                  std::string_view("<>\"{}|\\^`").find(letter) != std::string_view::npos;
         });
}

bool isWebAddress(std::string_view text) {
  if (!isIri(text)) return false;
  const Url url = parsedUrl(std::string(text));
  const std::string scheme = partOf(url, CURLUPART_SCHEME);
  return (scheme == "https" || scheme == "http") && !partOf(url, CURLUPART_HOST).empty();
}

bool isLanguageTag(std::string_view text) {
  std::size_t run = 0, runs = 0;
  for (const char letter : text) {
    if (letter == '-') {
      if (run == 0) return false;
      run = 0;
      ++runs;
    } else if (!isWordLetter(letter) || ++run > 8 || (runs == 0 && std::isalpha(static_cast<unsigned char>(letter)) == 0)) {
      return false;
    }
  }
  return run > 0 && text.size() >= 2;
}

Result<std::string> safeAddress(const std::string& address, bool allowsHttp, const Message& what) {
  const auto refused = [&](Message expected) {
    return failure(ErrorCode::badField, say<"%1 is %2; it must be %3.">(what, inQuotes(address), std::move(expected)),
                   {{"field", "address"}, {"found", tamed(address)}});
  };
  const Url url = parsedUrl(address);
  const std::string scheme = partOf(url, CURLUPART_SCHEME), host = partOf(url, CURLUPART_HOST);
  if (host.empty() || (scheme != "https" && scheme != "http")) return refused(say<"an address such as https://records.example/xapi/">());
  if (!partOf(url, CURLUPART_USER).empty() || !partOf(url, CURLUPART_PASSWORD).empty())
    return failure(ErrorCode::badField,
                   say<"%1 holds a user or a password; give these by themselves, so that they stay out of logs.">(what),
                   {{"field", "address"}});
  if (!partOf(url, CURLUPART_FRAGMENT).empty()) return refused(say<"without a part behind #">());
  if (scheme == "http" && !isThisMachine(host) && !allowsHttp)
    return failure(ErrorCode::badField,
                   say<"%1 is %2, where everybody on the way can read what is sent; use https, or allow http if the network is your own.">(
                       what, inQuotes(address)),
                   {{"field", "address"}, {"found", tamed(address)}});
  return partOf(url, CURLUPART_URL);
}

Result<std::string> safeEndpoint(const std::string& endpoint, bool allowsHttp, const Message& what) {
  auto address = safeAddress(endpoint, allowsHttp, what);
  if (!address) return address;
  if (address->find('?') != std::string::npos)
    return failure(ErrorCode::badField, say<"%1 is %2; it must be %3.">(what, inQuotes(endpoint), say<"without a part behind ?">()),
                   {{"field", "address"}, {"found", tamed(endpoint)}});
  if (address->back() != '/') *address += '/';
  return address;
}

std::string originOf(const std::string& address) {
  const Url url = parsedUrl(address);
  const std::string scheme = partOf(url, CURLUPART_SCHEME), host = partOf(url, CURLUPART_HOST), port = partOf(url, CURLUPART_PORT);
  if (host.empty()) return {};
  return scheme + "://" + host + (port.empty() ? "" : ":" + port);
}

std::string hostOf(const std::string& address) { return partOf(parsedUrl(address), CURLUPART_HOST); }

std::string tamed(std::string_view text, const std::vector<std::string>& secrets) {
  std::string plain(text.substr(0, 20'000));
  for (const std::string& secret : secrets)
    for (std::size_t at = 0; !secret.empty() && (at = plain.find(secret, at)) != std::string::npos; at += 3)
      plain.replace(at, secret.size(), "***");
  plain = withoutTags(plain);
  std::string line;
  for (const char letter : plain) {
    const bool isSpace = static_cast<unsigned char>(letter) <= 32 || letter == 127;
    if (!isSpace)
      line += letter;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  line = printable(line);
  if (line.size() > kLongestSentence_bytes) {
    line.resize(kLongestSentence_bytes);
    while (!line.empty() && (static_cast<unsigned char>(line.back()) & 0xc0) == 0x80) line.pop_back();
    if (!line.empty() && static_cast<unsigned char>(line.back()) >= 0xc0) line.pop_back();
    line += "…";
  }
  while (!line.empty() && (line.back() == ' ' || line.back() == '.')) line.pop_back();
  return line;
}

}  // namespace ew::records
