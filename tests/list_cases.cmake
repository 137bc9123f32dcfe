# Lists the cases of a test program for ctest, each as "<ring>/<unit>: <case>", after the program is built. Catch2's own
# way differs between its versions 2 and 3.
#   cmake -D PROGRAM=test_core -D RING=core "-D UNITS=fit many/motion" -D CATCH2=3.7.1 "-D PROPERTIES=ENVIRONMENT A=b"
#     -D OUT=file -P list_cases.cmake
set(names_only --list-test-names-only)
if(CATCH2 VERSION_GREATER_EQUAL 3)
  set(names_only --list-tests --verbosity quiet)
endif()
set(listed "")
separate_arguments(UNITS)
foreach(path IN LISTS UNITS)
  get_filename_component(unit ${path} NAME)
  execute_process(COMMAND ${PROGRAM} -\# "[#${unit}_test]~[.]" ${names_only} OUTPUT_VARIABLE output ERROR_VARIABLE said)
  if(output MATCHES ";")
    message(FATAL_ERROR "a case of ${unit} has a ; in its name, which ctest takes for two:\n${output}")
  endif()
  string(REGEX MATCHALL "[^\n]+" cases "${output}")
  if(NOT cases)
    message(FATAL_ERROR "${PROGRAM} lists no case of ${unit}:\n${output}${said}")
  endif()
  foreach(case IN LISTS cases)
    string(STRIP "${case}" case)
    string(REGEX REPLACE "([\\\\,[])" "\\\\\\1" spec "${case}")  # as Catch2 reads names
    string(APPEND listed "add_test([==[${RING}/${unit}: ${case}]==] [==[${PROGRAM}]==] [==[${spec}]==])\n"
      "set_tests_properties([==[${RING}/${unit}: ${case}]==] PROPERTIES ${PROPERTIES})\n")
  endforeach()
endforeach()
file(WRITE ${OUT} "${listed}")
