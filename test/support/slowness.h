// How much slower than a release the tests are.
#pragma once

namespace raytracer::test {

// Under a sanitizer or without an optimiser, properties are tried with so many times fewer random cases; the
// release tries them all.
#if defined(__OPTIMIZE__) && !defined(__SANITIZE_ADDRESS__)
constexpr int slowness = 1;
#else
constexpr int slowness = 16;
#endif

// A picture's longer edge, where every pixel is compared.
constexpr int shortened(int edge) { return slowness > 1 ? edge / 3 : edge; }

}  // namespace raytracer::test
