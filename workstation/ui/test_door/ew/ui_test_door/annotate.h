#pragma once

// What tests reach: texts, arrows and body marks on an image.

#include "annotate/annotation_layer.h"
#include "annotate/body_mark_view.h"
#include "annotate/image_annotations.h"
#include "annotate/image_body_mark.h"
