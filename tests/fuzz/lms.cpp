#include "ew/core/foreign_json.h"
#include "ew/core/printable.h"
#include "ew/records/cmi5.h"
#include "folder.h"
#include "http.h"
#include "iri.h"

/// A learning system: the address of a launch, its launch data, what it answers, and how long it asks to wait.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const auto parts = fuzz::partsOf(bytes, size);
  if (const auto launch = cmi5LaunchOf(parts[0]); !launch) fuzz::checkSentence(launch.error());
  const std::string_view second = parts.size() > 1 ? parts[1] : parts[0];
  if (const auto data = cmi5LaunchDataOf(jsonOrNull(second)); !data) fuzz::checkSentence(data.error());
  records::HttpAnswer answer{401, {{"retry-after", std::string(parts.back().substr(0, 200))}}, std::string(second)};
  const std::string words = records::wordsOf(answer, {"secret"});
  fuzz::mustHold(words == printableLine(words) && words.find("secret") == std::string::npos);
  fuzz::mustHold(records::waitAskedFor_s(answer) >= 0.0);
  return 0;
}
