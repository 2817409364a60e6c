#include "passphrase_input.h"

#include <fcntl.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>

#include "ew/io/private_file.h"

namespace ew::cli {
namespace {

constexpr const char* kAsk = "ask";
constexpr std::string_view kDescriptor = "fd:";

tl::unexpected<Error> nothingThere() {
  return failure(ErrorCode::badUsage, say<"No passphrase came; give one with 'ask' on a terminal, fd:N, or the name of a private file.">());
}

/// The first line of a descriptor, read byte by byte: what comes after it is somebody else's.
Result<Passphrase> lineOf(int descriptor) {
  std::string words;
  for (char c = 0; words.size() <= kLongestPassphrase_bytes;) {
    const ssize_t count = ::read(descriptor, &c, 1);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      return failure(ErrorCode::badUsage,
                     say<"No passphrase can be read from the file descriptor %1; give one that is open for reading.">(descriptor));
    if (count == 0 || c == '\n') break;
    words += c;
  }
  if (!words.empty() && words.back() == '\r') words.pop_back();
  if (words.empty()) return nothingThere();
  return Passphrase(std::move(words));
}

/// A terminal that does not show what is typed, for as long as this lives.
class SilentTerminal {
 public:
  explicit SilentTerminal(int terminal) : terminal_(terminal), isOpen_(::tcgetattr(terminal, &before_) == 0) {
    if (!isOpen_) return;
    termios silent = before_;
    silent.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    isOpen_ = ::tcsetattr(terminal, TCSAFLUSH, &silent) == 0;
  }
  ~SilentTerminal() {
    if (isOpen_) ::tcsetattr(terminal_, TCSAFLUSH, &before_);
  }
  SilentTerminal(const SilentTerminal&) = delete;
  SilentTerminal& operator=(const SilentTerminal&) = delete;
  [[nodiscard]] bool isOpen() const { return isOpen_; }

 private:
  int terminal_;
  termios before_{};
  bool isOpen_;
};

Result<Passphrase> askedOn(int terminal, const Message& prompt) {
  const SilentTerminal silent(terminal);
  const auto put = [&](const std::string& text) { return ::write(terminal, text.data(), text.size()) >= 0; };
  if (!silent.isOpen() || !put(prompt.english() + " "))
    return failure(ErrorCode::badUsage,
                   say<"The terminal shows what is typed, so no passphrase is asked for there; give it with fd:N or the "
                       "name of a private file.">());
  auto words = lineOf(terminal);
  static_cast<void>(put("\n"));
  return words;
}

Result<Passphrase> asked(const Message& prompt) {
  const int terminal = ::open("/dev/tty", O_RDWR | O_CLOEXEC);
  if (terminal < 0)
    return failure(ErrorCode::badUsage,
                   say<"There is no terminal to ask for the passphrase on; give it with fd:N or the name of a private file.">());
  auto words = askedOn(terminal, prompt);
  ::close(terminal);
  return words;
}

Result<Passphrase> fromFile(const std::string& file) {
  auto text = readPrivateFile(file, kLongestPassphrase_bytes + 2);
  if (!text) return passOn(text.error());
  text->resize(std::min(text->find_first_of("\r\n"), text->size()));
  if (text->empty()) return nothingThere();
  return Passphrase(std::move(*text));
}

}  // namespace

Result<Passphrase> readPassphrase(const std::string& source, const Message& prompt) {
  if (source == kAsk) return asked(prompt);
  if (!source.starts_with(kDescriptor)) return fromFile(source);
  int descriptor = -1;
  const auto read = std::from_chars(source.data() + kDescriptor.size(), source.data() + source.size(), descriptor);
  if (read.ec != std::errc{} || read.ptr != source.data() + source.size() || descriptor < 0)
    return failure(ErrorCode::badUsage, say<"'%1' is no file descriptor; write fd:3, for instance.">(source));
  return lineOf(descriptor);
}

Result<Passphrase> readNewPassphrase(const std::string& source, const Message& prompt) {
  auto words = readPassphrase(source, prompt);
  if (!words) return words;
  if (auto good = checkNewPassphrase(*words); !good) return passOn(good.error());
  if (source != kAsk) return words;
  const auto again = readPassphrase(source, say<"Once more:">());
  if (!again) return passOn(again.error());
  if (again->words() != words->words())
    return failure(ErrorCode::badUsage, say<"The two passphrases differ; nothing was changed. Give the command again.">());
  return words;
}

}  // namespace ew::cli
