#pragma once

/// What the libraries of this module have to say, the program says itself.
void silence();
