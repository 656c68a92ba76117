# The documentation as a site of static files: cmake --build build --target site writes build/site.
# docs/site.py copies docs/ and the pages of the target `reference`; mkdocs-material makes HTML.
find_program(MATC_MKDOCS mkdocs)
if(MATC_MKDOCS AND MATC_PYTHON3)
  add_custom_target(site
    COMMAND ${MATC_PYTHON3} docs/site.py prepare ${REFERENCE} ${PROJECT_BINARY_DIR}
    COMMAND ${MATC_MKDOCS} build --quiet --strict -f ${PROJECT_BINARY_DIR}/site.yml
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    COMMENT "Building the site: build/site/index.html" VERBATIM)
  add_dependencies(site reference)
else()
  add_custom_target(site
    COMMAND ${CMAKE_COMMAND} -E echo "The site needs mkdocs-material: ./setup site installs it"
    COMMAND ${CMAKE_COMMAND} -E false VERBATIM)
endif()
