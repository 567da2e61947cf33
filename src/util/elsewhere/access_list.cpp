#include "../access_list.h"

namespace raytracer {

bool copyAccessList(int, int) { return true; }

}  // namespace raytracer
