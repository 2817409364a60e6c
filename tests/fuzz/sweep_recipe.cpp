#include "ew/phantom/virtual_sweep.h"
#include "folder.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  const auto file = fuzz::put("sweep.json", {reinterpret_cast<const char*>(bytes), size});
  const auto recipe = readSweepRecipe(file);
  if (!recipe) {
    fuzz::checkSentence(recipe.error());
    return 0;
  }
  fuzz::mustHold(recipe->frames >= 1 && !recipe->stations.empty() && !recipe->name.empty());
  return 0;
}
