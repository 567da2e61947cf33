# Writes OUTPUT, a .cpp that defines each of FILES as a string: style.css is NAMESPACE::style, which HEADER
# declares.
#
#     cmake -DOUTPUT=page.cpp -DHEADER=page.h -DNAMESPACE=grading_page "-DFILES=style.css;script.js"
#         -P embed.cmake
set(text "// Made by cmake/embed.cmake.\n#include \"${HEADER}\"\nnamespace raytracer::${NAMESPACE} {\n")
foreach(file IN LISTS FILES)
  cmake_path(GET file STEM name)
  file(READ ${file} content)
  string(APPEND text "const char* const ${name} = R\"embedded(${content})embedded\";\n")
endforeach()
file(WRITE ${OUTPUT} "${text}}\n")
