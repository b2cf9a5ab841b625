# cmake --install installs the engine for find_package(plumb):
#
#   find_package(plumb REQUIRED)                      # or COMPONENTS physics for the physics library only
#   target_link_libraries(my_game PRIVATE plumb::engine)
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/plumb)

get_property(table GLOBAL PROPERTY PLUMB_LAYERS)
foreach(line IN LISTS table)
    string(REPLACE " " ";" words "${line}")
    list(GET words 0 name)
    list(GET words 1 folder)
    list(GET words 2 include_name)
    if(NOT folder MATCHES "^${CMAKE_CURRENT_SOURCE_DIR}/")
        continue()  # layers of the editor are not installed
    endif()
    list(APPEND layers ${name})
    install(DIRECTORY ${folder}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumb/${include_name}
        FILES_MATCHING PATTERN "*.hpp")
endforeach()
install(FILES public/plumb_physics.hpp DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumb)
if(NOT PLUMB_PHYSICS_ALONE)
    install(DIRECTORY public/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/plumb FILES_MATCHING PATTERN "*.hpp")
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/assets/ DESTINATION ${CMAKE_INSTALL_DATADIR}/plumb/assets
        PATTERN tools EXCLUDE)
    set_target_properties(plumb_sdl PROPERTIES EXPORT_NAME sdl)
    set_target_properties(plumb_stb PROPERTIES EXPORT_NAME stb)
    set_target_properties(plumb_zstd PROPERTIES EXPORT_NAME zstd)
    set_target_properties(plumb_lua PROPERTIES EXPORT_NAME lua)
    list(APPEND layers engine plumb_sdl plumb_stb plumb_zstd plumb_lua)
endif()

install(TARGETS ${layers} EXPORT plumb)
install(EXPORT plumb NAMESPACE plumb:: FILE plumbTargets.cmake DESTINATION ${package})
write_basic_package_version_file(plumbConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES cmake/plumbConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/plumbConfigVersion.cmake DESTINATION ${package})
