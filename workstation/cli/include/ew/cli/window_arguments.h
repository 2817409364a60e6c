#pragma once

#include <glm/glm.hpp>
#include <span>
#include <string>

#include "ew/core/result.h"

namespace ew::cli {

/// What the words of a command line without a command ask of the window.
struct WindowWish {
  std::string open;        ///< case folder, case.json, volume or sweep; empty: nothing in particular
  std::string lesson;      ///< id of a lesson of that case; empty: none
  std::string launchedBy;  ///< a machine that wants to start a lesson: the learner is asked, and nothing else is done; empty: nobody
  bool startPage = false;
  std::string workspace;     ///< "explore", "author" or empty
  std::string theme;         ///< "dark", "light" or empty
  std::string screenshot;    ///< .png to write, or empty
  glm::ivec2 size_px{0, 0};  ///< (0, 0): not said
  bool operator==(const WindowWish&) const = default;
};

/// `[CASE|VOLUME|SWEEP] [--open FILE] [--lesson ID] [--launched-by HOST] [--screenshot OUT.png] [--theme dark|light] [--workspace
/// explore|author] [--start-page]
/// [--size WxH]`. The id of a shipped case becomes its folder. Needs no display.
/// @error badUsage; notFound (what should be opened is not there); notWritable (the screenshot)
[[nodiscard]] Result<WindowWish> windowArguments(std::span<const std::string> args);

}  // namespace ew::cli
