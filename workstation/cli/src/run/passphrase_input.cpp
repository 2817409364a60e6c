#include "run/passphrase_input.h"

#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>

#include "ew/io/private_file.h"

namespace ew::cli {
namespace {

constexpr const char* kAsk = "ask";
constexpr std::string_view kDescriptor = "fd:";

tl::unexpected<Error> nothingThere() {
  return failure(ErrorCode::badUsage, say<"No passphrase came; give one with 'ask' on a terminal, fd:N, or the name of a private file.">());
}

/// Set while a terminal asks; 0: none came.
volatile std::sig_atomic_t signalDuringPrompt = 0;

extern "C" void noteSignal(int number) { signalDuringPrompt = number; }

/// @param heeded the signals that may come while nothing does; null: those that may come anyway
/// @return false when one of SignalGuard came
bool waitForInput(int descriptor, const sigset_t* heeded) {
  pollfd asked{descriptor, POLLIN, 0};
  while (heeded != nullptr && signalDuringPrompt == 0 && ::ppoll(&asked, 1, nullptr, heeded) < 0 && errno == EINTR) {
  }
  return heeded == nullptr || signalDuringPrompt == 0;
}

/// The first line of a descriptor, read byte by byte: what comes after it is somebody else's. @param heeded as waitForInput
Result<Passphrase> lineOf(int descriptor, const sigset_t* heeded = nullptr) {
  std::string words;
  for (char c = 0; words.size() <= kLongestPassphrase_bytes;) {
    if (!waitForInput(descriptor, heeded)) return failure(ErrorCode::cancelled, say<"Stopped as asked; no passphrase was taken.">());
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

/// As long as this lives, a signal that would end or stop the program only interrupts what waits for a line; afterwards it does what it
/// would have done before. Ctrl-Z is not heeded: a program that goes on later would show what is typed.
class SignalGuard {
 public:
  SignalGuard() {
    signalDuringPrompt = 0;
    sigset_t all;
    sigemptyset(&all);
    for (const int number : kHeld) sigaddset(&all, number);
    ::pthread_sigmask(SIG_BLOCK, &all, &heeded_);  // until somebody waits: none is missed between looking and waiting
    struct sigaction held {};
    for (std::size_t n = 0; n < kHeld.size(); ++n) {
      held.sa_handler = kHeld[n] == SIGTSTP ? SIG_IGN : noteSignal;
      ::sigaction(kHeld[n], &held, &before_[n]);
    }
  }
  ~SignalGuard() {
    for (std::size_t n = 0; n < kHeld.size(); ++n) ::sigaction(kHeld[n], &before_[n], nullptr);
    ::pthread_sigmask(SIG_SETMASK, &heeded_, nullptr);
    if (const int number = signalDuringPrompt; number != 0) ::raise(number);
  }
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;
  [[nodiscard]] const sigset_t* heeded() const { return &heeded_; }

 private:
  static constexpr std::array kHeld = {SIGINT, SIGTERM, SIGQUIT, SIGHUP, SIGTSTP};
  std::array<struct sigaction, kHeld.size()> before_{};
  sigset_t heeded_{};
};

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
  const SignalGuard signals;  // outlives what makes the terminal silent
  const SilentTerminal silent(terminal);
  const auto put = [&](const std::string& text) { return ::write(terminal, text.data(), text.size()) >= 0; };
  if (!silent.isOpen() || !put(prompt.english() + " "))
    return failure(ErrorCode::badUsage,
                   say<"The terminal shows what is typed, so no passphrase is asked for there; give it with fd:N or the "
                       "name of a private file.">());
  auto words = lineOf(terminal, signals.heeded());
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
