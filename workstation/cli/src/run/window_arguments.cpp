#include "ew/cli/window_arguments.h"

#include <filesystem>

#include "run/arguments.h"
#include "run/volume_input.h"

namespace ew::cli {

Result<WindowWish> windowArguments(std::span<const std::string> args) {
  WindowWish wish;
  CLI::App app("EchoWeave", "echoweave");
  app.set_help_flag();  // the command has it
  std::string open;
  app.add_option("OPEN", wish.open);
  app.add_option("--open", open);
  app.add_option("--lesson", wish.lesson);
  app.add_option("--launched-by", wish.launchedBy);
  app.add_option("--screenshot", wish.screenshot);
  app.add_option("--theme", wish.theme)->check(CLI::IsMember({"dark", "light"}));
  app.add_option("--workspace", wish.workspace)->check(CLI::IsMember({"explore", "author"}));
  app.add_flag("--start-page", wish.startPage);
  addSize(app, "--size", wish.size_px, "");
  try {
    std::vector<std::string> words(args.rbegin(), args.rend());  // CLI11 takes the words from the back
    app.parse(words);
  } catch (const CLI::ParseError& error) {
    return failure(ErrorCode::badUsage, say<"%1; 'echoweave --help' shows what the window understands.">(std::string(error.what())));
  }
  if (!open.empty() && !wish.open.empty())
    return failure(ErrorCode::badUsage, say<"Both '%1' and '%2' should be opened; give one of them.">(wish.open, open));
  if (wish.open.empty()) wish.open = open;
  if (!wish.open.empty()) {
    std::error_code ignored;
    if (!std::filesystem::exists(wish.open, ignored)) {
      if (!meansCase(wish.open))
        return failure(ErrorCode::notFound, say<"There is no file '%1'; give a case, a volume or a sweep that exists.">(wish.open),
                       {{"file", wish.open}});
      const auto found = findCase(wish.open);
      if (!found) return passOn(found.error());
      wish.open = found->folder.string();
    }
  }
  if (!wish.lesson.empty() && wish.open.empty())
    return failure(ErrorCode::badUsage, say<"The lesson '%1' is of no case; name the case that has it as well.">(wish.lesson));
  if (!wish.screenshot.empty()) {
    OutputSet outputs;
    if (auto writable = outputs.announce(wish.screenshot, ".png"); !writable) return passOn(writable.error());
  }
  return wish;
}

}  // namespace ew::cli
