# What every program that plays a game is linked with on the web and on Windows.
set(PLUMB_GAME_RESOURCES "" CACHE PATH "folder with game.rc: the icon and the version of the game, for Windows")
set(PLUMB_TARGETS ${PROJECT_SOURCE_DIR}/player/targets)

option(PLUMB_EXPORTED "build the players for exports, which do not contain the names of their targets" OFF)

# Gives player/main.cpp its own name: an export renames it. What is built for exports has none, and its file has the same
# name for every project: programs for Windows and scripts of pages contain it.
function(name_player program)
    if(PLUMB_EXPORTED)
        target_compile_definitions(${program} PRIVATE PLUMB_PLAYER="")
        set(folder ${CMAKE_BINARY_DIR}/exported/${program})
        set_target_properties(${program} PROPERTIES OUTPUT_NAME player RUNTIME_OUTPUT_DIRECTORY ${folder}
            ARCHIVE_OUTPUT_DIRECTORY ${folder})
    else()
        target_compile_definitions(${program} PRIVATE PLUMB_PLAYER="${program}")
    endif()
endfunction()

function(finish_player program)
    if(EMSCRIPTEN)
        # The page (player/targets/web) loads what this makes. SDL calls functions of JavaScript, which are named in a
        # file, because shells would replace their $.
        target_link_options(${program} PRIVATE -sUSE_SDL=0 -sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2
            -sALLOW_MEMORY_GROWTH=1 -sINITIAL_MEMORY=64MB -sTOTAL_STACK=1MB -sFORCE_FILESYSTEM=1
            -sENVIRONMENT=web,node -sEXPORTED_RUNTIME_METHODS=FS,callMain
            -sDEFAULT_LIBRARY_FUNCS_TO_INCLUDE=@${PLUMB_TARGETS}/web/library_functions.json)
    elseif(MINGW)
        enable_language(RC)
        target_sources(${program} PRIVATE ${PLUMB_TARGETS}/windows/player.rc)
        if(PLUMB_GAME_RESOURCES)
            target_sources(${program} PRIVATE ${PLUMB_GAME_RESOURCES}/game.rc)
            set_source_files_properties(${PLUMB_GAME_RESOURCES}/game.rc PROPERTIES
                INCLUDE_DIRECTORIES ${PLUMB_GAME_RESOURCES})
        endif()
        # Without a console window: what it prints is seen if it is started in a console.
        target_link_options(${program} PRIVATE -mwindows)
    endif()
endfunction()
