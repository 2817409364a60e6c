#include "run/arguments.h"

#include <array>
#include <charconv>
#include <cmath>

#include "ew/core/figures.h"
#include "ew/core/numbers.h"

namespace ew::cli {
namespace {

struct NumberList {
  std::string_view option;
  std::size_t count;
};
constexpr std::array kNumberLists{NumberList{"--pose", 16}, NumberList{"--clip", 4},       NumberList{"--blood", 3},
                                  NumberList{"--fan", 6},   NumberList{"--beam-fixed", 3}, NumberList{"--beam-moving", 3},
                                  NumberList{"--place", 6}};

std::string rangeText(Range range) { return "a number from " + textOf(range.lowest) + " to " + textOf(range.highest); }

double numberOr(const std::string& text, const std::string& name, Range range) {
  const auto value = parseNumber(text);
  if (!value || !std::isfinite(*value) || *value < range.lowest || *value > range.highest)
    throw CLI::ValidationError(name, "'" + text + "' cannot be used; give " + rangeText(range));
  return *value;
}

}  // namespace

CLI::Option& addNumber(CLI::App& app, const std::string& name, double& target, Range range, const std::string& description) {
  return *app.add_option_function<std::string>(
                 name, [&target, name, range](const std::string& text) { target = numberOr(text, name, range); }, description)
              ->type_name("NUMBER");
}

CLI::Option& addNumber(CLI::App& app, const std::string& name, std::optional<double>& target, Range range, const std::string& description) {
  return *app.add_option_function<std::string>(
                 name, [&target, name, range](const std::string& text) { target = numberOr(text, name, range); }, description)
              ->type_name("NUMBER");
}

template <class Target>
static CLI::Option& addCountTo(CLI::App& app, const std::string& name, Target& target, int lowest, int highest,
                               const std::string& description) {
  return *app.add_option_function<std::string>(
                 name,
                 [&target, name, lowest, highest](const std::string& text) {
                   const auto values = parseIntegers(text);
                   if (!values || values->size() != 1 || values->front() < lowest || values->front() > highest)
                     throw CLI::ValidationError(name, "'" + text + "' cannot be used; give a whole number from " + std::to_string(lowest) +
                                                          " to " + std::to_string(highest));
                   target = static_cast<int>(values->front());
                 },
                 description)
              ->type_name("COUNT");
}

CLI::Option& addCount(CLI::App& app, const std::string& name, int& target, int lowest, int highest, const std::string& description) {
  return addCountTo(app, name, target, lowest, highest, description);
}

CLI::Option& addCount(CLI::App& app, const std::string& name, std::optional<int>& target, int lowest, int highest,
                      const std::string& description) {
  return addCountTo(app, name, target, lowest, highest, description);
}

CLI::Option& addSeed(CLI::App& app, const std::string& name, std::uint64_t& target, const std::string& description) {
  return *app.add_option_function<std::string>(
                 name,
                 [&target, name](const std::string& text) {
                   std::uint64_t value = 0;
                   const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
                   if (error != std::errc{} || end != text.data() + text.size())
                     throw CLI::ValidationError(name, "'" + text + "' cannot be used; give a whole number of at least 0");
                   target = value;
                 },
                 description)
              ->type_name("SEED");
}

CLI::Option& addSize(CLI::App& app, const std::string& name, glm::ivec2& target, const std::string& description) {
  return *app.add_option_function<std::string>(
                 name,
                 [&target, name](const std::string& text) {
                   constexpr long long largest = 16384;
                   const auto cross = text.find_first_of("xX");
                   const auto width = cross == std::string::npos ? std::nullopt : parseIntegers(text.substr(0, cross));
                   const auto height = cross == std::string::npos ? std::nullopt : parseIntegers(text.substr(cross + 1));
                   const auto fits = [](const auto& v) { return v && v->size() == 1 && v->front() >= 1 && v->front() <= largest; };
                   if (!fits(width) || !fits(height))
                     throw CLI::ValidationError(
                         name, "'" + text + "' cannot be used; give width x height in pixels, as in 640x480, each from 1 to " +
                                   std::to_string(largest));
                   target = {static_cast<int>(width->front()), static_cast<int>(height->front())};
                 },
                 description)
              ->type_name("WxH");
}

CLI::Option& addNumberList(CLI::App& app, const std::string& name, std::optional<std::vector<double>>& target, std::size_t count,
                           const std::string& valueNames, const std::string& description) {
  return *app.add_option_function<std::string>(
                 name,
                 [&target, name, count](const std::string& text) {
                   auto values = parseNumbers(text);
                   bool finite = values.has_value();
                   if (values)
                     for (const double value : *values) finite = finite && std::isfinite(value);
                   if (!finite || values->size() != count)
                     throw CLI::ValidationError(name, "'" + text + "' cannot be used; give " + std::to_string(count) + " numbers");
                   target = std::move(*values);
                 },
                 description)
              ->type_name(valueNames);
}

std::vector<std::string> joinNumberLists(std::span<const std::string> args) {
  std::vector<std::string> joined;
  for (std::size_t at = 0; at < args.size(); ++at) {
    const std::string& word = args[at];
    std::size_t wanted = 1;
    for (const auto& list : kNumberLists)
      if (word == list.option) wanted = list.count;
    std::string value;
    std::size_t taken = 0;
    while (taken < wanted && at + 1 + taken < args.size() && parseNumber(args[at + 1 + taken])) {
      value += (value.empty() ? "" : " ") + args[at + 1 + taken];
      ++taken;
    }
    const bool isOption = word.starts_with("--") && word.find('=') == std::string::npos;
    if (isOption && taken > 1) {
      joined.push_back(word + "=" + value);
      at += taken;
    } else if (isOption && at + 1 < args.size() && args[at + 1].starts_with("-") && parseNumbers(args[at + 1])) {
      joined.push_back(word + "=" + args[at + 1]);
      at += 1;
    } else {
      joined.push_back(word);
    }
  }
  return joined;
}

Result<std::vector<Pose>> posesOf(const std::string& argument) {
  if (const auto numbers = parseNumbers(argument); numbers && numbers->size() % 16 != 0 && argument.find('\n') == std::string::npos)
    return failure(ErrorCode::badUsage,
                   say<"The pose has %1; give 16, row by row, from probe to world in mm, or the name of a file with one pose a line.">(
                       counted(numbers->size(), "number")));
  return posesFromArgument(argument);
}

std::filesystem::path numbered(const std::filesystem::path& file, std::size_t index, std::size_t count) {
  if (count <= 1) return file;
  std::string number = std::to_string(index);
  number.insert(0, 4 - std::min<std::size_t>(4, number.size()), '0');
  auto named = file;
  named.replace_filename(file.stem().string() + "_" + number + file.extension().string());
  return named;
}

std::string counted(std::size_t count, std::string_view noun) {
  return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

std::string rounded(double value, int digits) { return fixedText(value, digits); }

}  // namespace ew::cli
