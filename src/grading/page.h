// The fixed parts of the grading report. cmake/embed.cmake turns the files in page/ into these strings.
#pragma once

namespace raytracer::grading_page {

extern const char* const style;
extern const char* const controls;
extern const char* const overviewHead;
extern const char* const overviewTail;
extern const char* const viewer;
extern const char* const script;

}  // namespace raytracer::grading_page
