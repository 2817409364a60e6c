#include "ew/io/safe_file.h"

#include <cerrno>
#include <exception>
#include <fstream>

#include "files/image_header.h"
#include "files/staging_file.h"

namespace ew {
namespace fs = std::filesystem;
namespace detail {

Result<StagingFile> StagingFile::create(const fs::path& target) {
  if (target.empty()) return notWritable(target, say<"it names no file">());
  StagingFile staged;
  staged.target_ = target;
  if (auto announced = staged.outputs_.announce(target); !announced) return passOn(announced.error());
  staged.aside_ = staged.outputs_.staged(target);
  errno = 0;
  staged.out_.open(staged.aside_, std::ios::binary);
  if (!staged.out_) return errno != 0 ? notWritable(target, errno) : notWritable(target, say<"its neighbour could not be opened">());
  return staged;
}

Result<void> finishStream(std::ofstream& out, const fs::path& target) {
  errno = 0;
  out.flush();
  const bool written = out.good();
  out.close();
  if (written && !out.fail()) return {};
  return errno != 0 ? notWritable(target, errno) : notWritable(target, say<"the medium is full or gone">());
}

Result<void> StagingFile::finish() { return finishStream(out_, target_); }

Result<void> StagingFile::commit() { return outputs_.commit(); }

}  // namespace detail

Result<void> writeFileSafely(const fs::path& file, const std::function<Result<void>(std::ostream&)>& write) {
  auto staged = detail::StagingFile::create(file);
  if (!staged) return passOn(staged.error());
  try {
    if (auto written = write(staged->stream()); !written) return written;
  } catch (const std::exception& thrown) {
    return failure(ErrorCode::internal, say<"\"%1\" was not written because of a fault in the program; try again.">(file.string()),
                   {{"file", file.string()}, {"reason", thrown.what()}});
  }
  if (auto finished = staged->finish(); !finished) return finished;
  return staged->commit();
}

Result<void> writeFileSafely(const fs::path& file, std::string_view text) {
  return writeFileSafely(file, [&](std::ostream& out) -> Result<void> {
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    return {};
  });
}

Result<std::string> readTextFile(const fs::path& file, std::size_t maxBytes) {
  if (const auto status = detail::checkIsFile(file); !status) return passOn(status.error());
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  if (!in) return notOpened(file, errno);
  // The size on disk is not asked for: files under /proc have none, and a growing file has an old one.
  std::string text;
  std::string chunk(64u << 10, '\0');
  while (in) {
    in.read(chunk.data(), static_cast<std::streamsize>(chunk.size()));
    text.append(chunk, 0, static_cast<std::size_t>(in.gcount()));
    if (text.size() > maxBytes)
      return failure(ErrorCode::tooLarge,
                     say<"%1 has more than the %2 bytes allowed here; check that it is the right file.">(detail::quoted(file), maxBytes),
                     {{"file", file.string()}, {"limit", std::to_string(maxBytes)}});
  }
  if (in.bad())
    return failure(ErrorCode::notReadable, say<"%1 cannot be read; check the medium it is on.">(detail::quoted(file)),
                   {{"file", file.string()}});
  return text;
}

}  // namespace ew
