# libmatc.a and libmatc.so, which export only what matc.h declares. The archive too: it holds one
# joined object whose other functions are local, so that an engine may define its own arena_alloc.
# BUILD_SHARED_LIBS selects one of the two; if unset, both are made, and matc::matc is the archive.
set(MATC_KINDS static shared)
if(DEFINED BUILD_SHARED_LIBS AND BUILD_SHARED_LIBS)
  set(MATC_KINDS shared)
elseif(DEFINED BUILD_SHARED_LIBS)
  set(MATC_KINDS static)
endif()
set(MATC_PUBLIC ${PROJECT_BINARY_DIR}/include)
configure_file(compiler/matc.h ${MATC_PUBLIC}/matc.h COPYONLY)

if("static" IN_LIST MATC_KINDS)
  set(joined ${PROJECT_BINARY_DIR}/matc.o)
  add_custom_command(OUTPUT ${joined}
    COMMAND ${CMAKE_LINKER} -r -o ${joined} $<TARGET_OBJECTS:matc_objects>
    COMMAND ${CMAKE_OBJCOPY} --localize-hidden ${joined}
    DEPENDS matc_objects $<TARGET_OBJECTS:matc_objects> COMMAND_EXPAND_LISTS VERBATIM COMMENT "Joining libmatc's objects")
  set_source_files_properties(${joined} PROPERTIES EXTERNAL_OBJECT ON GENERATED ON)
  add_library(matc_static STATIC ${joined})
endif()
if("shared" IN_LIST MATC_KINDS)
  add_library(matc_shared SHARED $<TARGET_OBJECTS:matc_objects>)
  set_target_properties(matc_shared PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    LINK_DEPENDS ${PROJECT_SOURCE_DIR}/cmake/matc.map)
  target_link_options(matc_shared PRIVATE LINKER:--version-script=${PROJECT_SOURCE_DIR}/cmake/matc.map LINKER:--as-needed)
endif()

foreach(kind ${MATC_KINDS})
  set_target_properties(matc_${kind} PROPERTIES OUTPUT_NAME matc EXPORT_NAME ${kind} LINKER_LANGUAGE C)
  target_link_libraries(matc_${kind} PRIVATE matc::private)
  target_include_directories(matc_${kind} INTERFACE $<BUILD_INTERFACE:${MATC_PUBLIC}>)
  add_library(matc::${kind} ALIAS matc_${kind})
endforeach()
list(GET MATC_KINDS 0 first)
add_library(matc::matc ALIAS matc_${first})
