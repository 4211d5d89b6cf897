# The header-only libraries, one folder of links to just the headers we use.
#
# Why not find_package: where they are installed in /usr/include it adds `-isystem /usr/include`, and the cross build then
# reads the host's C library headers. Where a library is not installed, its pinned release is fetched.
include(FetchContent)
include(mend_rapidjson)
include(mend_tinygltf)
set(TEXELCAST_DEPS_INCLUDE ${CMAKE_SOURCE_DIR}/build/deps/include)
set(TEXELCAST_INCLUDE_HINTS /usr/include /usr/local/include /opt/homebrew/include /opt/local/include)

# name: ours · probe: a header that shows it is installed · link: what to link, relative to the include folder
# folder: where the release keeps its include folder · repository, tag: the release to fetch
function(texelcast_provide name probe link folder repository tag)
    if(EXISTS ${TEXELCAST_DEPS_INCLUDE}/${probe})
        return()
    endif()
    find_path(TEXELCAST_${name}_INCLUDE ${probe} HINTS ${TEXELCAST_INCLUDE_HINTS} NO_CMAKE_FIND_ROOT_PATH)
    if(TEXELCAST_${name}_INCLUDE)
        set(include ${TEXELCAST_${name}_INCLUDE})
    else()
        message(STATUS "${name} is not installed: fetching ${repository} ${tag}")
        # A subfolder that is not there: the release is fetched, but its own CMake files, which would add targets and
        # options that header-only use does not need, are not run.
        # A commit's hash cannot be fetched shallowly.
        string(LENGTH ${tag} tag_length)
        set(shallow TRUE)
        if(tag_length EQUAL 40)
            set(shallow FALSE)
        endif()
        FetchContent_Declare(${name} GIT_REPOSITORY ${repository} GIT_TAG ${tag} GIT_SHALLOW ${shallow} GIT_SUBMODULES ""
                             SOURCE_DIR ${CMAKE_SOURCE_DIR}/build/deps/${name} SOURCE_SUBDIR headers_only)
        FetchContent_MakeAvailable(${name})
        set(include ${CMAKE_SOURCE_DIR}/build/deps/${name}/${folder})
    endif()
    get_filename_component(parent ${TEXELCAST_DEPS_INCLUDE}/${link} DIRECTORY)
    file(MAKE_DIRECTORY ${parent})
    if(IS_DIRECTORY ${include}/${link} AND CMAKE_HOST_WIN32)
        file(COPY ${include}/${link} DESTINATION ${parent}) # links need a privilege there
    else()
        file(CREATE_LINK ${include}/${link} ${TEXELCAST_DEPS_INCLUDE}/${link} COPY_ON_ERROR SYMBOLIC)
    endif()
endfunction()

# Adds the named libraries to a target's include path, as system headers.
function(texelcast_header_dependency target)
    foreach(name IN LISTS ARGN)
        if(name STREQUAL "glm")
            texelcast_provide(glm glm/glm.hpp glm . https://github.com/g-truc/glm.git 1.0.1)
        elseif(name STREQUAL "tinygltf")
            texelcast_provide(tinygltf tiny_gltf.h tiny_gltf.h . https://github.com/syoyo/tinygltf.git v2.9.3)
            texelcast_mend_tinygltf(${TEXELCAST_DEPS_INCLUDE}/tiny_gltf.h)
        elseif(name STREQUAL "rapidjson")
            # Its last release, 1.1.0 of 2016, is not C++20: a commit that package managers build.
            texelcast_provide(rapidjson rapidjson/document.h rapidjson include https://github.com/Tencent/rapidjson.git
                              24b5e7a8b27f42fa16b96fc70aade9106cf7102f)
            texelcast_mend_rapidjson(${TEXELCAST_DEPS_INCLUDE}/rapidjson)
        elseif(name STREQUAL "doctest")
            texelcast_provide(doctest doctest/doctest.h doctest . https://github.com/doctest/doctest.git v2.4.11)
        else()
            message(FATAL_ERROR "unknown header dependency ${name}")
        endif()
    endforeach()
    target_include_directories(${target} SYSTEM PUBLIC ${TEXELCAST_DEPS_INCLUDE})
endfunction()
