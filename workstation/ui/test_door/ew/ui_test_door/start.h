#pragma once

// What tests reach: the start page with its cards, and what is told of a case.

#include "case/case_info.h"
#include "start/card_view.h"
#include "start/case_card.h"
#include "start/case_catalogue.h"
#include "start/case_details.h"
#include "start/start_page.h"
#include "start/thumbnails.h"
