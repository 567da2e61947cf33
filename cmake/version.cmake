# Writes OUTPUT, a .cpp with the project's VERSION and the commit that SOURCE, a clone, is at.
#
#     cmake -DOUTPUT=version.cpp -DVERSION=1.0 -DSOURCE=. -P version.cmake
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=10 HEAD OUTPUT_VARIABLE commit ERROR_QUIET
  OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  set(commit "no commit known")
else()
  set(commit "commit ${commit}")
endif()
file(WRITE ${OUTPUT} "// Made by cmake/version.cmake.\nnamespace raytracer::build {\n"
  "extern const char* const version;\nextern const char* const commit;\n"
  "const char* const version = \"${VERSION}\";\nconst char* const commit = \"${commit}\";\n}\n")
