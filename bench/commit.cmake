# Writes FILE, the definition of isect::bench::commit for the sources in ROOT; not touched where it would be the same.
# What a report is published as does not make the sources dirty: no program that measures reads it.
set(commit "")
if(EXISTS ${ROOT}/.git)
  find_program(git git)
  if(git)
    execute_process(COMMAND ${git} -C ${ROOT} rev-parse --short=12 HEAD OUTPUT_VARIABLE commit ERROR_QUIET
      OUTPUT_STRIP_TRAILING_WHITESPACE)
    execute_process(
      COMMAND ${git} -C ${ROOT} status --porcelain -- . :!bench/REPORT.md :!bench/report :!bench/results.json
      OUTPUT_VARIABLE changed ERROR_QUIET)
    if(commit AND changed)
      string(APPEND commit "-dirty")
    endif()
  endif()
endif()
set(text "#include \"bench/commit.h\"\n\nnamespace isect::bench {\nconst char* const commit = \"${commit}\";\n}\n")
set(old "")
if(EXISTS ${FILE})
  file(READ ${FILE} old)
endif()
if(NOT old STREQUAL text)
  file(WRITE ${FILE} "${text}")
endif()
