# How the sources are put together for the compiler. Most of a file's compile time goes
# into the headers that all files share, so these are precompiled once, and a few files of
# one folder make one translation unit. Names in anonymous namespaces of one folder must
# therefore differ. Figures: bench/build.sh.

# Few enough that a changed file is compiled again within seconds.
set(CYDONIA_FILES_A_UNIT 6 CACHE STRING
    "Source files of one folder in one translation unit; 1: each is its own")

# Gives the target a precompiled header, which holds the headers of ARGN too.
function(cydonia_precompiled target)
    target_precompile_headers(${target} PRIVATE ${PROJECT_SOURCE_DIR}/cmake/precompiled.h ${ARGN})
endfunction()

# Groups the target's sources by folder, in the order of its list.
function(cydonia_units target)
    if(CYDONIA_FILES_A_UNIT LESS 2)
        return()
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    get_target_property(sources ${target} SOURCES)
    foreach(source IN LISTS sources)
        cmake_path(GET source PARENT_PATH folder)
        string(MAKE_C_IDENTIFIER "in_${folder}" folder)
        set(group 0)
        if(DEFINED count_${folder})
            math(EXPR group "${count_${folder}} / ${CYDONIA_FILES_A_UNIT}")
            math(EXPR count_${folder} "${count_${folder}} + 1")
        else()
            set(count_${folder} 1)
        endif()
        set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${folder}_${group})
    endforeach()
endfunction()
