#pragma once

#include <memory>

namespace ew::sdk {

/// Keeps something in force until it is destroyed: a callback, the hold on the probe, an entry of a menu. A plugin that ends gives all of
/// its tickets back, whether it does so itself or not.
using Ticket = std::shared_ptr<void>;

}  // namespace ew::sdk
