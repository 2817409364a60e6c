#include "ew/core/message.h"

#include <atomic>
#include <cstring>
#include <ostream>

namespace ew {
namespace {

/// Libraries and plugins enter their texts while they are loaded, before anything else of theirs runs.
constinit std::atomic<const MessageText*> firstText{nullptr};

}  // namespace

MessageText::MessageText(const char* said) : text(said), next(firstText.load()) {
  while (!firstText.compare_exchange_weak(next, this)) {
  }
}

const MessageText* firstMessageText() { return firstText.load(); }

std::string filledIn(std::string_view text, const std::vector<std::string>& arguments) {
  std::string filled;
  for (std::size_t n = 0; n < text.size(); ++n) {
    const bool place = text[n] == '%' && n + 1 < text.size() && text[n + 1] >= '1' && text[n + 1] <= '9';
    const auto number = place ? static_cast<std::size_t>(text[n + 1] - '1') : arguments.size();
    if (number < arguments.size()) {
      filled += arguments[number];
      ++n;
    } else {
      filled += text[n];
    }
  }
  return filled;
}

std::string Message::english() const {
  if (text_ != nullptr) {
    std::vector<std::string> said;
    said.reserve(arguments_.size());
    for (const Message& argument : arguments_) said.push_back(argument.english());
    return filledIn(text_, said);
  }
  if (arguments_.empty()) return verbatim_;
  std::string all;
  for (std::size_t n = 0; n < arguments_.size(); ++n) all += (n > 0 ? verbatim_ : std::string()) + arguments_[n].english();
  return all;
}

Message Message::withVerbatim(const std::function<std::string(std::string)>& change) const {
  Message changed = *this;
  if (text_ == nullptr && arguments_.empty()) changed.verbatim_ = change(std::move(changed.verbatim_));
  for (Message& argument : changed.arguments_) argument = argument.withVerbatim(change);
  return changed;
}

bool operator==(const Message& a, const Message& b) {
  if ((a.text_ == nullptr) != (b.text_ == nullptr)) return false;
  return (a.text_ == nullptr || std::strcmp(a.text_, b.text_) == 0) && a.verbatim_ == b.verbatim_ && a.arguments_ == b.arguments_ &&
         a.isNumeral_ == b.isNumeral_;
}

std::ostream& operator<<(std::ostream& out, const Message& message) { return out << message.english(); }

std::vector<std::string> english(const std::vector<Message>& messages) {
  std::vector<std::string> all;
  for (const Message& message : messages) all.push_back(message.english());
  return all;
}

Message MessageMaker::of(const char* text, std::vector<Message> arguments) {
  Message made;
  made.text_ = text;
  made.arguments_ = std::move(arguments);
  return made;
}

Message MessageMaker::joined(std::string between, std::vector<Message> parts) {
  std::erase_if(parts, [](const Message& part) { return part.empty(); });
  if (parts.size() == 1) return std::move(parts.front());
  Message made;
  if (!parts.empty()) made.verbatim_ = std::move(between);
  made.arguments_ = std::move(parts);
  return made;
}

Message MessageMaker::verbatim(std::string text) {
  Message made;
  made.verbatim_ = std::move(text);
  return made;
}

Message MessageMaker::numeral(std::string number) {
  Message made = verbatim(std::move(number));
  made.isNumeral_ = true;
  return made;
}

}  // namespace ew
