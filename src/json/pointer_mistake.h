// Why a pointer does not lead to a value, and where it should.
#pragma once

#include <string>

#include "raytracer/json/json_document.h"

namespace raytracer {

// What is wrong with the form of a pointer that does not lead all the way, or nothing.
std::string aboutPointerForm(const JsonDocument& document, const std::string& pointer);

// Why the pointer, which has its form, leads nowhere.
std::string aboutLostPointer(const JsonDocument& document, const std::string& pointer);

}  // namespace raytracer
