#include "dicom/packed_frame.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <thread>

#include "dicom/packed_module.h"
#include "files/own_module.h"

namespace ew::detail {
namespace {

std::uint64_t big16(Bytes bytes, std::size_t at) { return static_cast<std::uint64_t>(bytes[at]) << 8 | bytes[at + 1]; }
std::uint64_t big32(Bytes bytes, std::size_t at) { return big16(bytes, at) << 16 | big16(bytes, at + 2); }

/// Markers of a JPEG or JPEG-LS stream up to the first scan.
std::optional<CodecHeader> jpegHead(Bytes stream, bool lossless_ls) {
  if (stream.size() < 4 || stream[0] != 0xFF || stream[1] != 0xD8) return std::nullopt;
  CodecHeader head;
  bool framed = false;
  for (std::size_t at = 2; at + 4 <= stream.size();) {
    if (stream[at] != 0xFF) return std::nullopt;
    const int marker = stream[at + 1];
    if (marker == 0xFF) {  // fill byte
      ++at;
      continue;
    }
    const std::size_t length = big16(stream, at + 2);
    if (length < 2 || length > stream.size() - at - 2) return std::nullopt;
    const Bytes body = stream.subspan(at + 4, length - 2);
    const bool isFrame =
        lossless_ls ? marker == 0xF7 : (marker >= 0xC0 && marker <= 0xC3) || marker == 0xC5 || marker == 0xC6 || marker == 0xC7;
    if (marker >= 0xC8 && marker <= 0xCF && marker != 0xCC) return std::nullopt;  // arithmetic coding: no decoder here
    if (isFrame) {
      // A second frame head could promise another size than the first.
      if (framed || body.size() < 6) return std::nullopt;
      head.bits = body[0];
      head.height = big16(body, 1);
      head.width = big16(body, 3);
      head.components = body[5];
      if (body.size() < 6 + 3 * static_cast<std::size_t>(head.components)) return std::nullopt;
      framed = true;
    } else if (marker == 0xE0 && body.size() >= 5 && std::memcmp(body.data(), "JFIF", 5) == 0) {
      head.namesColours = true;
      head.lumaChroma = true;
    } else if (marker == 0xEE && body.size() >= 12 && std::memcmp(body.data(), "Adobe", 5) == 0) {
      head.namesColours = true;
      head.lumaChroma = body[11] == 1;
    } else if (marker == 0xDA) {
      if (!framed || body.empty() || body.size() < 4 + 2 * static_cast<std::size_t>(body[0])) return std::nullopt;
      if (lossless_ls) head.byPlanes = body[2 + 2 * static_cast<std::size_t>(body[0])] == 0;
      break;
    } else if (marker == 0xD8 || marker == 0xD9) {
      return std::nullopt;
    }
    at += 2 + length;
  }
  if (!framed || head.width == 0 || head.height == 0 || (head.components != 1 && head.components != 3)) return std::nullopt;
  if (head.bits < 2 || head.bits > 16) return std::nullopt;
  return head;
}

std::optional<CodecHeader> jpeg2000Head(Bytes stream) {
  // Files with boxes around the stream occur although DICOM asks for the bare stream.
  static constexpr std::array<std::uint8_t, 4> start{0xFF, 0x4F, 0xFF, 0x51};
  const auto found = std::search(stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(std::min<std::size_t>(stream.size(), 4096)),
                                 start.begin(), start.end());
  const auto at = static_cast<std::size_t>(found - stream.begin());
  if (at + 45 > stream.size()) return std::nullopt;
  const Bytes siz = stream.subspan(at + 4);
  const auto right = big32(siz, 4), bottom = big32(siz, 8), left = big32(siz, 12), top = big32(siz, 16);
  const auto tileWidth = big32(siz, 20), tileHeight = big32(siz, 24);
  CodecHeader head;
  head.components = static_cast<int>(big16(siz, 36));
  if (right <= left || bottom <= top || tileWidth == 0 || tileHeight == 0) return std::nullopt;
  head.width = right - left;
  head.height = bottom - top;
  if (head.components != 1 && head.components != 3) return std::nullopt;
  if (siz.size() < 38 + 3 * static_cast<std::size_t>(head.components)) return std::nullopt;
  for (std::size_t c = 0; c < static_cast<std::size_t>(head.components); ++c) {
    const int bits = (siz[38 + 3 * c] & 0x7F) + 1;
    if (siz[39 + 3 * c] != 1 || siz[40 + 3 * c] != 1) return std::nullopt;  // thinned components
    if (c > 0 && bits != head.bits) return std::nullopt;
    head.bits = bits;
  }
  if (head.bits > 16) return std::nullopt;
  // Tiles so small that their number alone would take the memory.
  if (((head.width + tileWidth - 1) / tileWidth) * ((head.height + tileHeight - 1) / tileHeight) > 65535) return std::nullopt;
  return head;
}

/// GDCM's decoders, loaded once and never unloaded; null: a part of the program is missing.
EwUnpack* decoders() {
  static EwUnpack* const found = [] {
    void* const module = openOwnModule("libew_packed.so").handle;
    return module == nullptr ? nullptr : reinterpret_cast<EwUnpack*>(dlsym(module, "ewUnpack"));
  }();
  return found;
}

EwPackedCodec numberOf(Codec codec) {
  switch (codec) {
    case Codec::jpeg:
      return ewPackedJpeg;
    case Codec::jpegLs:
      return ewPackedJpegLs;
    case Codec::jpeg2000:
      break;
  }
  return ewPackedJpeg2000;
}

constexpr int kMostProcessor_s = 10;
constexpr auto kMostWaiting = std::chrono::minutes(2);  // a busy machine takes its time; a decoder that sleeps does not end at all
constexpr auto kQuestion = std::chrono::milliseconds(2);

/// Pages that this process and its copy both see: a word that says that the bytes behind it are complete.
class ResultPages {
 public:
  explicit ResultPages(std::size_t bytes)
      : bytes_(bytes), pages_(mmap(nullptr, kHead + bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {}
  ~ResultPages() {
    if (ok()) munmap(pages_, kHead + bytes_);
  }
  ResultPages(const ResultPages&) = delete;
  ResultPages& operator=(const ResultPages&) = delete;
  [[nodiscard]] bool ok() const { return pages_ != MAP_FAILED; }
  void set(Bytes bytes) {
    std::memcpy(static_cast<std::uint8_t*>(pages_) + kHead, bytes.data(), bytes_);
    std::atomic_ref(*static_cast<std::uint32_t*>(pages_)).store(kComplete);
  }
  [[nodiscard]] std::optional<std::vector<std::uint8_t>> get() const {
    if (std::atomic_ref(*static_cast<std::uint32_t*>(pages_)).load() != kComplete) return std::nullopt;
    const auto* const first = static_cast<const std::uint8_t*>(pages_) + kHead;
    return std::vector<std::uint8_t>(first, first + bytes_);
  }

 private:
  static constexpr std::size_t kHead = 64;
  static constexpr std::uint32_t kComplete = 0x646f6e65;
  std::size_t bytes_;
  void* pages_;
};

/// The copy's own part: works, says nothing, leaves no core file and never returns.
template <class Work>
[[noreturn]] void workAndEnd(std::size_t wanted, const Work& work, ResultPages& result) {
  for (const int one : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGXCPU, SIGTERM}) signal(one, SIG_DFL);
  // A terminal sends Ctrl-C to both: this one goes on, and the program that waits for it decides.
  for (const int one : {SIGINT, SIGQUIT}) signal(one, SIG_IGN);
  const rlimit noCore{0, 0}, processor{kMostProcessor_s, kMostProcessor_s};
  setrlimit(RLIMIT_CORE, &noCore);
  setrlimit(RLIMIT_CPU, &processor);
  if (const int nowhere = open("/dev/null", O_WRONLY); nowhere >= 0) {
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
  }
  int status = 1;
  try {
    const auto bytes = work();
    if (bytes && bytes->size() == wanted) {
      result.set(*bytes);
      status = 0;
    }
  } catch (...) {
    status = 1;  // there was no memory
  }
  _exit(status);
}

/// Waits until the copy has ended, as long as it may take; ends it when `progress` asks to stop.
/// @return whether it came to its own end
bool ended(pid_t copy, const Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  for (auto pause = std::chrono::microseconds(100);; pause = std::min<std::chrono::microseconds>(2 * pause, kQuestion)) {
    int status = 0;
    const pid_t found = waitpid(copy, &status, WNOHANG);
    if (found == copy) return WIFEXITED(status) && WEXITSTATUS(status) == 0;
    // A parent that ignores SIGCHLD gives its children no one to report to: there only the shared word says how it ended.
    if (found < 0 && errno != EINTR) return errno == ECHILD;
    if (progress.cancelRequested() || std::chrono::steady_clock::now() - begin > kMostWaiting) break;
    std::this_thread::sleep_for(pause);
  }
  kill(copy, SIGKILL);
  while (waitpid(copy, nullptr, 0) < 0 && errno == EINTR) {
  }
  return false;
}

/// Runs `work` in a copy of this process and fetches the bytes it makes. GDCM's decoders stop the program on streams they did not foresee
/// (its assertions are compiled in, and fuzzing found one within seconds): here that costs one frame. Only memory is touched in the copy,
/// which a copy of a process with threads may do.
/// @return empty when the work gave nothing, did not give `wanted` bytes, ended the copy, took too long or was stopped
template <class Work>
std::optional<std::vector<std::uint8_t>> inOwnProcess(std::size_t wanted, const Progress& progress, const Work& work) {
  ResultPages result(wanted);
  if (!result.ok()) return std::nullopt;
  const pid_t copy = fork();
  if (copy == 0) workAndEnd(wanted, work, result);
  if (copy < 0 || !ended(copy, progress)) return std::nullopt;
  return result.get();
}

}  // namespace

std::optional<CodecHeader> packedHead(Codec codec, Bytes stream) {
  switch (codec) {
    case Codec::jpeg:
      return jpegHead(stream, false);
    case Codec::jpegLs:
      return jpegHead(stream, true);
    case Codec::jpeg2000:
      return jpeg2000Head(stream);
  }
  return std::nullopt;
}

Result<void> unpackerThere() {
  if (decoders() != nullptr) return {};
  return failure(ErrorCode::unsupported,
                 say<"Packed images cannot be read, because a part of the program is missing; install EchoWeave again.">(),
                 {{"file", "libew_packed.so"}});
}

std::optional<std::vector<std::uint8_t>> unpack(Codec codec, Bytes stream, const CodecHeader& head, int bitsAllocated, int bitsStored,
                                                bool isSigned, const Progress& progress) {
  EwUnpack* const decode = decoders();  // here, for a copy of a process with threads must not load anything
  if (decode == nullptr) return std::nullopt;
  const std::size_t wanted = head.width * head.height * static_cast<std::size_t>(head.components) * (bitsAllocated > 8 ? 2 : 1);
  const EwPackedImage image{
      numberOf(codec), static_cast<unsigned>(head.width), static_cast<unsigned>(head.height), head.components, bitsAllocated, bitsStored,
      isSigned ? 1 : 0};
  return inOwnProcess(wanted, progress, [&]() -> std::optional<std::vector<std::uint8_t>> {
    std::vector<std::uint8_t> samples(wanted);
    if (!decode(&image, stream.data(), stream.size(), samples.data(), wanted)) return std::nullopt;
    return samples;
  });
}

std::optional<std::vector<std::uint8_t>> unpackRle(Bytes packed, std::size_t segments, std::size_t planeSize) {
  if (packed.size() < 64) return std::nullopt;
  const auto little32 = [&](std::size_t at) {
    return static_cast<std::size_t>(packed[at]) | static_cast<std::size_t>(packed[at + 1]) << 8 |
           static_cast<std::size_t>(packed[at + 2]) << 16 | static_cast<std::size_t>(packed[at + 3]) << 24;
  };
  if (little32(0) != segments || segments > 15) return std::nullopt;
  std::vector<std::uint8_t> planes(segments * planeSize);
  for (std::size_t segment = 0; segment < segments; ++segment) {
    std::size_t at = little32(4 + 4 * segment);
    const std::size_t end = segment + 1 < segments ? std::min(little32(8 + 4 * segment), packed.size()) : packed.size();
    if (at < 64 || at > end) return std::nullopt;
    std::uint8_t* out = planes.data() + segment * planeSize;
    std::size_t left = planeSize;
    while (left > 0) {
      if (at >= end) return std::nullopt;
      const int byte = packed[at++], control = byte < 128 ? byte : byte - 256;
      if (control == -128) continue;
      const auto count = static_cast<std::size_t>(control >= 0 ? control + 1 : 1 - control);
      // A run may reach over the end of the plane by the padding of some writers.
      const std::size_t taken = std::min(count, left);
      if (control >= 0) {
        if (count > end - at) return std::nullopt;
        std::copy_n(packed.data() + at, taken, out);
        at += count;
      } else {
        if (at >= end) return std::nullopt;
        std::fill_n(out, taken, packed[at++]);
      }
      out += taken;
      left -= taken;
    }
  }
  return planes;
}

}  // namespace ew::detail
