#pragma once

namespace ew {

/// Gives the system back what was freed and is kept for the next who asks: after work that took much and left little, as when a case was
/// prepared or a step of a long chain ended. Takes some milliseconds. Nothing happens where the C library has no such call.
void giveFreedMemoryBack();

}  // namespace ew
