#pragma once

#include <string>

#include "ew/core/guarded.h"

namespace ew::door {

/// When a plugin threw something, seen from the door.
enum class PluginMoment {
  start,        ///< it was created, and what it registered was put into place
  panel,        ///< a panel or its stage was made
  command,      ///< a command ran
  job,          ///< the work of a job, on its thread
  jobDone,      ///< a job's result was handed over
  caseChanged,  ///< it was told that the open case changed, or that another one is open
  undo,         ///< of its PanelDocument
  redo,
  save,
  document,  ///< its PanelDocument was asked for title, remark, note, texts, or to tell of changes
  scan,      ///< it was told what happens in the scan
  drive,     ///< it was asked where the probe is, while it moves it
  menu,      ///< an entry of a menu was chosen
  closing,   ///< it was asked what would be lost
  event,     ///< a widget of its panel handled a click, a key, a timer
  end        ///< it was destroyed
};

/// One exception of a plugin, caught at the door.
struct PluginFault {
  std::string plugin;  ///< its title
  PluginMoment moment = PluginMoment::start;
  std::string what;  ///< the command, the panel or the job by the name a user sees; empty where there is only one
  Thrown thrown;
};

/// What happened and what to do.
[[nodiscard]] Message messageOf(const PluginFault& fault);
/// For callers that want an Error: tooLarge or internal, with the message.
[[nodiscard]] Error errorOf(const PluginFault& fault);

}  // namespace ew::door
