# For the folders that can be configured by themselves (examples, test, benchmark, demo), as in CGAL's source tree, where
# each is a project: finds what the package needs and declares its target, unless the package's own project has done so.
if(TARGET CGAL::Surface_mesh_cut_locus)
  return()
endif()

find_package(CGAL 5.5 REQUIRED)
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
include(CGAL_Eigen3_support)
include(${CMAKE_CURRENT_LIST_DIR}/Surface_mesh_cut_locus_target.cmake)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "" FORCE)
endif()
enable_testing()
