#include "ew/trackers/igtl_client.h"
