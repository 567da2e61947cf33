// Pixels' colours: means of the colours seen at points of them.
#pragma once

#include "raytracer/tracer/packet_tracer.h"

namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE {

// Of up to PointPacket::most pixels: each its own, whatever the others are, but neighbouring ones are faster.
// observers: none, or where options.samples is 1, one for each pixel.
void pixelColors(const Scene& scene, std::span<const PixelPlace> pixels, std::span<Color> colors,
                 const RenderContext& context, std::span<Observer* const> observers = {});

}  // namespace raytracer::inline RAYTRACER_PRECISION_NAMESPACE
