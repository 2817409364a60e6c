#pragma once

#include <glm/glm.hpp>
#include <string>

namespace ew::ui {

/// How the workstation starts.
struct WindowOptions {
  std::string open;          ///< case folder, case.json, volume or sweep; empty: the first shipped case
  std::string lesson;        ///< id of a lesson of the case that is opened, to begin or go on with; empty: none
  std::string launchedBy;    ///< a machine that wants to start a lesson here: the learner is asked, and nothing else is done
  bool startPage = false;    ///< show the start page instead of opening anything
  std::string workspace;     ///< "explore" or "author"; empty: explore
  std::string theme;         ///< "dark" or "light"; empty: as it was left, dark on the first start
  std::string screenshot;    ///< write the image of the window to this .png once everything is drawn, then end; empty: stay open
  glm::ivec2 size_px{0, 0};  ///< of the window's inside; (0, 0): as it was left, or 1600 x 900 for a screenshot
};

/// Opens the window and runs until it is closed. Needs a display (X); whoever calls checks that there is one, because Qt ends the
/// program when there is none.
/// @return 0; 1 when the learner does not want what `launchedBy` wants, or when a screenshot was asked for and could not be made (one
/// sentence on stderr says why)
int runWorkstation(int argc, char** argv, const WindowOptions& options);

}  // namespace ew::ui
