# The package is its headers: a target without files to compile. The second target compiles what does not depend on the
# type of the mesh once, for projects with many programs.
get_filename_component(SURFACE_MESH_CUT_LOCUS_ROOT ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)

add_library(Surface_mesh_cut_locus INTERFACE)
add_library(CGAL::Surface_mesh_cut_locus ALIAS Surface_mesh_cut_locus)
# include_np adds the package's named parameters to CGAL's list and must come before CGAL's own headers. It is installed
# apart, so that it never overwrites CGAL's file. In CGAL's tree it does not exist.
if(EXISTS ${SURFACE_MESH_CUT_LOCUS_ROOT}/include_np)
  target_include_directories(Surface_mesh_cut_locus INTERFACE
    $<BUILD_INTERFACE:${SURFACE_MESH_CUT_LOCUS_ROOT}/include_np>)
endif()
target_include_directories(Surface_mesh_cut_locus INTERFACE
  $<BUILD_INTERFACE:${SURFACE_MESH_CUT_LOCUS_ROOT}/include>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/Surface_mesh_cut_locus/named_parameters>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(Surface_mesh_cut_locus INTERFACE CGAL::CGAL CGAL::Eigen3_support)
target_compile_features(Surface_mesh_cut_locus INTERFACE cxx_std_17)

include(${CMAKE_CURRENT_LIST_DIR}/Surface_mesh_cut_locus_sources.cmake)
add_library(Surface_mesh_cut_locus_compiled STATIC EXCLUDE_FROM_ALL ${SURFACE_MESH_CUT_LOCUS_SOURCES})
add_library(CGAL::Surface_mesh_cut_locus_compiled ALIAS Surface_mesh_cut_locus_compiled)
target_link_libraries(Surface_mesh_cut_locus_compiled PUBLIC Surface_mesh_cut_locus)
target_compile_definitions(Surface_mesh_cut_locus_compiled PUBLIC CGAL_CUT_LOCI_SEPARATE_COMPILATION)
# it may become a part of a shared library
set_target_properties(Surface_mesh_cut_locus_compiled PROPERTIES POSITION_INDEPENDENT_CODE ON)
