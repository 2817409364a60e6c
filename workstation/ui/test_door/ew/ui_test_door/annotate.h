#pragma once

// What tests reach: texts, arrows and body marks on an image.

#include "annotate/annotated_pictures.h"
#include "annotate/annotation_layer.h"
#include "annotate/body_mark_view.h"
#include "annotate/shown_mark.h"
