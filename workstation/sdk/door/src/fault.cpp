#include "ew/door/fault.h"

namespace ew::door {

Message messageOf(const PluginFault& fault) {
  const auto& [plugin, moment, what, thrown] = fault;
  switch (moment) {
    case PluginMoment::start:
      return say<"The plugin '%1' could not start (%2); the rest of the program is not affected.">(plugin, thrown.reason);
    case PluginMoment::panel:
      return say<"The panel '%1' of the plugin '%2' could not be opened (%3); the rest of the program is not affected.">(what, plugin,
                                                                                                                         thrown.reason);
    case PluginMoment::command:
      if (thrown.noMemory)
        return say<"There is not enough memory for '%1' of the plugin '%2'; use a coarser spacing or a smaller input.">(what, plugin);
      return say<"The command '%1' of the plugin '%2' stopped unexpectedly (%3); please report it with the command you gave.">(
          what, plugin, thrown.reason);
    case PluginMoment::job:
      if (thrown.noMemory)
        return say<"There is not enough memory for '%1' of the plugin '%2'; close other programs or choose a coarser spacing.">(what,
                                                                                                                                plugin);
      return say<"'%1' of the plugin '%2' stopped unexpectedly (%3); please report it with what you did.">(what, plugin, thrown.reason);
    case PluginMoment::jobDone:
      return say<"The plugin '%1' could not take over the result of '%2' (%3); please report it with what you did.">(plugin, what,
                                                                                                                     thrown.reason);
    case PluginMoment::caseChanged:
      return say<"The plugin '%1' could not follow a change of the case (%2); what its panel shows may be out of date.">(plugin,
                                                                                                                         thrown.reason);
    case PluginMoment::undo:
      return say<"The plugin '%1' could not undo the last step (%2); save under another name before you go on.">(plugin, thrown.reason);
    case PluginMoment::redo:
      return say<"The plugin '%1' could not redo the step (%2); save under another name before you go on.">(plugin, thrown.reason);
    case PluginMoment::save:
      return say<"The plugin '%1' could not save (%2); try another name or folder.">(plugin, thrown.reason);
    case PluginMoment::document:
      return say<"The plugin '%1' could not say what its panel holds (%2); save under another name before you go on.">(plugin,
                                                                                                                       thrown.reason);
    case PluginMoment::scan:
      return say<"The plugin '%1' could not follow the scan (%2); what it shows may be out of date.">(plugin, thrown.reason);
    case PluginMoment::drive:
      return say<"The plugin '%1' could not move the probe (%2); press Escape to take the probe back.">(plugin, thrown.reason);
    case PluginMoment::menu:
      return say<"'%1' of the plugin '%2' did not come to its end (%3); please report it with what you did.">(what, plugin, thrown.reason);
    case PluginMoment::closing:
      return say<"The plugin '%1' could not say what it still holds (%2); save your work before you close the window.">(plugin,
                                                                                                                        thrown.reason);
    case PluginMoment::event:
      return say<"The plugin '%1' met a problem that it did not foresee (%2); save your work, and please report it with what you did.">(
          plugin, thrown.reason);
    case PluginMoment::end:
      return say<"The plugin '%1' did not end in order (%2); nothing of your work is affected.">(plugin, thrown.reason);
  }
  return say<"The plugin '%1' failed (%2).">(plugin, thrown.reason);
}

Error errorOf(const PluginFault& fault) {
  return {fault.thrown.noMemory ? ErrorCode::tooLarge : ErrorCode::internal, messageOf(fault), {{"plugin", fault.plugin}}};
}

}  // namespace ew::door
