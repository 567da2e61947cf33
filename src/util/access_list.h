// The access list of a file (POSIX ACL), which says more than the nine bits of its mode.
#pragma once

namespace raytracer {

// Gives the open file `to` the access list of the open file `from`, or none if that has none. The mode of a
// file with a list shows what the list allows at most, not what the group may: without the list, the same
// mode would allow the group more. False if that is not permitted. Each platform has its own version.
bool copyAccessList(int from, int to);

}  // namespace raytracer
