cmake_minimum_required(VERSION 3.22)

# Checks that the code of a project has one PLUMB_MODULE, at the beginning of a line. What linkers report for none or
# two names neither the files nor the remedy. The error is a line like those of compilers, which the editor finds.
#
#   cmake -D FOLDER=… "-D FILES=…/a.cpp;…/b.cpp" -D STAMP=FILE -P check_module.cmake     writes STAMP if there is one

# Comments, and texts, which may contain what looks like the begin of a comment.
set(comment "//[^\n]*|/\\*[^*]*\\*+([^/*][^*]*\\*+)*/|\"[^\"\\\\\n]*(\\\\.[^\"\\\\\n]*)*\"")
set(places "")
foreach(file IN LISTS FILES)
    file(READ "${file}" text)
    string(REGEX REPLACE "${comment}" "" text "\n${text}")
    string(REGEX MATCHALL "\n[ \t]*PLUMB_MODULE[ \t]*\\(" found "${text}")
    file(RELATIVE_PATH name "${FOLDER}" "${file}")
    foreach(one IN LISTS found)
        list(APPEND places "${name}")
    endforeach()
endforeach()

list(LENGTH places count)
if(count EQUAL 1)
    file(WRITE "${STAMP}" "${places}\n")
    return()
endif()
if(count EQUAL 0)
    message("${FOLDER}: error: no .cpp file contains PLUMB_MODULE; write PLUMB_MODULE(module) { module.components<...>(); } "
            "in one of them")
else()
    list(JOIN places ", " places)
    message("${FOLDER}: error: there are ${count} PLUMB_MODULE, in ${places}; keep one, and move what the others contain "
            "into it")
endif()
message(FATAL_ERROR "the code of a project has one PLUMB_MODULE")
