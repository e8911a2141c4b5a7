#include "shading/light.h"
