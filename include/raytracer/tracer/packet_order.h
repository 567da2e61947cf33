// Which pixels share a packet of rays, and an order of pixels in which neighbours do.
#pragma once

#include <algorithm>

#include "raytracer/numerics/packet_size.h"
#include "raytracer/pictures/pixels.h"

namespace raytracer {

// Calls function(pixels) with the pixels of each packet.
template <class Function>
void forEachPacket(const PixelRectangle& pixels, Function function) {
    for (int top = pixels.y0; top < pixels.y1; top += packetHeight)
        for (int left = pixels.x0; left < pixels.x1; left += packetWidth)
            function(PixelRectangle{left, top, std::min(left + packetWidth, pixels.x1),
                                    std::min(top + packetHeight, pixels.y1)});
}

// Calls function(x, y) for each pixel, packet by packet.
template <class Function>
void forEachInPacketOrder(const PixelRectangle& pixels, Function function) {
    forEachPacket(pixels, [&](const PixelRectangle& packet) {
        for (int y = packet.y0; y < packet.y1; ++y)
            for (int x = packet.x0; x < packet.x1; ++x) function(x, y);
    });
}

}  // namespace raytracer
