# cut_locus_precompile(NAME HEADER...) makes a target that compiles CGAL's headers once for all that is compiled with the
# same options; cut_locus_use_precompiled(TARGET NAME) takes them. Without them all compiles as well, only longer: files
# include what they use. The package's own headers are not among them, since they change.
# Examples and tests have CUT_LOCUS_TRIAL_OPTIONS, and the headers of cut_locus_precompile_for_trials().
set(CUT_LOCUS_PRECOMPILED_HEADERS
    <CGAL/Exact_predicates_inexact_constructions_kernel.h> <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
    <CGAL/Polygon_mesh_processing/orientation.h> <CGAL/Simple_cartesian.h> <CGAL/Surface_mesh.h>
    <CGAL/boost/graph/IO/polygon_mesh_io.h> <CGAL/boost/graph/helpers.h> <boost/graph/adjacency_list.hpp>)

function(cut_locus_precompile name)
  if(TARGET ${name})
    return()
  endif()
  set(source ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  file(GENERATE OUTPUT ${source} CONTENT "// for the headers that are compiled before\n")
  set_source_files_properties(${source} PROPERTIES GENERATED ON)
  add_library(${name} OBJECT EXCLUDE_FROM_ALL ${source})
  target_link_libraries(${name} PRIVATE CGAL::Surface_mesh_cut_locus)
  if(TARGET CGAL::TBB_support)
    target_link_libraries(${name} PRIVATE CGAL::TBB_support)
  endif()
  target_precompile_headers(${name} PRIVATE ${CUT_LOCUS_PRECOMPILED_HEADERS} ${ARGN})
  # as all that take them: what -Wpedantic defines must be the same; and ccache looks at what was precompiled
  target_compile_options(${name} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang>:-Wpedantic>
                                         $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
endfunction()

# -O1: what is tried are results, and it compiles in two thirds of the time
set(CUT_LOCUS_TRIAL_OPTIONS $<$<CXX_COMPILER_ID:GNU,Clang>:-O1 -Wall -Wextra -Wpedantic -Wshadow>)

function(cut_locus_precompile_for_trials)
  if(NOT TARGET trial_headers)
    cut_locus_precompile(trial_headers)
    target_compile_options(trial_headers PRIVATE ${CUT_LOCUS_TRIAL_OPTIONS})
  endif()
endfunction()

function(cut_locus_use_precompiled target name)
  target_precompile_headers(${target} REUSE_FROM ${name})
  target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang>:-Wpedantic>
                                           $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
  if(TARGET CGAL::TBB_support)
    target_link_libraries(${target} PRIVATE CGAL::TBB_support)
  endif()
endfunction()
