# Writes what PROGRAM tells of itself into FOLDER: its man page and the completions of three shells.
#
#     cmake -DPROGRAM=raytracer -DFOLDER=documents -P documents.cmake
file(MAKE_DIRECTORY ${FOLDER})
function(write file)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${FOLDER}/${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()
write(raytracer.1 --print-manual)
write(raytracer.bash --print-completion bash)
write(_raytracer --print-completion zsh)
write(raytracer.fish --print-completion fish)
