#include "ew/reports/message_catalogue.h"

#include <algorithm>
#include <pugixml.hpp>
#include <string_view>
#include <vector>

#include "ew/io/safe_file.h"
#include "ew/library/folders.h"

namespace ew {
namespace {

constexpr std::size_t kLargestCatalogue_bytes = 64u << 20;

char decimalPointOf(std::string_view language) { return language.starts_with("de") ? ',' : '.'; }

}  // namespace

Result<MessageCatalogue> MessageCatalogue::ofLanguage(const std::string& language) {
  if (language.empty() || language == "en") return MessageCatalogue();
  const auto resources = resourceFolder();
  if (!resources) return passOn(resources.error());
  return read(*resources / "translations" / ("echoweave_" + language + ".ts"));
}

Result<MessageCatalogue> MessageCatalogue::read(const std::filesystem::path& file) {
  const auto text = readTextFile(file, kLargestCatalogue_bytes);
  if (!text) return passOn(text.error());
  pugi::xml_document document;
  if (const auto parsed = document.load_buffer(text->data(), text->size()); !parsed)
    return failure(ErrorCode::badHeader,
                   say<"The translations '%1' cannot be read (%2 at byte %3); install the program again.">(
                       file, verbatim(parsed.description()), parsed.offset),
                   {{"file", file.string()}});
  MessageCatalogue made;
  const pugi::xml_node root = document.child("TS");
  made.point_ = decimalPointOf(root.attribute("language").value());
  for (const pugi::xml_node context : root.children("context")) {
    if (std::string_view(context.child_value("name")) != kMessageContext) continue;
    for (const pugi::xml_node message : context.children("message")) {
      const pugi::xml_node translation = message.child("translation");
      const bool isMeant = translation.attribute("type").empty();  // neither unfinished nor gone
      if (isMeant && *translation.child_value() != '\0') made.translations_[message.child_value("source")] = translation.child_value();
    }
  }
  return made;
}

std::string MessageCatalogue::words(const Message& message) const {
  std::vector<std::string> parts;
  for (const Message& argument : message.arguments()) parts.push_back(words(argument));
  if (message.text() != nullptr) {
    const auto found = translations_.find(message.text());
    return filledIn(found != translations_.end() ? std::string_view(found->second) : std::string_view(message.text()), parts);
  }
  std::string all = message.verbatim();
  if (message.isNumeral()) std::replace(all.begin(), all.end(), '.', point_);
  if (parts.empty()) return all;
  std::string joined = parts.front();
  for (std::size_t n = 1; n < parts.size(); ++n) joined += message.verbatim() + parts[n];
  return joined;
}

}  // namespace ew
