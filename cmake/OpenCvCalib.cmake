# OpenCV's calib3d alone, for devices/camera/pose_solver.cpp. Debian's OpenCVConfig.cmake comes only with
# libopencv-dev, which brings every module.
find_path(FOVERIG_OPENCV_INCLUDE opencv2/calib3d.hpp PATH_SUFFIXES opencv4 REQUIRED)
find_library(FOVERIG_OPENCV_CALIB3D opencv_calib3d REQUIRED)
find_library(FOVERIG_OPENCV_CORE opencv_core REQUIRED)
mark_as_advanced(FOVERIG_OPENCV_INCLUDE FOVERIG_OPENCV_CALIB3D FOVERIG_OPENCV_CORE)
add_library(foverig_opencv_calib INTERFACE)
target_include_directories(foverig_opencv_calib SYSTEM INTERFACE ${FOVERIG_OPENCV_INCLUDE})
target_link_libraries(foverig_opencv_calib INTERFACE ${FOVERIG_OPENCV_CALIB3D} ${FOVERIG_OPENCV_CORE})
