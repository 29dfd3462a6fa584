# What is installed as it is: the page, examples, documents. In share/doc they lie to each other as in the repository, so that their
# links hold.

# The page of the service and the page without one, if they are built (make web, make static).
install(DIRECTORY ${CMAKE_SOURCE_DIR}/build/web ${CMAKE_SOURCE_DIR}/build/static
        DESTINATION ${CMAKE_INSTALL_DATADIR}/coapt COMPONENT web OPTIONAL)

install(DIRECTORY ${CMAKE_SOURCE_DIR}/examples DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT examples
        USE_SOURCE_PERMISSIONS PATTERN "__pycache__" EXCLUDE)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/clients/python/notebooks DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples/python
        COMPONENT examples)

install(FILES ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/ARCHITECTURE.md ${CMAKE_SOURCE_DIR}/CHANGELOG.md
              ${CMAKE_SOURCE_DIR}/CONTRIBUTING.md ${CMAKE_SOURCE_DIR}/LICENSE ${CMAKE_SOURCE_DIR}/SECURITY.md
              ${CMAKE_SOURCE_DIR}/SUPPORT.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documents
        FILES_MATCHING PATTERN "*.md" PATTERN "*.png" PATTERN "*.svg" PATTERN "*.csv" PATTERN "*.json"
        PATTERN "man" EXCLUDE)
# The site of documents, if it is built (make docs).
install(DIRECTORY ${CMAKE_SOURCE_DIR}/build/docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/html COMPONENT documents OPTIONAL)
