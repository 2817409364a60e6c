#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>

#include "ew/core/message.h"
#include "ew/core/result.h"

namespace ew {

/// What messages say in another language, for a report that is written where there is no window: read from the very catalogue that the
/// window's words are made of, a file of Qt's translators (.ts). Without one (English) messages stay as they are.
class MessageCatalogue {
 public:
  /// Of the program's own catalogues. @param language "en", "de" @error notFound, badHeader
  [[nodiscard]] static Result<MessageCatalogue> ofLanguage(const std::string& language);
  /// @error notReadable, badHeader (not well-formed XML)
  [[nodiscard]] static Result<MessageCatalogue> read(const std::filesystem::path& file);

  /// As the window's words(Message): a text that has no translation stays English, and a number has the language's decimal point.
  [[nodiscard]] std::string words(const Message& message) const;

 private:
  std::unordered_map<std::string, std::string> translations_;  ///< of the context kMessageContext, by the English text
  char point_ = '.';
};

}  // namespace ew
