# Materials in a CMake project, compiled by one run of matc:
#
#   matc_add_materials(TARGET name SOURCES file.yaml...
#     [LAYOUT name|file|auto]      layout of the G-buffer; default: matc's
#     [CASES used|all]             cases of the layout that the unpacking code reads; default: those
#                                  that the materials write
#     [PASSES gbuffer shadow...]   default: gbuffer
#     [EMIT glsl vertex...]        default: glsl, vertex, unpack and reflect
#     [TARGET_GLSL glsl330]        GLSL version
#     [CONSTANTS auto|uniform|baked]
#     [OUTPUT folder]              default: the target's name; in the current binary folder
#     [CACHE folder]               shared by builds
#     [OPTIONS option...])         further options of matc, such as -j 4 or --precision=exact
#
# The target is built with `all`. Its properties MATC_OUTPUT and MATC_MANIFEST name the folder and
# the manifest.json in it. matc runs when a source, an included file, a picture, the layout file,
# matc itself or an argument changes; files with unchanged contents keep their times.
cmake_policy(PUSH)
cmake_policy(VERSION 3.20...3.25) # depfiles, for ninja and make

# Ends the configuring: a fault of the caller.
function(matc_fault text)
  message(FATAL_ERROR "matc_add_materials: ${text}")
endfunction()

# Sets `result` to the absolute path of a file that exists or that the build makes.
function(matc_find_source path result)
  get_filename_component(full "${path}" ABSOLUTE BASE_DIR ${CMAKE_CURRENT_SOURCE_DIR})
  get_source_file_property(generated "${full}" GENERATED)
  if(IS_DIRECTORY "${full}")
    matc_fault("${path} is a folder")
  elseif(NOT EXISTS "${full}" AND NOT generated)
    matc_fault("there is no file ${path} in ${CMAKE_CURRENT_SOURCE_DIR}, and nothing in this folder generates it")
  endif()
  set(${result} "${full}" PARENT_SCOPE)
endfunction()

# The folder belongs to one target: matc removes what it wrote there before and no longer writes.
function(matc_claim_output folder target)
  get_property(owner GLOBAL PROPERTY "MATC_OWNER_${folder}")
  if(NOT "${owner}" STREQUAL "")
    matc_fault("the targets ${owner} and ${target} cannot both write to ${folder}; give one an OUTPUT of its own")
  endif()
  set_property(GLOBAL PROPERTY "MATC_OWNER_${folder}" ${target})
endfunction()

function(matc_check_arguments target)
  if(target STREQUAL "")
    matc_fault("TARGET is missing")
  elseif(TARGET ${target})
    matc_fault("there is a target ${target} already")
  elseif("${materials_SOURCES}" STREQUAL "")
    matc_fault("${target} has no SOURCES")
  elseif(DEFINED materials_UNPARSED_ARGUMENTS)
    list(JOIN materials_UNPARSED_ARGUMENTS " " rest)
    matc_fault("${target}: no keyword takes '${rest}'")
  elseif(DEFINED materials_KEYWORDS_MISSING_VALUES)
    list(JOIN materials_KEYWORDS_MISSING_VALUES " " rest)
    matc_fault("${target}: nothing follows ${rest}")
  endif()
endfunction()

function(matc_add_materials)
  cmake_parse_arguments(PARSE_ARGV 0 materials "" "TARGET;LAYOUT;CASES;TARGET_GLSL;CONSTANTS;OUTPUT;CACHE"
    "SOURCES;PASSES;EMIT;OPTIONS")
  set(target ${materials_TARGET})
  matc_check_arguments("${target}")
  set(arguments)
  set(inputs)
  foreach(source IN LISTS materials_SOURCES)
    matc_find_source("${source}" full)
    list(APPEND inputs "${full}")
  endforeach()

  # The sources are listed in a file, because a command line cannot hold thousands. The file is
  # written only when it changes.
  set(work ${CMAKE_CURRENT_BINARY_DIR}/${target}.matc)
  list(JOIN inputs "\n" listed)
  file(GENERATE OUTPUT ${work}/sources.txt CONTENT "${listed}\n")

  if(NOT materials_OUTPUT)
    set(materials_OUTPUT ${target})
  endif()
  get_filename_component(output "${materials_OUTPUT}" ABSOLUTE BASE_DIR ${CMAKE_CURRENT_BINARY_DIR})
  matc_claim_output("${output}" ${target})
  if(materials_LAYOUT MATCHES "\\.(yaml|yml|json)$")
    matc_find_source("${materials_LAYOUT}" materials_LAYOUT)
    list(APPEND inputs "${materials_LAYOUT}")
  endif()
  if(materials_CACHE)
    get_filename_component(materials_CACHE "${materials_CACHE}" ABSOLUTE BASE_DIR ${CMAKE_CURRENT_BINARY_DIR})
  endif()
  if(NOT materials_EMIT)
    set(materials_EMIT glsl vertex unpack reflect)
  endif()
  list(JOIN materials_EMIT "," materials_EMIT)
  list(JOIN materials_PASSES "," materials_PASSES)
  foreach(pair emit:EMIT layout:LAYOUT cases:CASES pass:PASSES target:TARGET_GLSL constants:CONSTANTS cache:CACHE)
    string(REGEX MATCH "^(.*):(.*)$" pair ${pair})
    if(NOT "${materials_${CMAKE_MATCH_2}}" STREQUAL "")
      list(APPEND arguments "--${CMAKE_MATCH_1}=${materials_${CMAKE_MATCH_2}}")
    endif()
  endforeach()

  # An unchanged manifest keeps its time, so that its dependents are not rebuilt; the stamp is
  # always updated.
  list(LENGTH materials_SOURCES count)
  add_custom_command(OUTPUT ${work}/stamp BYPRODUCTS ${output}/manifest.json
    COMMAND matc::compiler -d "${output}" ${arguments} ${materials_OPTIONS} -MD -MF ${work}/depfile -MT ${work}/stamp
      @${work}/sources.txt
    COMMAND ${CMAKE_COMMAND} -E touch ${work}/stamp
    DEPENDS ${inputs} ${work}/sources.txt matc::compiler $<TARGET_FILE:matc::compiler>
    DEPFILE ${work}/depfile
    COMMENT "Compiling materials: ${target}, of ${count} files" VERBATIM)
  add_custom_target(${target} ALL DEPENDS ${work}/stamp)
  set_target_properties(${target} PROPERTIES MATC_OUTPUT "${output}" MATC_MANIFEST "${output}/manifest.json"
    ADDITIONAL_CLEAN_FILES "${output};${work}/stamp")
endfunction()
cmake_policy(POP)
