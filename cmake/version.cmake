# Writes OUTPUT, a .cpp with the project's VERSION, the commit that SOURCE, a clone, is at, and a hash of its
# code.
#
#     cmake -DOUTPUT=version.cpp -DVERSION=1.0 -DSOURCE=. -P version.cmake
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=10 HEAD OUTPUT_VARIABLE commit ERROR_QUIET
  OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  set(commit "no commit known")
else()
  set(commit "commit ${commit}")
endif()
file(GLOB_RECURSE files ${SOURCE}/src/*.cpp ${SOURCE}/src/*.h ${SOURCE}/include/*.h)
list(SORT files)
foreach(file IN LISTS files)
  file(SHA256 ${file} hash)
  string(APPEND hashes ${hash})
endforeach()
string(SHA256 sources "${hashes}")
string(SUBSTRING ${sources} 0 12 sources)
file(WRITE ${OUTPUT} "// Made by cmake/version.cmake.\nnamespace raytracer::build {\n"
  "extern const char* const version;\nextern const char* const commit;\n"
  "extern const char* const sources;\nconst char* const sources = \"${sources}\";\n"
  "const char* const version = \"${VERSION}\";\nconst char* const commit = \"${commit}\";\n}\n")
