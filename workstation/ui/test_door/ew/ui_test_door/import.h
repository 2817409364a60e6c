#pragma once

// What tests reach: dialogs for files of others and for recorded screens.

#include "import/file_import_dialog.h"
#include "import/import_dialog.h"
#include "import/opener.h"
#include "import/screen_dialog.h"
#include "import/screen_view.h"
