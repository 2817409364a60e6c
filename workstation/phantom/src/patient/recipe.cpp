#include "patient/recipe.h"

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
    return reading.refuse(field, shown(value), say<"a text of at most %1 bytes">(kLongestText));
  if (value.is_object()) {
    for (const auto& [name, inner] : value.items()) {
      if (name.size() > kLongestName)
        return reading.refuse(name.substr(0, 57) + "...", say<"a name of %1 bytes">(name.size()), say<"one of at most %1">(kLongestName));
      refuseLongTexts(reading, inner, name);
    }
  } else if (value.is_array()) {
    for (const auto& inner : value) refuseLongTexts(reading, inner, field);
  }
}

}  // namespace

JsonReading readingOf(const std::filesystem::path& file) { return JsonReading(verbatim(file.string()), {"name", "note", "source"}); }

Result<nlohmann::json> readRecipe(const std::filesystem::path& file, const Message& kind) {
  const std::string name = file.string();
  std::error_code failed;
  if (!std::filesystem::is_regular_file(file, failed))
    return failure(ErrorCode::notFound, say<"There is no %1 at %2; check the path.">(kind, name), {{"file", name}});
  const auto size = std::filesystem::file_size(file, failed);
  if (failed || size > kLargestRecipe_bytes)
    return failure(ErrorCode::tooLarge, say<"%1 is larger than a %2 can be (8 MiB); check that it is the right file.">(name, kind),
                   {{"file", name}});
  std::ifstream in(file, std::ios::binary);
  if (!in) return failure(ErrorCode::notReadable, say<"%1 cannot be opened; check its permissions.">(name), {{"file", name}});
  std::string text(static_cast<std::size_t>(size), '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  auto recipe = parseJsonObject(text, say<"The %1 %2">(kind, name));
  if (!recipe) return passOn(recipe.error());
  JsonReading reading = readingOf(file);
  refuseLongTexts(reading, *recipe, "");
  const auto format = JsonFields(*recipe, reading).whole("format", 1, 1000000);
  if (reading.problem()) return passOn(*reading.problem());
  if (format > 1)
    return failure(ErrorCode::newerFormat,
                   say<"%1 has format %2, this program reads up to format 1; open it with a newer EchoWeave.">(name, format),
                   {{"file", name}, {"format", std::to_string(format)}, {"supported", "1"}});
  return recipe;
}

}  // namespace ew::phantom
