# Surface_mesh_cut_locus compiles what does not depend on the type of the mesh once. With Surface_mesh_cut_locus_header_only,
# which has no files to compile, each file that includes the headers does.
get_filename_component(SURFACE_MESH_CUT_LOCUS_ROOT ${CMAKE_CURRENT_LIST_DIR} DIRECTORY)

add_library(Surface_mesh_cut_locus_header_only INTERFACE)
add_library(CGAL::Surface_mesh_cut_locus_header_only ALIAS Surface_mesh_cut_locus_header_only)
# include_np adds the package's named parameters to CGAL's list and must come before CGAL's own headers. It is installed
# apart, so that it never overwrites CGAL's file. In CGAL's tree it does not exist.
if(EXISTS ${SURFACE_MESH_CUT_LOCUS_ROOT}/include_np)
  target_include_directories(Surface_mesh_cut_locus_header_only INTERFACE
    $<BUILD_INTERFACE:${SURFACE_MESH_CUT_LOCUS_ROOT}/include_np>)
endif()
target_include_directories(Surface_mesh_cut_locus_header_only INTERFACE
  $<BUILD_INTERFACE:${SURFACE_MESH_CUT_LOCUS_ROOT}/include>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/Surface_mesh_cut_locus/named_parameters>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(Surface_mesh_cut_locus_header_only INTERFACE CGAL::CGAL CGAL::Eigen3_support)
target_compile_features(Surface_mesh_cut_locus_header_only INTERFACE cxx_std_17)

include(${CMAKE_CURRENT_LIST_DIR}/Surface_mesh_cut_locus_sources.cmake)
add_library(Surface_mesh_cut_locus STATIC EXCLUDE_FROM_ALL ${SURFACE_MESH_CUT_LOCUS_SOURCES})
add_library(CGAL::Surface_mesh_cut_locus ALIAS Surface_mesh_cut_locus)
target_link_libraries(Surface_mesh_cut_locus PUBLIC Surface_mesh_cut_locus_header_only)
target_compile_definitions(Surface_mesh_cut_locus PUBLIC CGAL_CUT_LOCI_SEPARATE_COMPILATION)
# it may become a part of a shared library
set_target_properties(Surface_mesh_cut_locus PROPERTIES POSITION_INDEPENDENT_CODE ON)
