#include "ew/sdk/plugin.h"

namespace {

class ReviewPlugin final : public ew::sdk::Plugin {
 public:
  explicit ReviewPlugin(ew::sdk::Host&) {}
};

}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) { return new ReviewPlugin(host); }
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
