# libmatc_render.so: the renderer together with all of libmatc, exporting only what matc.h and
# matc_render.h declare. Only shared: a static library would pass assimp and glslang on to its host.
configure_file(runtime/renderer/matc_render.h ${MATC_PUBLIC}/matc_render.h COPYONLY)
set_target_properties(matc_gl matc_texts matc_scene matc_render PROPERTIES POSITION_INDEPENDENT_CODE ON C_VISIBILITY_PRESET hidden)
target_include_directories(matc_render PRIVATE ${MATC_PUBLIC})
add_library(matc_render_shared SHARED runtime/renderer/matc_render.c runtime/renderer/matc_scene.c $<TARGET_OBJECTS:matc_objects>)
set_target_properties(matc_render_shared PROPERTIES OUTPUT_NAME matc_render EXPORT_NAME render LINKER_LANGUAGE C
  C_VISIBILITY_PRESET hidden VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
  LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/matc.map)
target_link_options(matc_render_shared PRIVATE LINKER:--version-script=${PROJECT_SOURCE_DIR}/cmake/matc.map LINKER:--as-needed)
target_link_libraries(matc_render_shared PRIVATE matc_render matc::private)
target_include_directories(matc_render_shared INTERFACE $<BUILD_INTERFACE:${MATC_PUBLIC}> PRIVATE ${MATC_PUBLIC})
add_library(matc::render ALIAS matc_render_shared)
