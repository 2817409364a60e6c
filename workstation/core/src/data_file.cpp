#include "ew/core/data_file.h"

#include <nlohmann/json.hpp>

namespace ew {

Words wordsIn(const JsonFields& fields, std::string_view key, std::size_t longest, bool needed) {
  if (!needed && !fields.has(key)) return {};
  const JsonFields words = fields.object(key);
  words.only({"en", "de"});
  return {words.text("en", {}, 1, longest), words.text("de", {}, 1, longest)};
}

void requireFormat(const JsonFields& document, int known) {
  constexpr long long kAny = 1000000;
  const auto format = document.whole("format", 1, kAny);
  if (!document.good() || format <= known) return;
  const Message& where = document.reading().where();
  document.reading().refuse(Error{ErrorCode::newerFormat,
                                  say<"%1 has format %2, this program reads up to %3; update EchoWeave.">(where, format, known),
                                  {{"file", where.english()}, {"found", std::to_string(format)}, {"known", std::to_string(known)}}});
}

}  // namespace ew
