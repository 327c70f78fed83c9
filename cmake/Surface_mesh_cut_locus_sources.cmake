# What CGAL_CUT_LOCI_SEPARATE_COMPILATION leaves out of the headers, as files to compile.
set(SURFACE_MESH_CUT_LOCUS_SOURCES)
foreach(header geodesics/Exact_geodesic_propagation_impl.h face_graph/make_exact_tree_solver_impl.h
        face_graph/make_laplacian_solver_impl.h)
  get_filename_component(name ${header} NAME_WE)
  set(impl_source ${CMAKE_CURRENT_BINARY_DIR}/compiled/${name}.cpp)
  file(GENERATE OUTPUT ${impl_source} CONTENT "#include <CGAL/Cut_loci/${header}>\n")
  set_source_files_properties(${impl_source} PROPERTIES GENERATED ON)
  list(APPEND SURFACE_MESH_CUT_LOCUS_SOURCES ${impl_source})
endforeach()
