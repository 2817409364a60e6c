#pragma once

// What tests reach: images side by side, images of an examination, images as files.

#include "images/examination_dialog.h"
#include "images/examination_store.h"
#include "images/image_grid.h"
#include "images/image_tile.h"
#include "images/saved_image.h"
