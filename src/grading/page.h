// The fixed parts of the grading report: the files in page/, which cmake/embed.cmake makes strings of.
#pragma once

namespace raytracer::grading_page {

extern const char* const style;
extern const char* const controls;
extern const char* const overviewHead;
extern const char* const overviewTail;
extern const char* const viewer;
extern const char* const script;

}  // namespace raytracer::grading_page
