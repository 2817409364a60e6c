// The bytes as what a folder of stitching results remembers: which inputs were read (inputs.json), which results were used (uses.txt), a
// result of a step, and the provenance of a finished volume.
#include "chain/file_contents.h"
#include "ew/io/step_store.h"
#include "ew/stitching/chain.h"
#include "ew/stitching/result_files.h"
#include "one_file.h"

namespace {

namespace fs = std::filesystem;

const std::string kKey(32, 'a');
const std::vector<std::string> kNames = {"steps/inputs.json", "steps/uses.txt", "provenance.json", "steps/volume/" + kKey + ".json"};

fs::path folderOfResults() {
  fs::path folder = ew::fuzz::asFile(nullptr, 0, ".file");
  folder.replace_extension(".folder");
  fs::create_directories(folder / "steps" / "volume");
  return folder;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace ew;
  static const fs::path folder = folderOfResults();
  for (const std::string& name : kNames)
    std::ofstream(folder / name, std::ios::binary).write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  stitching::FileContents contents(folder);
  if (const auto known = contents.keyOf(folder / "provenance.json", noProgress()); !known) fuzz::checkError(known.error());
  contents.save();
  const auto store = StepStore::peek(folder, stitching::stepFolders());
  static_cast<void>(store.find("volume", kKey));
  static_cast<void>(stitching::resultFilesIn(store));
  static_cast<void>(store.prune(~std::uint64_t{0}));
  if (const auto seen = stitching::ResultFiles::look(folder, {}, noProgress()); !seen) fuzz::checkError(seen.error());
  return 0;
}
