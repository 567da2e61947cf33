// Which pixels share a packet of rays, and an order of pixels in which neighbours do.
#pragma once

#include <algorithm>

#include "raytracer/numerics/packet_size.h"
#include "raytracer/pictures/pixels.h"

namespace raytracer {

// Calls function(x, y) for each, packet by packet.
template <class Function>
void forEachInPacketOrder(const PixelRectangle& pixels, Function function) {
    for (int top = pixels.y0; top < pixels.y1; top += packetHeight)
        for (int left = pixels.x0; left < pixels.x1; left += packetWidth)
            for (int y = top; y < std::min(top + packetHeight, pixels.y1); ++y)
                for (int x = left; x < std::min(left + packetWidth, pixels.x1); ++x) function(x, y);
}

}  // namespace raytracer
