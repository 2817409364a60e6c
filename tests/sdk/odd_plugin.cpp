// Plugins that misbehave, one per value of ODD: what the door must turn into a sentence.
#include <stdexcept>

#include "ew/sdk/plugin.h"

#define ODD_EMPTY 0
#define ODD_ABI 1
#define ODD_THROWS 2
#define ODD_NUMBER 3
#define ODD_NULL 4
#define ODD_GOOD 5

#if ODD == ODD_EMPTY
extern "C" EW_EXPORT int someFunction() { return 7; }
#else
namespace {
class Good final : public ew::sdk::Plugin {
 public:
  explicit Good(ew::sdk::Host& host) {
    host.commands().add("throw", "throw", [](const std::vector<std::string>&, ew::Progress&) -> ew::Result<ew::sdk::Commands::Outcome> {
      throw std::runtime_error("out of cheese");
    });
  }
};
}  // namespace

extern "C" EW_EXPORT std::uint32_t ewPluginAbi() { return ODD == ODD_ABI ? 65537u : ew::sdk::kAbi; }
extern "C" EW_EXPORT ew::sdk::Plugin* ewPluginCreate(ew::sdk::Host& host) {
  if (ODD == ODD_THROWS) throw std::runtime_error("no licence for the moon");
  if (ODD == ODD_NUMBER) throw 42;
  if (ODD == ODD_NULL) return nullptr;
  return new Good(host);
}
extern "C" EW_EXPORT void ewPluginDestroy(ew::sdk::Plugin* plugin) { delete plugin; }
#endif
