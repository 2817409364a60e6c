#include "recipe.h"

#include <fstream>
#include <system_error>

namespace ew::phantom {
namespace {

constexpr std::uintmax_t kLargestRecipe_bytes = 8u << 20;
constexpr std::size_t kLongestName = 200;
constexpr std::size_t kLongestText = 10000;

/// Sentences and places are put together from names and texts: one of megabytes would be copied for every field below it.
void refuseLongTexts(JsonReading& reading, const nlohmann::json& value, const std::string& field) {
  if (!reading.good()) return;
  if (value.is_string() && value.get_ref<const std::string&>().size() > kLongestText)
    return reading.refuse(field, shown(value), "a text of at most " + std::to_string(kLongestText) + " bytes");
  if (value.is_object()) {
    for (const auto& [name, inner] : value.items()) {
      if (name.size() > kLongestName)
        return reading.refuse(name.substr(0, 57) + "...", "a name of " + std::to_string(name.size()) + " bytes",
                              "one of at most " + std::to_string(kLongestName));
      refuseLongTexts(reading, inner, name);
    }
  } else if (value.is_array()) {
    for (const auto& inner : value) refuseLongTexts(reading, inner, field);
  }
}

}  // namespace

JsonReading readingOf(const std::filesystem::path& file) { return JsonReading(file.string(), {"name", "note", "source"}); }

Result<nlohmann::json> readRecipe(const std::filesystem::path& file, const std::string& kind) {
  const std::string name = file.string();
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed))
    return failure(ErrorCode::notFound, "There is no " + kind + " at " + name + "; check the path.", {{"file", name}});
  const auto size = std::filesystem::file_size(file, failed);
  if (failed || size > kLargestRecipe_bytes)
    return failure(ErrorCode::tooLarge, name + " is larger than a " + kind + " can be (8 MiB); check that it is the right file.",
                   {{"file", name}});
  std::ifstream in(file, std::ios::binary);
  if (!in) return failure(ErrorCode::notReadable, name + " cannot be opened; check its permissions.", {{"file", name}});
  std::string text(static_cast<std::size_t>(size), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  auto recipe = parseJsonObject(text, "The " + kind + " " + name);
  if (!recipe) return passOn(recipe.error());
  JsonReading reading = readingOf(file);
  refuseLongTexts(reading, *recipe, "");
  const auto format = JsonFields(*recipe, reading).whole("format", 1, 1000000);
  if (reading.problem()) return passOn(*reading.problem());
  if (format > 1)
    return failure(ErrorCode::newerFormat,
                   name + " has format " + std::to_string(format) + ", this program reads up to format 1; open it with a newer EchoWeave.",
                   {{"file", name}, {"format", std::to_string(format)}, {"supported", "1"}});
  return recipe;
}

}  // namespace ew::phantom
