// Explains why a pointer does not lead to a value, and proposes one that does.
#pragma once

#include <string>

#include "raytracer/json/json_document.h"

namespace raytracer {

// What is wrong with the form of a pointer that does not lead to a value; empty if the form is right.
std::string aboutPointerForm(const JsonDocument& document, const std::string& pointer);

// Why a pointer of the right form leads nowhere.
std::string aboutLostPointer(const JsonDocument& document, const std::string& pointer);

}  // namespace raytracer
