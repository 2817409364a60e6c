#include "making/piece_journal.h"

#include <algorithm>
#include <array>
#include <utility>

#include "ew/io/content_key.h"

namespace ew {
namespace {

constexpr std::size_t kContent = 32;  // digits of what a piece holds
constexpr std::uint64_t kMark = 0x6365697065767765ull;
constexpr std::uint64_t kMost_bytes = 1ull << 32;

/// Before each piece.
struct Head {
  std::uint64_t mark = kMark;
  std::int64_t piece = 0;
  std::uint64_t bytes = 0;
  std::array<char, kContent> content{};
};
static_assert(sizeof(Head) == 24 + kContent);

std::string contentOfPiece(std::span<const std::uint8_t> bytes) { return ew::contentOf(std::as_bytes(bytes)); }

}  // namespace

PieceJournal::PieceJournal(std::filesystem::path file, std::function<void(double)> recalled)
    : file_(std::move(file)), recalled_(std::move(recalled)) {
  std::error_code ignored;
  std::filesystem::create_directories(file_.parent_path(), ignored);
  from_.open(file_, std::ios::binary);
  const std::uintmax_t size = std::filesystem::file_size(file_, ignored);
  std::uint64_t end = 0;
  for (Head head; from_.read(reinterpret_cast<char*>(&head), sizeof(head));) {
    const std::uint64_t at = end + sizeof(head);
    // A program that was killed while it wrote leaves the last piece cut off.
    if (head.mark != kMark || head.bytes > kMost_bytes || at + head.bytes > size) break;
    there_[static_cast<int>(head.piece)] = {at, head.bytes, std::string(head.content.begin(), head.content.end())};
    end = at + head.bytes;
    from_.seekg(static_cast<std::streamoff>(end));
  }
  if (end > 0)
    std::filesystem::resize_file(file_, end, ignored);
  else
    std::filesystem::remove(file_, ignored);
  to_.open(file_, std::ios::binary | std::ios::app);
}

bool PieceJournal::recall(int piece, std::vector<std::uint8_t>& bytes) {
  const auto found = there_.find(piece);
  if (found == there_.end()) return false;
  bytes.resize(found->second.bytes);
  from_.clear();
  from_.seekg(static_cast<std::streamoff>(found->second.at));
  from_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  return from_.good() && contentOfPiece(bytes) == found->second.content;
}

void PieceJournal::keep(int piece, std::span<const std::uint8_t> bytes) {
  Head head;
  head.piece = piece;
  head.bytes = bytes.size();
  const std::string content = contentOfPiece(bytes);
  std::copy_n(content.begin(), std::min(content.size(), kContent), head.content.begin());
  const std::lock_guard lock(guard_);
  to_.write(reinterpret_cast<const char*>(&head), sizeof(head));
  to_.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  to_.flush();
}

}  // namespace ew
