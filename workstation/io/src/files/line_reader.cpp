#include "files/line_reader.h"

#include <cerrno>

#include "ew/core/file_errors.h"
#include "files/image_header.h"

namespace ew::detail {
namespace {
constexpr std::size_t kLineChunk = 64u << 10;
constexpr std::size_t kLongestLine = 1u << 20;
constexpr std::uint64_t kLongestHeader = 512u << 20;
}  // namespace

LineReader::LineReader(const std::filesystem::path& file) : file_(file) {
  errno = 0;
  in_.open(file, std::ios::binary);
  if (!in_.is_open()) problem_ = errno;
}

Result<std::optional<std::string>> LineReader::next() {
  if (!in_.is_open()) return notOpened(file_, problem_);
  std::size_t searched = at_;
  for (;;) {
    const std::size_t end = buffer_.find('\n', searched);
    const bool complete = end != std::string::npos;
    if (complete || (in_.eof() && at_ < buffer_.size())) {
      std::string line = buffer_.substr(at_, (complete ? end : buffer_.size()) - at_);
      consumed_ += line.size() + (complete ? 1 : 0);
      at_ += line.size() + (complete ? 1 : 0);
      if (line.find('\0') != std::string::npos)
        return failure(ErrorCode::badHeader,
                       say<"%1 is not a text header followed by samples; check what kind of file it is.">(quoted(file_)),
                       {{"file", file_.string()}});
      if (line.ends_with('\r')) line.pop_back();
      return std::optional<std::string>(std::move(line));
    }
    if (in_.eof()) return std::optional<std::string>();
    if (buffer_.size() - at_ > kLongestLine)
      return failure(ErrorCode::badHeader, say<"%1 has a header line of more than 1 MiB; check what kind of file it is.">(quoted(file_)),
                     {{"file", file_.string()}});
    if (consumed_ > kLongestHeader)
      return failure(ErrorCode::tooLarge, say<"%1 has a header of more than 512 MiB; record fewer frames in one file.">(quoted(file_)),
                     {{"file", file_.string()}});
    buffer_.erase(0, at_);
    at_ = 0;
    searched = buffer_.size();
    const std::size_t before = buffer_.size();
    buffer_.resize(before + kLineChunk);
    in_.read(buffer_.data() + before, static_cast<std::streamsize>(kLineChunk));
    buffer_.resize(before + static_cast<std::size_t>(in_.gcount()));
    if (in_.bad())
      return failure(ErrorCode::notReadable, say<"%1 cannot be read; check the medium it is on.">(quoted(file_)),
                     {{"file", file_.string()}});
  }
}

}  // namespace ew::detail
