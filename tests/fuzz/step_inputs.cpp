// The bytes as what a folder of stitching results remembers: which inputs were read (inputs.json), which results were used (uses.txt), a
// result of a step, and the provenance of a finished volume.
#include "logic/file_contents.h"
#include "logic/result_files.h"
#include "logic/step_store.h"
#include "one_text.h"

namespace {

namespace fs = std::filesystem;

const std::string kKey(32, 'a');

/// In which all of these are, whatever they hold: their text comes from a door of its own.
fs::path folderOfResults() {
  fs::path folder = ew::fuzz::asFile(nullptr, 0, ".file");
  folder.replace_extension(".folder");
  fs::create_directories(folder / "steps" / "volume");
  for (const std::string& name :
       {std::string("steps/inputs.json"), std::string("steps/uses.txt"), std::string("provenance.json"), "steps/volume/" + kKey + ".json"})
    std::ofstream(folder / name) << "x";
  return folder;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  static const fs::path folder = folderOfResults();
  fuzz::OneText files(std::string(reinterpret_cast<const char*>(bytes), size));
  stitching::FileContents contents(folder, files);
  if (const auto known = contents.keyOf(folder / "provenance.json", noProgress()); !known) fuzz::checkError(known.error());
  contents.save();
  const auto store = stitching::StepStore::peek(folder, files);
  static_cast<void>(store.find("volume", kKey));
  static_cast<void>(stitching::resultFilesIn(store));
  static_cast<void>(store.prune(~std::uint64_t{0}));
  if (const auto seen = stitching::ResultFiles::look(folder, {}, files, noProgress()); !seen) fuzz::checkError(seen.error());
  return 0;
}
