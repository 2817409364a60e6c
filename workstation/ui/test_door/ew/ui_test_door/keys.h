#pragma once

// What tests reach: keys and their dialog, control surfaces.

#include "keys/control_surface.h"
#include "keys/key_field.h"
#include "keys/key_map.h"
#include "keys/keys_dialog.h"
#include "keys/shortcuts_overlay.h"
