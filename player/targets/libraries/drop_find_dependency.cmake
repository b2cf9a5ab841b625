# Removes the requests for libraries that are not linked from a package file.
file(READ ${FILE} text)
string(REGEX REPLACE "find_dependency\\((JPEG|PNG)[^)]*\\)" "" text "${text}")
file(WRITE ${FILE} "${text}")
