# The meshes that tests, benchmarks and generate_mesh share, compiled once; who links them finds all headers of helpers.
if(TARGET cut_locus_test_meshes)
  return()
endif()
get_filename_component(helpers ${CMAKE_CURRENT_LIST_DIR}/../helpers/Surface_mesh_cut_locus ABSOLUTE)
add_library(cut_locus_test_meshes STATIC EXCLUDE_FROM_ALL ${helpers}/changed_meshes.cpp ${helpers}/mesh_files.cpp
            ${helpers}/meshes_by_cgal.cpp ${helpers}/polyhedra.cpp ${helpers}/smooth_surfaces.cpp)
target_include_directories(cut_locus_test_meshes PUBLIC ${helpers})
target_link_libraries(cut_locus_test_meshes PRIVATE CGAL::Surface_mesh_cut_locus_header_only) # test_bare_headers must not get all of it
target_compile_options(cut_locus_test_meshes PRIVATE
                       $<$<CXX_COMPILER_ID:GNU,Clang>:-O1 -Wall -Wextra -Wpedantic -Wshadow>)
