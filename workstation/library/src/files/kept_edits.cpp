#include "ew/library/kept_edits.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <system_error>

#include "ew/core/json_fields.h"
#include "ew/io/safe_file.h"

namespace ew {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* kFile = "case-edits.json";
constexpr std::size_t kLargest_bytes = 8u << 20;  // a manifest has at most half of it

std::optional<KeptEdits::Left> read(const fs::path& folder) {
  const fs::path file = folder / kFile;
  const auto text = readTextFile(file, kLargest_bytes);
  if (!text) return std::nullopt;
  auto kept = parseJson(*text, verbatim(kFile));
  if (!kept || !kept->is_object()) return std::nullopt;
  const auto place = kept->find("case_folder"), manifest = kept->find("manifest"), size = kept->find("read_bytes"),
             hash = kept->find("read_hash");
  const auto end = kept->end();
  if (place == end || !place->is_string() || manifest == end || !manifest->is_object() || size == end || !size->is_number_unsigned() ||
      hash == end || !hash->is_number_unsigned())
    return std::nullopt;
  std::error_code failed;
  const auto written = fs::last_write_time(file, failed);
  if (failed) return std::nullopt;
  const auto age = fs::file_time_type::clock::now() - written;
  return KeptEdits::Left{folder,
                         place->get<std::string>(),
                         std::move(*manifest),
                         {size->get<std::uint64_t>(), hash->get<std::uint64_t>()},
                         std::chrono::system_clock::now() - std::chrono::duration_cast<std::chrono::system_clock::duration>(age)};
}

}  // namespace

KeptEdits::KeptEdits(fs::path root) : own_(std::move(root)) {}

KeptEdits::~KeptEdits() { forget(); }

Result<void> KeptEdits::keep(const Case& edited, const Fingerprint& asRead) {
  if (const std::string problem = own_.make(); !problem.empty())
    return failure(ErrorCode::notWritable,
                   say<"Unsaved changes of the case cannot be kept in '%1' (%2), so a crash would lose them; save the case often.">(
                       own_.root(), problem),
                   {{"folder", own_.root().string()}});
  const json kept = {{"case_folder", edited.folder.string()},
                     {"manifest", manifestOf(edited)},
                     {"read_bytes", asRead.size_bytes},
                     {"read_hash", asRead.hash}};
  return writeFileSafely(own_.path() / kFile, kept.dump(2, ' ', false, json::error_handler_t::replace) + "\n");
}

void KeptEdits::forget() { own_.remove(); }

std::vector<KeptEdits::Left> KeptEdits::left() const {
  std::vector<Left> found;
  for (const fs::path& folder : own_.left())
    if (auto left = read(folder)) found.push_back(std::move(*left));
  std::sort(found.begin(), found.end(), [](const Left& a, const Left& b) { return a.at > b.at; });
  return found;
}

void KeptEdits::remove(const Left& decided) {
  std::error_code ignored;
  fs::remove(decided.kept / kFile, ignored);
  fs::remove(decided.kept / OwnFolder::kLock, ignored);
  fs::remove(decided.kept, ignored);  // only when nothing else lies in it
}

}  // namespace ew
