#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <iosfwd>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace ew {

/// What a library tells a person, before it is put into a language: an English text with places %1 to %9, and what stands there. Commands,
/// logs and reports write english(); the window asks its translator for the text (context kMessageContext) and puts the same arguments into
/// that. An argument is a message too: a name or a number that every language writes alike (verbatim), or words with a text of their own.
///
///     return failure(ErrorCode::notReadable, say<"%1 cannot be read (%2); check its permissions.">(quoted(file), verbatim(why)));
///
/// Made by say(), verbatim() and joined() alone, so that no sentence reaches the window that it cannot translate.
class Message {
 public:
  Message() = default;  ///< nothing

  /// The text to translate, valid as long as the program runs; null of what is verbatim, joined or nothing.
  [[nodiscard]] const char* text() const { return text_; }
  /// Of a text: what stands at %1, %2, ... Of joined messages: the messages.
  [[nodiscard]] const std::vector<Message>& arguments() const { return arguments_; }
  /// What every language writes alike; of joined messages, what stands between them.
  [[nodiscard]] const std::string& verbatim() const { return verbatim_; }
  /// A number with its decimals, in the C locale: the window writes its point as its language does.
  [[nodiscard]] bool isNumeral() const { return isNumeral_; }
  [[nodiscard]] bool empty() const { return text_ == nullptr && verbatim_.empty() && arguments_.empty(); }
  [[nodiscard]] std::string english() const;
  /// The same with every verbatim part replaced by what `change` makes of it: names of files, for instance.
  [[nodiscard]] Message withVerbatim(const std::function<std::string(std::string)>& change) const;

  friend bool operator==(const Message& a, const Message& b);

 private:
  friend struct MessageMaker;
  const char* text_ = nullptr;
  std::string verbatim_;
  std::vector<Message> arguments_;
  bool isNumeral_ = false;
};
std::ostream& operator<<(std::ostream& out, const Message& message);  ///< english()
[[nodiscard]] std::vector<std::string> english(const std::vector<Message>& messages);

/// The context in which translators find the texts of messages.
inline constexpr const char* kMessageContext = "ew::Message";

/// Puts arguments to the places of a text, whatever the language; what is put in is not searched for places.
/// @param argument what stands at %n; nothing happens to places beyond the arguments
[[nodiscard]] std::string filledIn(std::string_view text, const std::vector<std::string>& arguments);

/// A text that is known when the program is compiled.
template <std::size_t N>
struct Literal {
  char text[N];
  consteval Literal(const char (&given)[N]) {  // NOLINT: made of a string literal
    for (std::size_t n = 0; n < N; ++n) text[n] = given[n];
  }
  /// The highest place when all from %1 on are there; -1 when one is missing.
  [[nodiscard]] consteval int places() const {
    bool there[10] = {};
    int highest = 0;
    for (std::size_t n = 0; n + 1 < N; ++n) {
      if (text[n] != '%' || text[n + 1] < '1' || text[n + 1] > '9') continue;
      there[text[n + 1] - '0'] = true;
      highest = std::max(highest, text[n + 1] - '0');
    }
    for (int n = 1; n <= highest; ++n)
      if (!there[n]) return -1;
    return highest;
  }
};

/// A text of say() somewhere in the program and its plugins, in a list that begins at firstMessageText(). A test walks it: each has to have
/// its translation.
struct MessageText {
  explicit MessageText(const char* text);
  const char* text;
  const MessageText* next;
};
[[nodiscard]] const MessageText* firstMessageText();

/// Makes messages; the way in for the functions below.
struct MessageMaker {
  [[nodiscard]] static Message of(const char* text, std::vector<Message> arguments);
  [[nodiscard]] static Message joined(std::string between, std::vector<Message> parts);
  [[nodiscard]] static Message verbatim(std::string text);
  [[nodiscard]] static Message numeral(std::string number);

  template <Literal text>
  struct Listed {
    inline static const MessageText here{text.text};
  };
  [[nodiscard]] static Message argument(Message message) { return message; }
  [[nodiscard]] static Message argument(std::string name) { return verbatim(std::move(name)); }
  [[nodiscard]] static Message argument(const std::filesystem::path& name) { return verbatim(name.string()); }
  template <std::integral Number>
  [[nodiscard]] static Message argument(Number number) {
    return verbatim(std::to_string(number));
  }
  static Message argument(bool) = delete;
  static Message argument(char) = delete;
  static Message argument(const char*) = delete;  ///< words need say(), names and what other programs say need verbatim()
};

/// A name, a number, what another program says: it reads the same in every language.
[[nodiscard]] inline Message verbatim(std::string text) { return MessageMaker::verbatim(std::move(text)); }

/// A number with decimals, written in the C locale by who knows how many it deserves: "0.8" reads "0,8" in a German sentence.
[[nodiscard]] inline Message numeral(std::string number) { return MessageMaker::numeral(std::move(number)); }

/// Sentences one after another, or the parts of a list.
[[nodiscard]] inline Message joined(std::vector<Message> parts, std::string between = " ") {
  return MessageMaker::joined(std::move(between), std::move(parts));
}

/// A message of an English text. The number of its places is compared with that of the arguments when the program is compiled.
/// @param arguments messages, std::string for names, whole numbers; a number with decimals is a numeral()
template <Literal text, class... Arguments>
[[nodiscard]] Message say(Arguments&&... arguments) {
  static_assert(text.places() >= 0, "the places of a message are %1, %2, ... without a gap");
  static_assert(text.places() == static_cast<int>(sizeof...(Arguments)), "a message needs one argument for each of its places");
  std::vector<Message> made;
  made.reserve(sizeof...(Arguments));
  (made.push_back(MessageMaker::argument(std::forward<Arguments>(arguments))), ...);
  return MessageMaker::of(MessageMaker::Listed<text>::here.text, std::move(made));
}

}  // namespace ew
