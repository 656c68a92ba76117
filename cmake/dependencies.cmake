# Link dependencies of libmatc, as the target matc::private. Included by the build and by the
# installed package: the static library passes them on to its user, the shared one contains them.
# matc_missing: what was not found.
set(matc_missing)
find_package(PkgConfig QUIET)
if(PKG_CONFIG_FOUND)
  pkg_check_modules(matc_needs QUIET IMPORTED_TARGET GLOBAL yaml-0.1 libcjson libpng libjpeg)
endif()
if(NOT TARGET PkgConfig::matc_needs)
  list(APPEND matc_missing "yaml-0.1, libcjson, libpng or libjpeg (by pkg-config)")
endif()

# OpenEXR.pc names its C++ libraries too; its C core is one of its own.
find_library(OPENEXR_CORE NAMES OpenEXRCore OpenEXRCore-3_1)
mark_as_advanced(OPENEXR_CORE)
if(NOT OPENEXR_CORE)
  list(APPEND matc_missing "OpenEXRCore (of OpenEXR 3.1 or later)")
endif()

# Debian's glslang.pc omits SPIR-V and the resource limits; its CMake package requires
# SPIRV-Tools' development files.
set(matc_glslang)
set(matc_glslang_names)
foreach(name glslang-default-resource-limits glslang SPIRV MachineIndependent GenericCodeGen OGLCompiler OSDependent
             SPIRV-Tools-opt SPIRV-Tools)
  find_library(GLSLANG_${name} ${name})
  mark_as_advanced(GLSLANG_${name})
  if(GLSLANG_${name})
    list(APPEND matc_glslang ${GLSLANG_${name}})
    list(APPEND matc_glslang_names ${name})
  endif()
endforeach()
if(NOT GLSLANG_glslang)
  list(APPEND matc_missing "glslang")
endif()

set(matc_system stdc++ pthread m) # glslang is C++
if(NOT matc_missing AND NOT TARGET matc::private)
  add_library(matc::private INTERFACE IMPORTED GLOBAL)
  # a target with MATC_OWN_CXX brings the library of C++ itself
  list(TRANSFORM matc_system REPLACE "^stdc\\+\\+$" "$<$<NOT:$<BOOL:$<TARGET_PROPERTY:MATC_OWN_CXX>>>:stdc++>" OUTPUT_VARIABLE matc_linked)
  target_link_libraries(matc::private INTERFACE ${matc_glslang} ${OPENEXR_CORE} PkgConfig::matc_needs ${matc_linked})
endif()
