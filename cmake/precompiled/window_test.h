#include <QTest>

#include "window.h"
