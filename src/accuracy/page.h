// The fixed parts of the trade-off's charts and page.
// cmake/embed.cmake turns the files in page/ into these strings.
#pragma once

namespace raytracer::accuracy_page {

extern const char* const colors;  // of the charts and of the page
extern const char* const chart;   // the charts' style
extern const char* const style;   // the page's
extern const char* const introduction;
extern const char* const table;  // the head of a table of trials
extern const char* const script;

}  // namespace raytracer::accuracy_page
