# What `cmake --install` puts where, and the Debian package that `cpack` makes of it.
include(GNUInstallDirs)
install(TARGETS raytracer RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES scenes/scene.schema.json DESTINATION ${CMAKE_INSTALL_DATADIR}/raytracer)
install(DIRECTORY scenes/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples PATTERN gallery EXCLUDE)

if(NOT CMAKE_CROSSCOMPILING)  # the program itself tells them
  set(documents ${CMAKE_CURRENT_BINARY_DIR}/documents)
  add_custom_command(OUTPUT ${documents}/raytracer.1 DEPENDS raytracer cmake/documents.cmake VERBATIM
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:raytracer> -DFOLDER=${documents}
      -P ${PROJECT_SOURCE_DIR}/cmake/documents.cmake)
  add_custom_target(documents ALL DEPENDS ${documents}/raytracer.1)
  install(FILES ${documents}/raytracer.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
  install(FILES ${documents}/raytracer.bash RENAME raytracer
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  install(FILES ${documents}/_raytracer DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
  install(FILES ${documents}/raytracer.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
endif()

# Debian's policy: a copyright, and man pages and a changelog that are compressed (12.1, 12.7).
set(debian ${CMAKE_CURRENT_BINARY_DIR}/debian)
file(READ LICENSE license)
string(REGEX REPLACE "\n\n" "\n.\n" license "${license}")
string(REGEX REPLACE "\n" "\n " license "${license}")
string(STRIP "${license}" license)
file(WRITE ${debian}/copyright
  "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\n\n"
  "Files: *\nCopyright: 2026 the raytracer authors\nLicense: Expat\n ${license}\n")
file(WRITE ${debian}/changelog
  "raytracer (${PROJECT_VERSION}) unstable; urgency=medium\n\n  * See the project's history.\n\n"
  " -- the raytracer authors <raytracer@localhost>  Sat, 28 Nov 2026 12:00:00 +0000\n")
file(WRITE ${debian}/overrides/raytracer
  "# There is no public address to write to yet.\nraytracer: bogus-mail-host *\n"
  "raytracer: bogus-mail-host-in-debian-changelog *\n"
  "# The package was never Debian's, so there is no bug to close.\n"
  "raytracer: initial-upload-closes-no-bugs *\n")
file(WRITE ${debian}/compress.cmake "if(NOT CPACK_GENERATOR STREQUAL DEB)\n  return()\nendif()\n"
  "set(share \${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr/share)\n"
  "file(COPY ${debian}/copyright ${debian}/changelog DESTINATION \${share}/doc/raytracer)\n"
  "file(COPY ${debian}/overrides/raytracer DESTINATION \${share}/lintian/overrides)\n"
  "execute_process(COMMAND gzip -9n \${share}/doc/raytracer/changelog \${share}/man/man1/raytracer.1\n"
  "  COMMAND_ERROR_IS_FATAL ANY)\n")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the raytracer authors <raytracer@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "ray tracer that renders JSON scenes")
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Turns a scene, a JSON file, into a picture: spheres, planes, cylinders,
 cones, cubes and meshes in Phong's light, with shadows, mirrors, glass
 and textures. Compares pictures, grades other programs, explains the
 light of a pixel and measures what speed costs in accuracy.")
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${debian}/compress.cmake)
find_program(RAYTRACER_SHLIBDEPS dpkg-shlibdeps)
if(RAYTRACER_SHLIBDEPS)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
endif()
include(CPack)
