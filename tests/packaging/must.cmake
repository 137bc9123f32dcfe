# must(WORDS...)   runs a command, in the folder `work` if that is set; sets `said`
function(must)
  if(NOT work)
    set(work ${CMAKE_CURRENT_SOURCE_DIR})
  endif()
  execute_process(COMMAND ${ARGV} WORKING_DIRECTORY ${work}
    RESULT_VARIABLE status OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\n${text}")
  endif()
  set(said "${text}" PARENT_SCOPE)
endfunction()
