#include "ew/core/message_json.h"

#include <nlohmann/json.hpp>

namespace ew {
namespace {

template <class Json>
Json written(const Message& message) {
  if (message.isNumeral()) return {{"number", message.verbatim()}};
  if (message.arguments().empty() && message.text() == nullptr) return message.verbatim();
  Json with = Json::array();
  for (const Message& argument : message.arguments()) with.push_back(written<Json>(argument));
  if (message.text() == nullptr) return {{"between", message.verbatim()}, {"with", std::move(with)}};
  return {{"text", message.text()}, {"with", std::move(with)}};
}

const char* listedText(const std::string& text) {
  for (const MessageText* said = firstMessageText(); said != nullptr; said = said->next)
    if (said->text == text) return said->text;
  return nullptr;
}

template <class Json>
Message read(const Json& stored) {
  if (stored.is_string()) return verbatim(stored.template get<std::string>());
  if (!stored.is_object()) return {};
  if (const auto number = stored.find("number"); number != stored.end())
    return number->is_string() ? numeral(number->template get<std::string>()) : Message();
  std::vector<Message> with;
  if (const auto listed = stored.find("with"); listed != stored.end() && listed->is_array())
    for (const Json& one : *listed) with.push_back(read(one));
  if (const auto text = stored.find("text"); text != stored.end() && text->is_string()) {
    const auto wanted = text->template get<std::string>();
    if (const char* known = listedText(wanted)) return MessageMaker::of(known, std::move(with));
    return verbatim(filledIn(wanted, english(with)));
  }
  const auto between = stored.find("between");
  return joined(std::move(with), between != stored.end() && between->is_string() ? between->template get<std::string>() : std::string(" "));
}

}  // namespace

void to_json(nlohmann::json& json, const Message& message) { json = written<nlohmann::json>(message); }
void to_json(nlohmann::ordered_json& json, const Message& message) { json = written<nlohmann::ordered_json>(message); }
void from_json(const nlohmann::json& json, Message& message) { message = read(json); }
void from_json(const nlohmann::ordered_json& json, Message& message) { message = read(json); }

}  // namespace ew
