#include "run/printable_stream.h"

#include "ew/core/printable.h"

namespace ew::cli {

std::streamsize PrintableStream::Buffer::xsputn(const char* text, std::streamsize count) {
  begun_.append(text, static_cast<std::size_t>(count));
  const bool mayGoOn = begun_.ends_with('\r');  // "\r\n" in two pieces
  const std::size_t rest = mayGoOn ? 1 : unfinishedBytes(begun_);
  const std::string whole = printable(std::string_view(begun_).substr(0, begun_.size() - rest));
  begun_.erase(0, begun_.size() - rest);
  to_.write(whole.data(), static_cast<std::streamsize>(whole.size()));
  return to_.good() ? count : 0;
}

PrintableStream::Buffer::int_type PrintableStream::Buffer::overflow(int_type letter) {
  if (traits_type::eq_int_type(letter, traits_type::eof())) return traits_type::not_eof(letter);
  const char one = traits_type::to_char_type(letter);
  return xsputn(&one, 1) == 1 ? letter : traits_type::eof();
}

int PrintableStream::Buffer::sync() {
  if (!begun_.empty()) {
    const std::string whole = printable(begun_);
    begun_.clear();
    to_.write(whole.data(), static_cast<std::streamsize>(whole.size()));
  }
  to_.flush();
  return to_.good() ? 0 : -1;
}

}  // namespace ew::cli
