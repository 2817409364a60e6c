#pragma once

namespace ew {

/// Tells programs that read the window aloud of widgets that are painted here: a time line is a slider with a value in seconds. To be
/// called once; later calls do nothing.
void describeTimeLines();

}  // namespace ew
