#include "ew/core/nesting.h"

#include <cstddef>

namespace ew {

bool nestsDeeperThan(std::string_view jsonText, int limit) {
  int depth = 0;
  bool inString = false;
  for (std::size_t i = 0; i < jsonText.size(); ++i) {
    const char c = jsonText[i];
    if (inString) {
      if (c == '\\')
        ++i;
      else if (c == '"')
        inString = false;
    } else if (c == '"') {
      inString = true;
    } else if (c == '{' || c == '[') {
      if (++depth > limit) return true;
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return false;
}

}  // namespace ew
