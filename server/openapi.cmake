# Sets COAPT_OPENAPI to server/openapi.json with the schemas of io/schema in it where it refers to their files, so
# that it stands alone. As a script, cmake -D OUTPUT=FILE -P openapi.cmake, writes it to FILE.
#
# The "$defs" of a schema, which must stand last in it and be laid out as they are now, become components: Valve.point
# is "point" of valve.schema.json.
set(COAPT_OPENAPI_SOURCES ${CMAKE_CURRENT_LIST_DIR}/openapi.json)
file(READ ${CMAKE_CURRENT_LIST_DIR}/openapi.json COAPT_OPENAPI)
foreach(component Valve Plan Search)
  string(TOLOWER ${component}.schema.json file)
  list(APPEND COAPT_OPENAPI_SOURCES ${CMAKE_CURRENT_LIST_DIR}/../io/schema/${file})
  file(READ ${CMAKE_CURRENT_LIST_DIR}/../io/schema/${file} text)
  string(FIND "${text}" ",\n  \"$defs\": {" end)
  string(SUBSTRING "${text}" 0 ${end} schema)
  string(SUBSTRING "${text}" ${end} -1 defs)
  string(REGEX REPLACE "\n  \"[$](schema|id)\": \"[^\"]*\"," "" schema "${schema}")
  string(REGEX REPLACE "^,\n  \"[$]defs\": {(.*)\n  }\n}\n$" "\\1" defs "${defs}")
  string(REGEX REPLACE "\n    \"([a-z_]+)\": {" "\n    \"${component}.\\1\": {" defs "${defs}")
  string(REPLACE "\n" "\n      " schema "${schema}\n}")
  string(REPLACE "\n" "\n  " defs "${defs}")
  set(text "${schema},${defs}")
  string(REPLACE "\"#/$defs/" "\"#/components/schemas/${component}." text "${text}")
  string(REPLACE "\"../plan/1#/$defs/" "\"#/components/schemas/Plan." text "${text}")
  string(REPLACE "\"../plan/1#/" "\"#/components/schemas/Plan/" text "${text}")
  string(REPLACE "{\"$ref\": \"../io/schema/${file}\"}" "${text}" COAPT_OPENAPI "${COAPT_OPENAPI}")
endforeach()

if(CMAKE_SCRIPT_MODE_FILE)
  file(WRITE ${OUTPUT} "${COAPT_OPENAPI}")
endif()
