# Every library the program stands on, all from Debian 12 (packages.txt).
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(GDAL CONFIG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
    find_package(embree 3.13 REQUIRED)
endif()
pkg_check_modules(RSVG REQUIRED IMPORTED_TARGET librsvg-2.0)
# Debian 12's CMake package of OpenColorIO names a folder that does not exist; its .pc is right.
pkg_check_modules(OCIO REQUIRED IMPORTED_TARGET OpenColorIO)
# Its CMake package complains, at length, about parts of Imath that nobody here uses.
pkg_check_modules(OIIO REQUIRED IMPORTED_TARGET OpenImageIO)
add_library(OpenImageIO::OpenImageIO ALIAS PkgConfig::OIIO)
pkg_check_modules(XXHASH REQUIRED IMPORTED_TARGET libxxhash)

# Debian's libopencv-core-dev and -imgproc-dev come without the CMake package of the whole of OpenCV.
find_path(OPENCV_INCLUDE opencv2/imgproc.hpp PATH_SUFFIXES opencv4 REQUIRED)
find_library(OPENCV_CORE opencv_core REQUIRED)
find_library(OPENCV_IMGPROC opencv_imgproc REQUIRED)
add_library(cydonia_opencv INTERFACE)
target_include_directories(cydonia_opencv SYSTEM INTERFACE ${OPENCV_INCLUDE})
target_link_libraries(cydonia_opencv INTERFACE ${OPENCV_IMGPROC} ${OPENCV_CORE})
