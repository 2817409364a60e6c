#include "ew/door/door.h"
#include "folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  static const auto folder = fuzz::ownFolder() / "plugins" / "one";
  std::filesystem::create_directories(folder);
  fuzz::put("plugins/one/plugin.json", {reinterpret_cast<const char*>(bytes), size});
  fuzz::put("plugins/one/libone.so", "no library");
  const auto manifest = door::readPluginManifest(folder);
  if (!manifest) {
    fuzz::checkSentence(manifest.error());
  } else {
    const auto relative = manifest->library.lexically_relative(std::filesystem::canonical(folder));
    fuzz::mustHold(!relative.empty() && *relative.begin() != "..");
  }
  const auto found = door::discoverPlugins({folder.parent_path()});
  fuzz::mustHold(found.size() == 1 && (found[0].sentence().empty() || found[0].sentence().ends_with('.')));
  return 0;
}
