#pragma once

#include <locale.h>  // newlocale, uselocale: POSIX, not in <clocale>

namespace ew {

/// Names in tars are UTF-8 for this thread, whatever the user's locale: libarchive asks it, and crashes over names that it cannot hold.
class Utf8Names {
 public:
  Utf8Names() : utf8_(::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {
    if (utf8_ != nullptr) before_ = ::uselocale(utf8_);
  }
  ~Utf8Names() {
    if (utf8_ == nullptr) return;
    ::uselocale(before_);
    ::freelocale(utf8_);
  }
  Utf8Names(const Utf8Names&) = delete;
  Utf8Names& operator=(const Utf8Names&) = delete;
  [[nodiscard]] bool good() const { return utf8_ != nullptr; }

 private:
  locale_t utf8_;
  locale_t before_ = nullptr;
};

}  // namespace ew
