#include "display/exposure.h"
