#include "page_names.h"

namespace ew::reports {

std::string plainName(std::string_view name) {
  constexpr std::string_view kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  constexpr std::size_t kLongest = 100;
  std::string made;
  for (const char letter : name.substr(0, kLongest)) made += kPlain.find(letter) == std::string_view::npos ? '-' : letter;
  return made.empty() ? "-" : made;
}

}  // namespace ew::reports
