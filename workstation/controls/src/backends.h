#pragma once

#include "ew/controls/hub.h"

namespace ew::controls {

[[nodiscard]] std::unique_ptr<Backend> midiBackend();
[[nodiscard]] std::unique_ptr<Backend> hidBackend();

/// "nanoKONTROL2:nanoKONTROL2 _ CTRL 20:0" without the numbers, which are others when it is plugged in again, and without saying twice what
/// it is called: "nanoKONTROL2 _ CTRL".
[[nodiscard]] std::string lastingPortName(const std::string& port);

}  // namespace ew::controls
