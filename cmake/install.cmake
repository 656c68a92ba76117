# What is installed, to any prefix; nothing in it names the prefix or a folder of the build.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/matc)
set(MATC_SCHEMA ${CMAKE_INSTALL_DATADIR}/matc/schema)
set(MATC_SURFACE ${CMAKE_INSTALL_DATADIR}/matc/surface)

install(TARGETS matc EXPORT matcTargets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
set_target_properties(matc PROPERTIES EXPORT_NAME compiler)
install(TARGETS matview RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(FILES compiler/matc.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(FILES docs/reference/matc.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 RENAME ${MATC_PROGRAM_NAME}.1)
install(FILES docs/reference/matview.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(EXPORT matcTargets NAMESPACE matc:: DESTINATION ${package})
foreach(kind ${MATC_KINDS})
  install(TARGETS matc_${kind} EXPORT matc-${kind} INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT matc-${kind} NAMESPACE matc:: DESTINATION ${package})
endforeach()

install(TARGETS matc_render_shared EXPORT matc-render INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT matc-render NAMESPACE matc:: DESTINATION ${package})
install(FILES runtime/renderer/matc_render.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# What lights a Surface that the unpacking text gives: docs/reference/layouts.md
install(FILES runtime/surface/surface_phong.glsl runtime/surface/surface_microfacets.glsl runtime/surface/surface_principled.glsl runtime/surface/surface_principled_light.glsl
  runtime/surface/surface_anisotropic.glsl runtime/surface/surface_through.glsl
  DESTINATION ${MATC_SURFACE})

configure_package_config_file(cmake/matcConfig.cmake.in ${PROJECT_BINARY_DIR}/package/matcConfig.cmake
  INSTALL_DESTINATION ${package} PATH_VARS MATC_SCHEMA MATC_SURFACE)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/package/matcConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/package/matcConfig.cmake ${PROJECT_BINARY_DIR}/package/matcConfigVersion.cmake
  cmake/materials.cmake cmake/dependencies.cmake DESTINATION ${package})

# The schemas, for editors
set(schemas)
foreach(of document layout manifest reflection)
  set(schema ${PROJECT_BINARY_DIR}/package/schema/${of}.schema.json)
  add_custom_command(OUTPUT ${schema} COMMAND matc --schema=${of} > ${schema} DEPENDS matc
    COMMENT "Writing the schema of a ${of}" VERBATIM)
  list(APPEND schemas ${schema})
endforeach()
file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/package/schema)
add_custom_target(matc_schemas ALL DEPENDS ${schemas})
install(FILES ${schemas} DESTINATION ${MATC_SCHEMA})

# pkg-config: glslang's libraries by name, and their folder where the linker would not look.
set(private ${matc_glslang_names} OpenEXRCore ${matc_system})
list(TRANSFORM private PREPEND -l)
get_filename_component(folder ${GLSLANG_glslang} DIRECTORY)
if(NOT folder IN_LIST CMAKE_C_IMPLICIT_LINK_DIRECTORIES)
  list(PREPEND private -L${folder})
endif()
list(JOIN private " " MATC_PC_PRIVATE)
file(RELATIVE_PATH MATC_PC_UP /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
string(REGEX REPLACE "/$" "" MATC_PC_UP ${MATC_PC_UP})
configure_file(cmake/matc.pc.in ${PROJECT_BINARY_DIR}/package/matc.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/matc.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
configure_file(cmake/matc_render.pc.in ${PROJECT_BINARY_DIR}/package/matc_render.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/package/matc_render.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
