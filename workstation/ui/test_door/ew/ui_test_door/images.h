#pragma once

// What tests reach: images side by side, images of an examination, images as files.

#include "images/examination_dialog.h"
#include "images/kept_picture.h"
#include "images/picture_grid.h"
#include "images/saved_picture.h"
#include "images/stored_examination.h"
