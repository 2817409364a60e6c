#pragma once

#include <ostream>
#include <streambuf>
#include <string>

namespace ew::cli {

/// What a command writes for people passes through this on its way to the terminal: whatever titles, names and answers of others hold, no
/// control character gets there (ew/core/printable.h). Only the bar of ConsoleProgress writes beside it. Not for several threads at once.
class PrintableStream final : public std::ostream {
 public:
  /// @param to outlives the stream
  explicit PrintableStream(std::ostream& to) : std::ostream(nullptr), buffer_(to) { rdbuf(&buffer_); }
  ~PrintableStream() override { flush(); }
  PrintableStream(const PrintableStream&) = delete;
  PrintableStream& operator=(const PrintableStream&) = delete;

 private:
  class Buffer final : public std::streambuf {
   public:
    explicit Buffer(std::ostream& to) : to_(to) {}

   protected:
    int_type overflow(int_type letter) override;
    std::streamsize xsputn(const char* text, std::streamsize count) override;
    int sync() override;

   private:
    std::ostream& to_;
    std::string begun_;  ///< a character of which bytes are missing yet
  };
  Buffer buffer_;
};

}  // namespace ew::cli
