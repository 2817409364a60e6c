#include "ew/library/checksums.h"

#include <openssl/evp.h>

#include <algorithm>
#include <array>
#include <new>
#include <nlohmann/json.hpp>

#include "ew/core/data_file.h"
#include "ew/core/json_fields.h"
#include "ew/io/json_files.h"
#include "ew/io/safe_file.h"
#include "files/file_pieces.h"

namespace ew {
namespace {

namespace fs = std::filesystem;

constexpr int kSumsFormat = 1;
constexpr std::size_t kLargestSums_bytes = 64u << 20;

bool isHexadecimal(const std::string& text) {
  return std::all_of(text.begin(), text.end(), [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

}  // namespace

struct Sha256::Context {
  EVP_MD_CTX* digest = EVP_MD_CTX_new();
  Context() {
    if (digest == nullptr || EVP_DigestInit_ex(digest, EVP_sha256(), nullptr) != 1) throw std::bad_alloc();
  }
  ~Context() { EVP_MD_CTX_free(digest); }
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
};

Sha256::Sha256() : context_(std::make_unique<Context>()) {}
Sha256::~Sha256() = default;
Sha256::Sha256(Sha256&&) noexcept = default;
Sha256& Sha256::operator=(Sha256&&) noexcept = default;

void Sha256::add(std::span<const std::byte> bytes) {
  if (EVP_DigestUpdate(context_->digest, bytes.data(), bytes.size()) != 1) throw std::bad_alloc();
}

std::string Sha256::hex() {
  std::array<unsigned char, 32> digest{};
  if (EVP_DigestFinal_ex(context_->digest, digest.data(), nullptr) != 1) throw std::bad_alloc();
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : digest) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

Result<std::string> sha256Of(const fs::path& file, Progress& progress) {
  std::error_code ignored;
  const auto size = fs::file_size(file, ignored);
  ByteCount count(say<"Adding up sums">(), ignored ? 0 : size, progress);
  auto sum = sumInPieces(file, count);
  if (!sum) return passOn(sum.error());
  return std::move(sum->sha256);
}

Result<std::vector<FileSum>> sumsOfCase(const fs::path& folder, Progress& progress) {
  auto files = filesOfCase(folder);
  if (!files) return files;
  ByteCount count(say<"Adding up sums">(), bytesOf(*files), progress);
  for (FileSum& each : *files) {
    auto sum = sumInPieces(folder / each.path, count);
    if (!sum) return passOn(sum.error());
    each.size_bytes = sum->size_bytes;
    each.sha256 = std::move(sum->sha256);
  }
  return files;
}

std::vector<FileSum> fileSumsIn(const JsonFields& document, const CaseFileLimits& limits) {
  std::vector<FileSum> files;
  constexpr long long kLargestFile_bytes = 1ll << 52;
  for (const JsonFields& each : document.objects("files", 1, limits.maxFiles)) {
    each.only({"path", "size", "sha256"});
    FileSum file;
    file.path = each.text("path", {}, 1, 4096);
    file.size_bytes = static_cast<std::uint64_t>(each.whole("size", 0, kLargestFile_bytes));
    file.sha256 = each.text("sha256", {}, 64, 64);
    if (document.good() && !isHexadecimal(file.sha256)) each.refuse("sha256", say<"64 hexadecimal digits in small letters">());
    if (!document.good()) return {};
    files.push_back(std::move(file));
  }
  return files;
}

nlohmann::ordered_json jsonOf(const std::vector<FileSum>& files) {
  auto list = nlohmann::ordered_json::array();
  for (const FileSum& each : files) list.push_back({{"path", each.path}, {"size", each.size_bytes}, {"sha256", each.sha256}});
  return list;
}

Result<void> writeSums(const std::vector<FileSum>& files, const fs::path& folder) {
  const nlohmann::ordered_json document = {{"format", kSumsFormat}, {"files", jsonOf(files)}};
  return writeFileSafely(folder / kSumsName, document.dump(1) + "\n");
}

Result<std::vector<FileSum>> readSums(const fs::path& folder) {
  const fs::path file = folder / kSumsName;
  const auto document = readJsonFile(file, verbatim(file.string()), kLargestSums_bytes);
  if (!document) return passOn(document.error());
  JsonReading reading(verbatim(file.string()));
  const JsonFields fields(*document, reading);
  requireFormat(fields, kSumsFormat);
  fields.only({"format", "files"});
  auto files = fileSumsIn(fields);
  if (reading.problem()) return passOn(*reading.problem());
  if (auto good = checkFileList(files, say<"The file '%1'">(file)); !good) return passOn(good.error());
  return files;
}

}  // namespace ew
